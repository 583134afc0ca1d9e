// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/program/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <optional>

#include "core/error_meter.h"
#include "display/atomic_file.h"
#include "display/image_file.h"
#include "display/offscreen.h"
#include "display/program/curves.h"
#include "display/program/folder.h"
#include "display/program/interrupt.h"
#include "display/program/machine.h"
#include "display/program/method_run.h"
#include "display/program/reference.h"
#include "display/program/report.h"
#include "display/program/scene_list.h"
#include "display/program/summary.h"
#include "display/progress_line.h"

namespace povpreview {
namespace {

/// For the comparison with an anti-aliased render; Mesa in software offers no more.
constexpr int smooth_samples = 4;

/// Whether a file is named as measure() names its pictures.
bool is_picture_of(const std::string& method, const std::string& name) {
    const bool moment = name.size() > 3 && std::isdigit(static_cast<unsigned char>(name[0])) &&
                        std::isdigit(static_cast<unsigned char>(name[1])) && name[2] == '-';
    if (!(moment || name.starts_with("end-")) || !name.ends_with("-" + method + ".png"))
        return false;
    // "mosaic" is also the end of "stock-mosaic".
    return method != "mosaic" || !name.ends_with(std::string("-") + stock_mosaic_name + ".png");
}

/// Those of an earlier comparison, which had other moments; nothing else that lies there.
void remove_pictures(const std::filesystem::path& folder, const std::string& method) {
    std::vector<std::filesystem::path> old;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (is_picture_of(method, entry.path().filename().string())) old.push_back(entry.path());
    for (const auto& path : old) std::filesystem::remove(path);
}

class Comparison {
   public:
    explicit Comparison(const CompareOptions& options) : options_(options) {
        // Before anything starts threads, whose cores are then the same.
        if (options.threads > 0) keep_to_cores(options.threads);
        offscreen_.emplace(open_offscreen(options.backend));
    }

    Exit run() {
        make_folder(options_.out, "--out");
        Exit result = Exit::success;
        for (const NamedScene& scene : scene_list(options_.povray)) {
            try {
                compare_methods(scene);
            } catch (const Error& error) {
                // The others still can.
                line_.clear();
                if (error.exit() == Exit::interrupted) throw;
                fmt::print(stderr, "povpreview: {}: {}\n", scene.name, error.what());
                result = error.exit();
                failures_.push_back(fmt::format("{}: {}", scene.name, error.what()));
            }
            if (interrupted()) break;
        }
        line_.clear();
        if (scenes_.empty()) return interrupted() ? Exit::interrupted : result;
        write_results();
        return interrupted() ? Exit::interrupted : result;
    }

   private:
    /// On one scene, each as often as asked for, in an order that moves on by one with each repeat:
    /// what the machine does beside then meets none of them more than the others.
    void compare_methods(const NamedScene& named) {
        ComparedScene scene{.name = named.name,
                            .words = named.words,
                            .folder = options_.out / named.name,
                            .reference = {},
                            .smooth_reference = {}};
        if (options_.threads > 0) scene.words.push_back(fmt::format("+WT{}", options_.threads));
        make_folder(scene.folder, "--out");
        scene.reference = stock_reference(named.words, scene.folder, interrupted);
        scene.smooth_reference =
            stock_reference(named.words, scene.folder, interrupted, Antialiasing::on);
        const ErrorMeter plain = meter(scene.reference), smooth = meter(scene.smooth_reference);
        ReportScene shown{
            .name = scene.name, .folder = scene.folder, .plans = {}, .notes = {}, .complete = {}};
        std::vector<CurvePoint> curves;
        for (int repeat = 1; repeat <= options_.repeat; ++repeat) {
            std::vector<std::string> order = options_.methods;
            std::rotate(order.begin(), order.begin() + (repeat - 1) % int(order.size()),
                        order.end());
            for (const std::string& method : order) {
                const MethodRun run = run_method(method, scene, options_, line_);
                if (repeat == 1) {
                    remove_pictures(scene.folder, method);
                    shown.notes.emplace_back(method, run.notes);
                    if (!run.plan.empty()) shown.plans.emplace_back(method, run.plan);
                    shown.complete.emplace_back(method, run.complete);
                }
                measure(scene, method, repeat, run.moments, plain, smooth, curves);
                if (interrupted()) break;
            }
            if (interrupted()) break;
        }
        curves_.insert(curves_.end(), curves.begin(), curves.end());
        scenes_.push_back(std::move(shown));
        write_curves(curves_, options_.out / "curves.csv");
    }

    static ErrorMeter meter(const Image& reference) {
        return ErrorMeter(reference.pixels, reference.width, reference.height);
    }

    void measure(const ComparedScene& scene, const std::string& method, int repeat,
                 const std::vector<Moment>& moments, const ErrorMeter& plain,
                 const ErrorMeter& smooth, std::vector<CurvePoint>& curves) {
        const int width = scene.reference.width, height = scene.reference.height;
        for (const Moment& moment : moments) {
            line_.show(fmt::format("{}, {}: measuring the picture at {:.2f} s", scene.name, method,
                                   moment.standing.time_s));
            const Image image = offscreen_->render(moment.picture, width, height);
            const Image smoothed = offscreen_->render(moment.picture, width, height, smooth_samples,
                                                      Overlay::none, Range::display);
            CurvePoint point{.scene = scene.name,
                             .method = method,
                             .repeat = repeat,
                             .moment = moment.number,
                             .standing = moment.standing,
                             .memory_mb = double(moment.memory) / (1 << 20),
                             .plain = plain.measure(image.pixels),
                             .smooth = smooth.measure(smoothed.pixels),
                             .picture = {}};
            if (repeat == 1) {
                point.picture = fmt::format("{}-{}.png", moment.name, method);
                write_image(image, scene.folder / point.picture);
            }
            curves.push_back(std::move(point));
        }
    }

    void write_results() {
        std::vector<std::string> names;
        for (const ReportScene& scene : scenes_) names.push_back(scene.name);
        const Summary summary = summarise(curves_, names, options_.methods);
        const Machine machine = this_machine(options_.threads, offscreen_->description());
        write_text(options_.out / "summary.json", json(summary, json(machine)));
        std::fputs(text_table(summary, names, options_.methods).c_str(), stdout);
        line_.show("writing the report");
        write_report({.options = options_,
                      .scenes = scenes_,
                      .failures = failures_,
                      .curves = curves_,
                      .summary = summary,
                      .machine = machine});
        line_.clear();
    }

    const CompareOptions& options_;
    std::optional<Offscreen> offscreen_;
    std::vector<ReportScene> scenes_;
    std::vector<std::string> failures_;
    std::vector<CurvePoint> curves_;
    ProgressLine line_;
};

}  // namespace

Exit compare(const CompareOptions& options) { return Comparison(options).run(); }

}  // namespace povpreview
