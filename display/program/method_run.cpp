// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/program/method_run.h"

#include <fmt/format.h>
#include <malloc.h>

#include <algorithm>
#include <cmath>

#include "adapter/povray_options.h"
#include "adapter/process_memory.h"
#include "adapter/render_state.h"
#include "adapter/stock_mosaic.h"
#include "core/colour.h"
#include "core/error_measures.h"
#include "core/pixel_canvas.h"
#include "display/program/interrupt.h"
#include "display/program/plan.h"
#include "display/program/recorded_previewer.h"
#include "display/program/schedule.h"
#include "display/program/strategy_run.h"

namespace povpreview {
namespace {

using namespace std::chrono_literals;

std::string name_of(int moment) {
    return fmt::format("{:02d}-{:.3f}s", moment, GeometricSchedule::time(moment));
}

void check_size(glm::ivec2 size, const Image& reference) {
    if (size != glm::ivec2(reference.width, reference.height))
        throw Error(Exit::usage,
                    fmt::format("the reference is {} x {} pixels, the tracer's picture {} x {}",
                                reference.width, reference.height, size.x, size.y),
                    "compare", "give the size by +W and +H");
}

/// Our own memory during a run: what has been added since its begin, without the record of it.
class OwnMemory {
   public:
    explicit OwnMemory(const Recording& recording) : recording_(recording) {
        malloc_trim(0);  // else a run is served from what the one before it freed
        at_begin_ = resident_memory();
    }
    std::size_t used() const {
        const std::size_t now = resident_memory(), others = at_begin_ + recording_.memory();
        return now > others ? now - others : 0;
    }

   private:
    const Recording& recording_;
    std::size_t at_begin_ = 0;
};

MethodRun run_ours(const std::string& method, const ComparedScene& compared,
                   const CompareOptions& options, ProgressLine& line) {
    Recording recording;
    const OwnMemory own(recording);
    TracedScene scene(
        read_povray_options(compared.words), options.tracer,
        [&](const std::string& text) { line.show(compared.name + ", " + method + ": " + text); },
        interrupted, foreknowledge_for(method_needs(method), options.mirror_depth));
    check_size({scene.description().width, scene.description().height}, compared.reference);
    StrategyRun run(method, scene, scene.oracle(), scene.accuracy(options.accuracy), true,
                    &recording);
    MethodRun result;
    std::size_t most_memory = 0;
    const auto note = [&](int number, const std::string& name) {
        recording.mark();
        const Standing standing = run.standing();
        most_memory = std::max(most_memory, own.used() + scene.oracle().peak_memory());
        result.moments.push_back({number, name, standing, most_memory, {}});
        line.show(fmt::format("{}, {}: {:.1f} s, {} samples", compared.name, method,
                              standing.time_s, standing.full));
    };
    GeometricSchedule schedule;
    bool going = true;
    while (going && !interrupted() && !(options.time && scene.time_s() >= *options.time)) {
        going = run.advance(2ms);
        if (run.samples() == 0) continue;
        if (const auto moment = schedule.due(scene.time_s())) note(*moment, name_of(*moment));
    }
    note(result.moments.empty() ? 0 : result.moments.back().number + 1, "end");
    result.complete = run.previewer().done();
    if (const std::vector<Stage> stages = run.stages(); !stages.empty())
        result.plan = plan_table(stages, true);
    for (const auto& report : {scene.take_item_report(), scene.take_edge_report()})
        if (report) result.notes.push_back(*report);
    for (const std::string& fault : scene.oracle().faults()) result.notes.push_back(fault);
    const std::unique_ptr<Previewer> again = run.fresh_previewer();
    recording.replay(
        *again, [&](std::size_t i) { result.moments[i].picture = again->picture(Overlay::none); });
    return result;
}

/// Working colours as linear light, as far as a curve is known by its exponent alone.
std::vector<glm::vec3> decoded(const std::vector<glm::vec3>& working, float gamma, bool srgb) {
    std::vector<glm::vec3> linear = working;
    for (glm::vec3& colour : linear)
        for (int c = 0; c < 3; ++c)
            if (colour[c] > 0)
                colour[c] = srgb ? decode_srgb(colour[c]) : std::pow(colour[c], gamma);
    return linear;
}

/// How the stock povray's working colours become linear light. The scene's exponent does not tell
/// 2.2 from sRGB's curve; the reference does.
struct WorkingGamma {
    float gamma;
    bool srgb;

    WorkingGamma(float exponent, const std::vector<glm::vec3>& last, const Image& reference)
        : gamma(exponent) {
        const auto error = [&](bool as_srgb) {
            return measure_error(decoded(last, gamma, as_srgb), reference.pixels).l1;
        };
        srgb = gamma != 1 && error(true) < error(false);
    }
    std::vector<glm::vec3> linear(const std::vector<glm::vec3>& working) const {
        return decoded(working, gamma, srgb);
    }
};

MethodRun run_stock(const ComparedScene& scene, const CompareOptions& options, ProgressLine& line) {
    const auto describe = [&] {
        TracedScene parsed(read_povray_options(scene.words), options.tracer,
                           [&](const std::string& text) { line.show(scene.name + ": " + text); },
                           interrupted, {});
        return std::pair(glm::ivec2(parsed.description().width, parsed.description().height),
                         parsed.description().working_gamma);
    };
    const auto [size, exponent] = describe();
    check_size(size, scene.reference);
    const StockMosaic stock = run_stock_mosaic(scene.words, scene.folder, [&](double time_s) {
        line.show(fmt::format("{}, {}: {:.1f} s", scene.name, stock_mosaic_name, time_s));
        return interrupted() || (options.time && time_s >= *options.time);
    });

    RenderState whole(size.x, size.y);
    whole.append(stock.state);
    const WorkingGamma light(exponent, whole.pixels(), scene.reference);
    MethodRun result;
    RenderState shown(size.x, size.y);
    std::size_t bytes = 0;
    const auto take = [&, &size = size](int number, const std::string& name, double time_s) {
        const std::size_t end = stock.bytes_at(time_s);
        shown.append(std::span(stock.state).subspan(bytes, end - bytes));
        bytes = end;
        if (shown.samples() == 0) return;
        Picture picture = PixelCanvas(size.x, size.y).picture();
        picture.pixels = light.linear(shown.pixels());
        Standing standing;
        standing.time_s = time_s;
        standing.launch_s = stock.parsed_s + time_s;
        standing.full = shown.samples();
        result.moments.push_back({number, name, standing, 0, std::move(picture)});
    };
    // What came after the end of the time given does not count.
    const double end =
        std::min(stock.growth.back().launch_s - stock.parsed_s, options.time.value_or(1e300));
    int number = 0;
    for (; GeometricSchedule::time(number) < end; ++number)
        take(number, name_of(number), GeometricSchedule::time(number));
    take(number, "end", end);
    result.complete = stock.complete;
    return result;
}

}  // namespace

MethodRun run_method(const std::string& method, const ComparedScene& scene,
                     const CompareOptions& options, ProgressLine& line) {
    return method == stock_mosaic_name ? run_stock(scene, options, line)
                                       : run_ours(method, scene, options, line);
}

}  // namespace povpreview
