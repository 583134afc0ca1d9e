// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/program/traced_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <thread>

#include "adapter/straight_camera.h"
#include "core/give_way.h"
#include "display/program/tracer_program.h"

namespace povpreview {

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
        case report::Stage::finishing:
            stage = "making POV-Ray's image, pixels";
            break;
    }
    if (progress.total > 0)
        return fmt::format("{}, {} of {}", stage, progress.done, progress.total);
    return progress.done > 0 ? fmt::format("{}, {}", stage, progress.done) : stage;
}

namespace {

PovrayOracle::Settings settings(const PovrayOptions& povray, const TracerWishes& wishes,
                                bool geometry) {
    PovrayOracle::Settings result;
    result.program = tracer_program();
    result.arguments = povray.tracer_arguments({.finish = !wishes.finish_folder.empty()});
    result.geometry = geometry;
    result.finish_folder = wishes.finish_folder;
    result.writes = wishes.writes;
    result.sandbox = SandboxRules{povray.readable, {}, wishes.memory};
    if (!wishes.finish_folder.empty()) result.sandbox->writable.push_back(wishes.finish_folder);
    if (wishes.writes)
        for (const auto& folder : {std::filesystem::current_path(),
                                   std::filesystem::absolute(povray.scene).parent_path()})
            result.sandbox->writable.push_back(folder);
    result.stall_timeout =
        std::chrono::milliseconds(static_cast<std::int64_t>(wishes.stall_timeout_s * 1000));
    return result;
}

/// "3 x sphere (curved), 1 x difference (too many faces)", or "nothing".
std::string left_out(const Geometry& geometry) {
    std::vector<std::string> parts;
    for (const Geometry::LeftOut& some : geometry.left_out)
        parts.push_back(fmt::format("{} x {} ({})", some.count, some.kind, some.reason));
    return parts.empty() ? "nothing" : fmt::format("{}", fmt::join(parts, ", "));
}

/// "of the pixels 99.9 % known: 70 % of one colour ...".
std::string known_pixels(const DrawnDetail& items) {
    const auto of = [&](Look::Kind kind) { return items.pixels(kind); };
    const std::size_t images = of(Look::Kind::image) + of(Look::Kind::pattern),
                      coloured = of(Look::Kind::plain) + images + of(Look::Kind::traced),
                      all = coloured + of(Look::Kind::mixed), known = items.surfaces();
    const auto share = [&](std::size_t count) {
        return 100. * double(count) / double(std::max<std::size_t>(1, all));
    };
    return fmt::format(
        "of the pixels {:.2f} % known: {:.2f} % of one colour, {:.2f} % image maps and patterns, "
        "{:.2f} % textures to be traced, {:.2f} % not told by their albedo",
        share(known), share(of(Look::Kind::plain)), share(images), share(of(Look::Kind::traced)),
        share(known) - share(coloured));
}

}  // namespace

Foreknowledge foreknowledge_for(const MethodNeeds& needs, int mirror_depth) {
    Foreknowledge result;
    if (needs.edges) result.edges = EdgeFinding{.mirror_depth = mirror_depth};
    result.items = needs.items;
    return result;
}

TracedScene::TracedScene(const PovrayOptions& povray, const TracerWishes& wishes,
                         const std::function<void(const std::string&)>& report,
                         const std::function<bool()>& interrupted,
                         const Foreknowledge& foreknowledge)
    : oracle_(settings(povray, wishes, foreknowledge.edges || foreknowledge.items)),
      description_(oracle_.wait_for_scene(
          [&](const report::Progress& progress) { report(sentence(progress)); }, interrupted)),
      wants_items_(foreknowledge.items),
      edge_finding_(foreknowledge.edges) {
    parsed_ = Clock::now();
    wants_items_ =
        wants_items_ && std::int64_t{description_.width} * description_.height <= most_item_pixels;
}

ImageFrame TracedScene::frame(bool fixed_accuracy, bool by_cost) const {
    // More threads than there are processors for take turns.
    const unsigned threads =
        std::min(oracle_.tracer().threads, std::thread::hardware_concurrency());
    return {.width = description_.width,
            .height = description_.height,
            .sharp = description_.camera.blur_samples == 0,
            .by_cost = by_cost,
            .threads = std::max(1, static_cast<int>(threads)),
            .ladder = fixed_accuracy ? Ladder{} : description_.ladder};
}

std::optional<Rung> TracedScene::accuracy(const std::string& named) const {
    if (named.empty()) return std::nullopt;
    return rung_named(description_.ladder, named);
}

std::string TracedScene::preparation() const {
    return oracle_.target_ready() ? "" : sentence(oracle_.preparation());
}

