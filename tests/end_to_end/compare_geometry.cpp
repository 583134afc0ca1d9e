// SPDX-License-Identifier: AGPL-3.0-or-later
//
// compare_geometry [-v] SCENE... : how the polygons and the curved pieces that the tracer exports
// agree with what its rays hit, a line a scene. Question: is the export exact on the scenes that
// people have, and how much of them is polygonal, or known at all? Try it on those of the package
// povray-examples. With -v also what was left out and why, and positions that do not agree.
//
//     on faces, disagree    probes on surfaces with faces; those where faces and probe disagree
//     known, curved         probes before which nothing unknown may lie; those that hit a piece
//     wrong                 of the known ones, where another surface was hit
#include <chrono>
#include <cstdio>
#include <cstring>

#include "adapter/povray_options.h"
#include "adapter/straight_camera.h"
#include "core/error.h"
#include "tests/end_to_end/drawable_agreement.h"
#include "tests/end_to_end/real_tracer.h"

namespace {

using namespace povpreview;
using Clock = std::chrono::steady_clock;

double milliseconds(Clock::time_point since) {
    return std::chrono::duration<double, std::milli>(Clock::now() - since).count();
}

/// About what polygons and pieces take on the wire.
double kibibytes(const Geometry& geometry) {
    return static_cast<double>(
               24 * (geometry.points.size() + geometry.polygons.size()) +
               104 * geometry.solids.size() + 16 * geometry.pieces.size() +
               56 * geometry.objects.size() + 48 * geometry.unknown.size() +
               4 * (geometry.corners.size() + geometry.rings.size() + geometry.conditions.size())) /
           1024;
}

struct Totals {
    int scenes = 0, agreeing = 0;
    std::size_t probes = 0, on_faces = 0, disagreeing = 0, at_edges = 0;
    std::size_t known = 0, curved = 0, wrong = 0, tied = 0, known_at_edges = 0;
    int all_known_right = 0;
};

void print_details(const Geometry& geometry, const GeometryAgreement& agreement,
                   const DrawableAgreement& drawable, const std::vector<Sample>& probes) {
    for (const Geometry::LeftOut& left : geometry.left_out)
        std::printf("        %u x %s: %s%s\n", left.count, left.kind.c_str(), left.reason.c_str(),
                    left.drawn ? " (in pieces)" : "");
    for (const DrawableAgreement::Example& example : drawable.examples)
        std::printf("        at (%.4f, %.4f): hit %08x at %g, but nearest is said %08x at %g\n",
                    example.position.x, example.position.y, example.hit, example.hit_depth,
                    example.said, example.said_depth);
    for (const GeometryAgreement::Example& example : agreement.examples) {
        const Sample& sample = probes[example.probe];
        std::printf("        at (%.4f, %.4f): hit %08x at %g, but the nearest face is %08x at %g\n",
                    sample.position.x, sample.position.y, sample.surface, sample.depth,
                    example.surface, example.depth);
    }
}

void compare(const std::filesystem::path& path, const char* name, bool verbose, Totals& totals) {
    std::filesystem::current_path(path.parent_path());  // scenes find their own files beside them
    const PovrayOptions options = read_povray_options({path, "+W160", "+H120", "+WT2"});
    PovrayOracle oracle({.program = real_tracer(), .arguments = options.tracer_arguments()});
    const SceneDescription description = oracle.wait_for_scene(nullptr, nullptr);
    const Clock::time_point start = Clock::now();
    oracle.wait_for_geometry([&] { return milliseconds(start) > 60000; });
    const double waited = milliseconds(start);
    const Geometry geometry = oracle.take_geometry().value();
    const Clock::time_point cutting = Clock::now();
    const std::optional<DrawableScene> scene = drawable_scene(geometry, description);
    const double cut = milliseconds(cutting);
    const PolygonScene* polygons = scene ? &scene->polygons : nullptr;
    if (!polygons) {
        std::printf("%8s %8s %8s %9s %9s %8s %8s %9s %8s %8s %8s  %s: %s\n", "-", "-", "-", "-",
                    "-", "-", "-", "-", "-", "-", "-", name,
                    why_not_straight(description.camera).c_str());
        return;
    }
    const std::vector<Sample> probes = probe(oracle, probing_positions(*polygons, 20000, 1));
    const GeometryAgreement agreement = compare_geometry(*polygons, probes);
    const DrawableAgreement drawable = compare_drawable(*scene, probes);
    std::size_t left_out = 0;
    for (const Geometry::LeftOut& left : geometry.left_out) left_out += left.count;
    std::printf("%8zu %8zu %8zu %8.2f%% %8.3f%% %7.2f%% %7.2f%% %8.4f%% %8.0f %8.1f %8.1f  %s\n",
                polygons->faces.size(), scene->pieces.size(), left_out,
                100. * static_cast<double>(agreement.on_faces) /
                    static_cast<double>(std::max<std::size_t>(1, agreement.probes)),
                100 * agreement.share(), 100 * drawable.known_share(),
                100 * DrawableAgreement::share(drawable.curved, drawable.probes),
                100 * drawable.wrong_share(), kibibytes(geometry), waited, cut, name);
    if (verbose) print_details(geometry, agreement, drawable, probes);
    ++totals.scenes;
    totals.agreeing += agreement.disagreeing() == 0;
    totals.probes += agreement.probes;
    totals.on_faces += agreement.on_faces;
    totals.disagreeing += agreement.disagreeing();
    totals.at_edges += agreement.at_edges;
    totals.known += drawable.known();
    totals.curved += drawable.curved;
    totals.wrong += drawable.wrong;
    totals.tied += drawable.tied;
    totals.known_at_edges += drawable.at_edges;
    totals.all_known_right += drawable.wrong == 0;
}

}  // namespace

int main(int argc, char** argv) {
    const std::filesystem::path start = std::filesystem::current_path();
    const bool verbose = argc > 1 && std::strcmp(argv[1], "-v") == 0;
    Totals totals;
    std::printf("%8s %8s %8s %9s %9s %8s %8s %9s %8s %8s %8s  scene\n", "faces", "pieces",
                "left out", "on faces", "disagree", "known", "curved", "wrong", "KiB", "came ms",
                "cut ms");
    for (int i = verbose ? 2 : 1; i < argc; ++i) {
        try {
            compare(start / argv[i], argv[i], verbose, totals);
        } catch (const Error& error) {
            std::printf("%36s  %s: %s\n", "-", argv[i], error.what());
        }
        std::fflush(stdout);
    }
    std::printf(
        "%d scenes, %d agree throughout; %zu probes, %zu on faces, %zu disagree (%.4f%%), "
        "%zu but for a hair\n",
        totals.scenes, totals.agreeing, totals.probes, totals.on_faces, totals.disagreeing,
        100. * static_cast<double>(totals.disagreeing) /
            static_cast<double>(std::max<std::size_t>(1, totals.probes)),
        totals.at_edges);
    const auto of_all = [&](std::size_t part) {
        return 100 * DrawableAgreement::share(part, totals.probes);
    };
    std::printf(
        "%.2f%% known, %.2f%% curved; of the known %.4f%% wrong, %.4f%% but for a hair, "
        "%.4f%% tied; nothing wrong in %d scenes\n",
        of_all(totals.known), of_all(totals.curved),
        100 * DrawableAgreement::share(totals.wrong, totals.known),
        100 * DrawableAgreement::share(totals.known_at_edges, totals.known),
        100 * DrawableAgreement::share(totals.tied, totals.known), totals.all_known_right);
    return totals.scenes > 0 ? 0 : 1;
}
