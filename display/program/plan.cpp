// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/program/plan.h"

#include <fmt/format.h>

#include <cstdio>

#include "adapter/povray_options.h"
#include "display/program/interrupt.h"
#include "display/program/strategy_run.h"
#include "display/progress_line.h"

namespace povpreview {
namespace {

using namespace std::chrono_literals;

std::string head(const SceneDescription& scene) {
    const char* blur = scene.camera.blur_samples > 0 ? ", focal blur" : "";
    std::string features;
    for (const std::string& feature : scene.features) features += ", " + feature;
    return fmt::format("{} x {} pixels, {} light{}{}{}\n", scene.width, scene.height,
                       scene.lights.size(), scene.lights.size() == 1 ? "" : "s", blur, features);
}

}  // namespace

std::string plan_table(const std::vector<Stage>& stages, bool taken) {
    std::string table = fmt::format("{:<20} {:<9} {:>8}", "stage", "", "expected");
    if (taken) table += fmt::format(" {:>9} {:>9} {:>8}", "rays", "tracer s", "own s");
    table += "  why\n";
    for (const Stage& stage : stages) {
        const std::string expected =
            stage.expected ? fmt::format("{:.1f} %", 100 * *stage.expected) : "?";
        table += fmt::format("{:<20} {:<9} {:>8}", stage.name, stage.runs ? "runs" : "left out",
                             expected);
        if (taken)
            table +=
                fmt::format(" {:>9} {:>9.3f} {:>8.3f}", stage.rays, stage.tracer_s, stage.own_s);
        table += "  " + stage.why + "\n";
    }
    return table;
}

Exit plan(const PlanOptions& options) {
    ProgressLine line;
    TracedScene scene(
        read_povray_options(options.povray), options.tracer,
        [&](const std::string& what) { line.show(what); }, interrupted,
        foreknowledge_for(method_needs("mesh"), options.mirror_depth));
    StrategyRun run("mesh", scene, scene.oracle(), std::nullopt);
    // The first samples tell what rays cost, the item buffer what of the pixels is known.
    while (!interrupted() && run.advance(2ms) &&
           (run.stages().empty() || !scene.items_finished())) {
    }
    line.clear();
    fmt::print("{}{}", head(scene.description()), plan_table(run.stages(), false));
    if (!options.run) return interrupted() ? Exit::interrupted : Exit::success;
    std::fflush(stdout);
    while (!interrupted() && run.advance(2ms))
        line.show(fmt::format("{:.1f} s, {} samples", scene.time_s(), run.samples()));
    line.clear();
    fmt::print("\n{} after {:.3f} s\n{}", interrupted() ? "interrupted" : "complete",
               scene.time_s(), plan_table(run.stages(), true));
    return interrupted() ? Exit::interrupted : Exit::success;
}

}  // namespace povpreview