/// Both searches begin with the scene as it can be drawn; that is made once, in a thread of its
/// own.
void TracedScene::take_geometry() {
    if (drawable_.valid() || !(edge_finding_ || wants_items_)) return;
    std::optional<Geometry> geometry = oracle_.take_geometry();
    if (!geometry) return;
    left_out_ = left_out(*geometry);
    has_images_ = !geometry->images.empty();
    const auto make = [geometry = std::move(*geometry), this]() -> ItemSearch::Scene {
        give_way();
        std::optional<DrawableScene> scene = drawable_scene(geometry, description_);
        if (!scene) return nullptr;
        return std::make_shared<const DrawableScene>(std::move(*scene));
    };
    drawable_ = std::async(std::launch::async, make).share();
}

/// The images on its surfaces come after all else; until then items are painted without.
void TracedScene::paint_items() {
    if (!drawable_.valid()) return;
    if (!item_search_)
        item_search_.emplace([scene = drawable_] { return scene.get(); }, has_images_);
    if (!has_images_) return;
    auto images = oracle_.take_images();
    if (!images) return;
    item_search_->add_images(
        [scene = drawable_, images = std::move(*images)]() -> ItemSearch::Scene {
            auto with_images = std::make_shared<DrawableScene>(*scene.get());
            with_images->images = images;
            return with_images;
        });
}

const std::vector<EdgeChain>& TracedScene::edges() {
    take_geometry();
    if (!edge_finding_ || !drawable_.valid()) return edges_;
    if (!edge_search_)
        edge_search_.emplace(
            [scene = drawable_]() -> std::optional<PolygonScene> {
                if (!scene.get()) return std::nullopt;
                return scene.get()->polygons;
            },
            *edge_finding_);
    std::vector<EdgeChain> chains = edge_search_->take();
    edges_.insert(edges_.end(), std::make_move_iterator(chains.begin()),
                  std::make_move_iterator(chains.end()));
    return edges_;
}

bool TracedScene::items_finished() {
    if (!wants_items_) return true;
    take_geometry();
    paint_items();
    return item_search_ && item_search_->finished();
}

const DrawnDetail* TracedScene::items() {
    items_finished();
    return item_search_ ? item_search_->items() : nullptr;
}

void TracedScene::release_edges() {
    if (--edge_claims_ > 0) return;
    edges_too_late_ = edge_finding_ && !(edge_search_ && edge_search_->finished());
    edge_finding_.reset();
    if (edges_too_late_) edge_search_.reset();
}

void TracedScene::wait_for_foreknowledge(const std::function<bool()>& interrupted) {
    constexpr std::chrono::milliseconds patience{50};
    if (!edge_finding_ && !wants_items_) return;
    oracle_.wait_for_geometry(interrupted);
    take_geometry();
    if (wants_items_ && has_images_) oracle_.wait_for_images(interrupted);
    while (!items_finished() && !interrupted()) item_search_->wait_for(patience);
    for (edges(); edge_search_ && !edge_search_->finished() && !interrupted(); edges())
        edge_search_->wait_for(patience);
    edges();
}

Stage TracedScene::item_stage() const {
    Stage stage{.name = "item buffer", .runs = item_search_.has_value(), .why = {}};
    stage.expected = 0;
    if (!wants_items_) {
        stage.why = "the method or the picture's size is without one";
    } else if (!item_search_) {
        stage.why = "the scene has not come yet";
    } else if (!item_search_->finished()) {
        const DrawnDetail* items = item_search_->items();
        stage.why = (items ? known_pixels(*items) + "; " : "") + "painting is not over";
    } else if (const DrawnDetail* items = item_search_->items()) {
        stage.why = known_pixels(*items);
        stage.own_s = item_search_->seconds();
    } else {
        stage.runs = false;
        stage.why = why_not_straight(description_.camera);
    }
    return stage;
}

void TracedScene::complete(Stage& edges) const {
    if (edges_too_late_) edges.why += "; refinement was over before all were found";
    if (!edge_search_ || !edge_search_->finished()) return;
    const EdgeSearch::Report& found = edge_search_->report();
    if (!found.scene) edges.why = why_not_straight(description_.camera);
    edges.runs = found.scene;
    edges.own_s = found.seconds;
}

std::optional<std::string> TracedScene::take_item_report() {
    if (items_reported_ || !items_finished() || !item_search_) return std::nullopt;
    items_reported_ = true;
    if (!item_search_->items()) return "no item buffer: " + why_not_straight(description_.camera);
    return fmt::format("item buffer drawn in {:.3f} s; {}", item_search_->seconds(),
                       known_pixels(*item_search_->items()));
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
        "{} chains of edges known without tracing, of {} pieces, from {} faces, after {:.3f} s{}; "
        "not polygonal: {}",
        found.chains, found.pieces, found.faces, found.seconds,
        found.all ? "" : ", when looking for more was given up: too many faces behind each other",
        left_out_);
}

}  // namespace povpreview
