// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/program/traced_scene.h"

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>

#include "adapter/straight_camera.h"

namespace povpreview {
namespace {

/// The patched POV-Ray: the environment variable POVPREVIEW_TRACER, or the set-up's link beside
/// this program.
std::string tracer_program() {
    namespace fs = std::filesystem;
    if (const char* named = std::getenv("POVPREVIEW_TRACER")) return named;
    const fs::path beside = fs::read_symlink("/proc/self/exe").parent_path() / "povpreview-tracer";
    if (!fs::exists(beside))
        throw Error(Exit::usage, "the tracer is not there", beside.string(),
                    "build it by ./run, or name it by the environment variable POVPREVIEW_TRACER");
    return beside.string();
}

std::string sentence(const report::Progress& progress) {
    const char* stage = "";
    switch (progress.stage) {
        case report::Stage::parsing:
            stage = "parsing";
            break;
        case report::Stage::bounding:
            stage = "bounding objects";
            break;
        case report::Stage::photons:
            stage = "shooting photons";
            break;
        case report::Stage::radiosity:
            stage = "radiosity pretrace";
            break;
        case report::Stage::ready:
            stage = "ready";
            break;
    }
    if (progress.total > 0)
        return fmt::format("{}, {} of {}", stage, progress.done, progress.total);
    return progress.done > 0 ? fmt::format("{}, {}", stage, progress.done) : stage;
}

PovrayOracle::Settings settings(std::vector<std::string> arguments, double stall_timeout_s,
                                bool geometry) {
    PovrayOracle::Settings result;
    result.program = tracer_program();
    result.arguments = std::move(arguments);
    result.geometry = geometry;
    result.stall_timeout =
        std::chrono::milliseconds(static_cast<std::int64_t>(stall_timeout_s * 1000));
    return result;
}

/// "3 x sphere (curved), 1 x difference (too many faces)", or "nothing".
std::string left_out(const Geometry& geometry) {
    std::vector<std::string> parts;
    for (const Geometry::LeftOut& some : geometry.left_out)
        parts.push_back(fmt::format("{} x {} ({})", some.count, some.kind, some.reason));
    return parts.empty() ? "nothing" : fmt::format("{}", fmt::join(parts, ", "));
}

}  // namespace

TracedScene::TracedScene(std::vector<std::string> povray_arguments, double stall_timeout_s,
                         const std::function<void(const std::string&)>& report,
                         const std::function<bool()>& interrupted,
                         const std::optional<EdgeFinding>& edges)
    : oracle_(settings(std::move(povray_arguments), stall_timeout_s, edges.has_value())),
      description_(oracle_.wait_for_scene(
          [&](const report::Progress& progress) { report(sentence(progress)); }, interrupted)),
      edge_finding_(edges) {
    parsed_ = Clock::now();
}

const std::vector<EdgeChain>& TracedScene::edges() {
    if (!edge_finding_) return edges_;
    if (!edge_search_) {
        std::optional<Geometry> geometry = oracle_.take_geometry();
        if (!geometry) return edges_;
        left_out_ = left_out(*geometry);
        edge_search_.emplace([geometry = std::move(*geometry),
                              this] { return polygon_scene(geometry, description_); },
                             *edge_finding_);
    }
    std::vector<EdgeChain> chains = edge_search_->take();
    edges_.insert(edges_.end(), std::make_move_iterator(chains.begin()),
                  std::make_move_iterator(chains.end()));
    return edges_;
}

void TracedScene::release_edges() {
    if (--edge_claims_ > 0) return;
    edges_too_late_ = edge_finding_ && !(edge_search_ && edge_search_->finished());
    edge_finding_.reset();
    if (edges_too_late_) edge_search_.reset();
}

void TracedScene::wait_for_edges(const std::function<bool()>& interrupted) {
    if (!edge_finding_) return;
    oracle_.wait_for_geometry(interrupted);
    for (edges(); !edge_search_->finished() && !interrupted(); edges())
        edge_search_->wait_for(std::chrono::milliseconds(50));
    edges();
}

std::optional<std::string> TracedScene::take_edge_report() {
    if (edges_reported_) return std::nullopt;
    if (edges_too_late_) {
        edges_reported_ = true;
        return "edges known without tracing would have come too late: refinement was over";
    }
    if (!edge_search_ || !edge_search_->finished()) return std::nullopt;
    edges_reported_ = true;
    const EdgeSearch::Report& found = edge_search_->report();
    if (!found.scene)
        return "no edges known without tracing: " + why_not_straight(description_.camera);
    return fmt::format(
        "{} chains of edges known without tracing, of {} pieces, from {} faces, after {:.3f} s; "
        "not polygonal: {}",
        found.chains, found.pieces, found.faces, found.seconds, left_out_);
}

}  // namespace povpreview
