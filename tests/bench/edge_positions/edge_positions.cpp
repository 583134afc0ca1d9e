// SPDX-License-Identifier: AGPL-3.0-or-later
//
// edge_positions --out DIR [--misses] [--mirror-depth N] SCENE.pov [POV-Ray options]
//
// Do the edges that are found without rays lie where the finished picture has its edges? Compares
// the chains of constraints with the strong jumps (see agreement.h) of renders by the stock povray
// four times as fine, a line for each kind of edge and one for all together.
//
// Kinds are told apart by POV-Ray's quality levels: +Q3 knows no shadows, +Q5 no reflections, +Q9
// all. Jumps that come in with a level and lie neither at a jump of the level below nor at a
// constraint of an earlier kind are the kind's own. A constraint is right where it is not off; idle
// ones (the very same ray tree on both sides, as probes tell) cost samples and show nothing.
// Textures draw edges of their own: leave them out (our scenes by Declare=Untextured=1).
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <cstdio>
#include <numeric>

#include "adapter/povray_options.h"
#include "adapter/povray_oracle.h"
#include "adapter/straight_camera.h"
#include "core/edge_chains.h"
#include "core/polygonal/edge_finding.h"
#include "display/image_file.h"
#include "display/program/folder.h"
#include "display/program/reference.h"
#include "tests/bench/edge_positions/agreement.h"
#include "tests/bench/edge_positions/misses.h"
#include "tests/end_to_end/real_tracer.h"

namespace povpreview {
namespace {

constexpr int scale = 4;

struct Options {
    std::filesystem::path out;
    bool misses = false;
    int mirror_depth = 1;
    std::vector<std::string> povray;
};

bool never() { return false; }

/// All constraints of a scene.
struct Constraints {
    glm::ivec2 size;
    std::vector<EdgeChain> chains;
    /// Of each chain, pixels of length with the very same ray tree on both sides.
    std::vector<double> idle;
};

/// What a ray from a point of the picture meets: surfaces and lights, also behind mirrors.
bool same_ray_tree(const Sample& a, const Sample& b) {
    return a.surface == b.surface && a.signature == b.signature;
}

/// Fills in Constraints::idle. A constraint may be off by its tolerance, so the sides are asked for
/// a little beyond that.
void find_idle(PovrayOracle& oracle, Constraints& constraints) {
    constexpr double step = .5, away = tolerance + .1;
    struct Place {
        std::size_t chain;
        double length;
    };
    std::vector<Place> places;
    std::vector<Request> requests;
    for (std::size_t i = 0; i < constraints.chains.size(); ++i)
        walk(constraints.chains[i], step, [&](glm::dvec2 p, glm::dvec2 along, double length) {
            const glm::dvec2 normal(-along.y, along.x);
            places.push_back({i, length});
            for (const double side : {-away, away})
                requests.push_back({p + side * normal, RayKind::probe});
        });
    oracle.submit(requests, Parts::surface | Parts::signature);
    std::vector<Sample> samples;
    while (samples.size() < requests.size()) oracle.collect(samples, std::chrono::seconds(1));
    constraints.idle.assign(constraints.chains.size(), 0);
    for (std::size_t k = 0; k < places.size(); ++k)
        if (same_ray_tree(samples[2 * k], samples[2 * k + 1]))
            constraints.idle[places[k].chain] += places[k].length;
}

Constraints find_constraints(const Options& options) {
    const PovrayOptions povray = read_povray_options(options.povray);
    PovrayOracle oracle({.program = real_tracer(), .arguments = povray.tracer_arguments()});
    const SceneDescription description = oracle.wait_for_scene(nullptr, never);
    oracle.wait_for_geometry(never);
    const Geometry geometry = oracle.take_geometry().value();
    const std::optional<PolygonScene> scene = polygon_scene(geometry, description);
    if (!scene)
        throw Error(Exit::scene, why_not_straight(description.camera), povray.scene.string(),
                    "choose a scene with a straight camera");
    for (const Geometry::LeftOut& left : geometry.left_out)
        fmt::print("{:<20} without {} x {}: {}\n", options.out.filename().string(), left.count,
                   left.kind, left.reason);
    Constraints result;
    result.size = {description.width, description.height};
    std::vector<ImageEdge> pieces;
    find_edges(*scene, {.mirror_depth = options.mirror_depth},
               [&](std::vector<ImageEdge>&& more, std::uint64_t) {
                   pieces.insert(pieces.end(), more.begin(), more.end());
                   return true;
               });
    result.chains = chain_edges(std::move(pieces), result.size);
    find_idle(oracle, result);
    return result;
}

/// A render by the stock povray of one quality level, and its jumps.
struct Level {
    Image fine;
    std::vector<glm::dvec2> jumps;
};

Level render(const Options& options, glm::ivec2 size, int quality) {
    std::vector<std::string> words = options.povray;
    words.push_back(fmt::format("+W{}", size.x * scale));
    words.push_back(fmt::format("+H{}", size.y * scale));
    words.push_back(fmt::format("+Q{}", quality));
    const std::filesystem::path folder = options.out / fmt::format("q{}", quality);
    make_folder(folder, "--out");
    Level level;
    level.fine = stock_reference(words, folder, never);
    level.jumps = strong_jumps(level.fine, scale);
    return level;
}

class Report {
   public:
    Report(const Options& options, const Constraints& constraints)
        : options_(options), constraints_(constraints), name_(options.out.filename().string()) {}

