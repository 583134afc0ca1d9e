// SPDX-License-Identifier: AGPL-3.0-or-later
//
// How the time to find discontinuity edges without rays grows with the number of polygons: one
// line for each scene and size, by stages, and the exponent of time over polygons. One thread; its
// own computing time is what counts.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <ctime>
#include <string>
#include <vector>

#include "core/polygonal/edge_finding.h"
#include "tests/core/polygonal/growth_scenes.h"

namespace povpreview {
namespace {

/// Seconds that this thread has computed for: other programs on the machine do not count.
double now() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

/// Times of one run, seconds.
struct Run {
    std::size_t pieces = 0;
    double all = 0;
    double first = 0;      ///< until the first pieces were there, building of hierarchies included
    double stage[4] = {};  ///< geometric, light 0, light 1, mirrors
};

std::size_t stage_of(const ImageEdge& piece) {
    switch (piece.kind) {
        case EdgeKind::geometric:
            return 0;
        case EdgeKind::shadow:
            return 1 + std::min<std::size_t>(piece.light, 1);
        default:
            return 3;
    }
}

Run time_once(const PolygonScene& scene, int mirror_depth) {
    Run run;
    const double start = now();
    double before = start;
    find_edges(scene, {.mirror_depth = mirror_depth},
               [&](std::vector<ImageEdge>&& pieces, std::uint64_t) {
                   // Calls without pieces, which only ask whether to go on, count to the next with
                   // some.
                   if (pieces.empty()) return true;
                   const double at = now();
                   if (run.pieces == 0) run.first = at - start;
                   run.stage[stage_of(pieces.back())] += at - before;
                   run.pieces += pieces.size();
                   before = at;
                   return true;
               });
    run.all = now() - start;
    return run;
}

Run median_run(const PolygonScene& scene, int mirror_depth, int repeat) {
    std::vector<Run> runs;
    for (int i = 0; i < repeat; ++i) runs.push_back(time_once(scene, mirror_depth));
    std::nth_element(runs.begin(), runs.begin() + repeat / 2, runs.end(),
                     [](const Run& a, const Run& b) { return a.all < b.all; });
    return runs[std::size_t(repeat) / 2];
}

/// Least squares of log(time) over log(polygons).
double exponent(const std::vector<std::pair<double, double>>& points) {
    double n = double(points.size()), sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (const auto& [polygons, seconds] : points) {
        const double x = std::log(polygons), y = std::log(seconds);
        sx += x, sy += y, sxx += x * x, sxy += x * y;
    }
    return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

template <class Make>
void grow(const std::string& name, std::size_t most, int mirror_depth, int repeat, Make make) {
    fmt::print("{:<12} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9}\n", name, "polygons",
               "pieces", "all ms", "first ms", "geometry", "light 0", "light 1", "mirrors");
    std::vector<std::pair<double, double>> all, large;
    const auto next = [](std::size_t size) {  // 100, 300, 1000, 3000 ...
        return std::to_string(size)[0] == '1' ? 3 * size : size / 3 * 10;
    };
    for (std::size_t size = 100; size <= most; size = next(size)) {
        const PolygonScene scene = make(size);
        const Run run = median_run(scene, mirror_depth, repeat);
        fmt::print("{:<12} {:>9} {:>9} {:>9.2f} {:>9.2f} {:>9.2f} {:>9.2f} {:>9.2f} {:>9.2f}\n", "",
                   scene.faces.size(), run.pieces, 1e3 * run.all, 1e3 * run.first,
                   1e3 * run.stage[0], 1e3 * run.stage[1], 1e3 * run.stage[2], 1e3 * run.stage[3]);
        std::fflush(stdout);
        all.emplace_back(scene.faces.size(), run.all);
        if (size >= 1000) large.push_back(all.back());
    }
    if (all.size() > 1) fmt::print("{:<12} time grows by the power {:.2f}", "", exponent(all));
    if (large.size() > 1) fmt::print("; from 1000 polygons on {:.2f}", exponent(large));
    fmt::print("\n");
}

}  // namespace
}  // namespace povpreview

int main(int argc, char** argv) {
    using namespace povpreview;
    CLI::App app("Growth of the time to find discontinuity edges without rays");
    std::size_t most = 100000;
    int repeat = 3, mirror_depth = 1;
    app.add_option("--max", most, "Most polygons")->check(CLI::PositiveNumber);
    app.add_option("--repeat", repeat, "Runs for each size; the median counts")
        ->check(CLI::PositiveNumber);
    app.add_option("--mirror-depth", mirror_depth, "Reflections of reflections followed");
    CLI11_PARSE(app, argc, argv);
    grow("office", most, mirror_depth, repeat, office_of);
    grow("hills, flat", most, mirror_depth, repeat,
         [](std::size_t polygons) { return hills_of(polygons, false); });
    grow("hills, smooth", most, mirror_depth, repeat,
         [](std::size_t polygons) { return hills_of(polygons, true); });
    grow("ball, smooth", most, mirror_depth, repeat, ball_of);
    return 0;
}