    void line(const std::string& kind, const JumpsFound& jumps, const ConstraintsPlaced& placed,
              double idle, const Image& fine) const {
        const double length = std::max(placed.length(), 1e-9);
        fmt::print(
            "{:<20} {:<11} {:8} {:7.2f} {:9.0f} {:7.2f} {:6.2f} {:6.2f} {:6.2f} {:6.2f} {:6.2f}\n",
            name_, kind, jumps.jumps, 100 * jumps.share(), placed.length(), 100 * placed.share(),
            100 * placed.on / length, 100 * placed.even / length, 100 * placed.beside / length,
            100 * placed.off / length, 100 * idle / length);
        std::fflush(stdout);
        if (options_.misses)
            write_image(picture_of_misses(fine, scale, constraints_.chains, jumps, placed),
                        options_.out / ("misses-" + kind + ".png"), FileFormat::png8);
    }

   private:
    const Options& options_;
    const Constraints& constraints_;
    std::string name_;
};

void measure(const Options& options) {
    make_folder(options.out, "--out");
    const Constraints constraints = find_constraints(options);
    const Report report(options, constraints);
    NearSegments all(constraints.size);
    for (const EdgeChain& chain : constraints.chains) all.add(chain);

    constexpr std::array kinds{EdgeKind::geometric, EdgeKind::shadow, EdgeKind::reflection};
    constexpr std::array names{"geometric", "shadow", "reflection"};
    constexpr std::array qualities{3, 5, 9};
    NearSegments earlier(constraints.size);
    Level level;
    for (std::size_t k = 0; k < kinds.size(); ++k) {
        const NearPoints before(level.jumps, constraints.size);
        level = render(options, constraints.size, qualities[k]);
        std::vector<EdgeChain> chains;
        NearSegments own(constraints.size);
        double idle = 0;
        for (std::size_t i = 0; i < constraints.chains.size(); ++i) {
            if (constraints.chains[i].kind != kinds[k]) continue;
            chains.push_back(constraints.chains[i]);
            own.add(chains.back());
            idle += constraints.idle[i];
        }
        const JumpsFound jumps = find_jumps(level.jumps, own, [&](glm::dvec2 p) {
            return !before.within(p, tolerance) && !earlier.within(p, tolerance);
        });
        report.line(names[k], jumps, place_constraints(chains, all, level.jumps, level.fine, scale),
                    idle, level.fine);
        for (const EdgeChain& chain : chains) earlier.add(chain);
    }
    report.line("all", find_jumps(level.jumps, all),
                place_constraints(constraints.chains, all, level.jumps, level.fine, scale),
                std::accumulate(constraints.idle.begin(), constraints.idle.end(), 0.), level.fine);
}

}  // namespace
}  // namespace povpreview

int main(int argc, char** argv) {
    using namespace povpreview;
    Options options;
    CLI::App app("Compares edges found without rays with those of a finer render.");
    app.add_option("--out", options.out, "Folder for renders and pictures; names the lines")
        ->required();
    app.add_flag("--misses", options.misses, "Draw what does not agree: misses-KIND.png");
    app.add_option("--mirror-depth", options.mirror_depth, "Reflections of reflections followed");
    app.allow_extras();
    CLI11_PARSE(app, argc, argv);
    options.povray = app.remaining();
    try {
        measure(options);
        return 0;
    } catch (const Error& error) {
        fmt::print(stderr, "edge_positions: {}\n", error.what());
        return static_cast<int>(error.exit());
    }
}
