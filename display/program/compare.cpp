// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/program/compare.h"

#include <fmt/format.h>

#include <cctype>
#include <cstdio>
#include <memory>

#include "adapter/povray_options.h"
#include "core/error_measures.h"
#include "display/image_file.h"
#include "display/offscreen.h"
#include "display/program/curves.h"
#include "display/program/folder.h"
#include "display/program/interrupt.h"
#include "display/program/reference.h"
#include "display/program/schedule.h"
#include "display/program/strategy_run.h"
#include "display/progress_line.h"

namespace povpreview {
namespace {

using namespace std::chrono_literals;

/// What a method had at one moment of the schedule; its error is measured after the run.
struct Moment {
    std::string name;
    Standing standing;
    Picture picture;
};

/// Whether a file is named as measure() names its pictures.
bool is_picture_of(const std::string& method, const std::string& name) {
    const bool moment = name.size() > 3 && std::isdigit(static_cast<unsigned char>(name[0])) &&
                        std::isdigit(static_cast<unsigned char>(name[1])) && name[2] == '-';
    return (moment || name.starts_with("end-")) && name.ends_with("-" + method + ".png");
}

class Comparison {
   public:
    explicit Comparison(const CompareOptions& options)
        : options_(options), offscreen_(open_offscreen(options.backend)) {}

    Exit run() {
        make_folder(options_.out, "--out");
        reference_ = stock_reference(options_.povray, options_.out, interrupted);
        for (const std::string& method : options_.methods) {
            measure(method, trace(method));
            write_curves(curves_, options_.out / "curves.csv");
            if (interrupted()) return Exit::interrupted;
        }
        std::fputs(time_to_error_table(curves_, options_.methods).c_str(), stdout);
        return Exit::success;
    }

   private:
    std::vector<Moment> trace(const std::string& method) {
        TracedScene scene(
            read_povray_options(options_.povray).tracer_arguments(), options_.stall_timeout,
            [&](const std::string& text) { line_.show(method + ": " + text); }, interrupted,
            foreknowledge_for(method_needs(method), options_.mirror_depth));
        check_size(scene.description());
        StrategyRun run(method, scene, scene.oracle());
        std::vector<Moment> moments;
        // Copying the picture is not part of the method's work, and is left off the clock.
        const auto take = [&](const std::string& name) {
            const Standing standing = run.standing();
            scene.off_the_clock([&] {
                moments.push_back({name, standing, run.previewer().picture(Overlay::none)});
                line_.show(fmt::format("{}: {:.1f} s, {} samples", method, standing.time_s,
                                       standing.full));
            });
        };
        GeometricSchedule schedule;
        bool going = true;
        while (going && !interrupted() && !(options_.time && scene.time_s() >= *options_.time)) {
            going = run.advance(2ms);
            if (run.samples() == 0) continue;
            if (const auto moment = schedule.due(scene.time_s()))
                take(fmt::format("{:02d}-{:.2f}s", *moment, schedule.time(*moment)));
        }
        take("end");
        return moments;
    }

    /// Those of an earlier comparison, which had other moments; nothing else that lies there.
    void remove_pictures(const std::string& method) const {
        std::vector<std::filesystem::path> old;
        for (const auto& entry : std::filesystem::directory_iterator(options_.out))
            if (is_picture_of(method, entry.path().filename().string()))
                old.push_back(entry.path());
        for (const auto& path : old) std::filesystem::remove(path);
    }

    void check_size(const SceneDescription& scene) const {
        if (scene.width != reference_.width || scene.height != reference_.height)
            throw Error(Exit::usage,
                        fmt::format("the reference is {} x {} pixels, the tracer's picture {} x {}",
                                    reference_.width, reference_.height, scene.width, scene.height),
                        "compare", "give the size by +W and +H");
    }

    void measure(const std::string& method, const std::vector<Moment>& moments) {
        remove_pictures(method);
        for (const Moment& moment : moments) {
            line_.show(fmt::format("{}: measuring the picture at {:.2f} s", method,
                                   moment.standing.time_s));
            const Image image =
                offscreen_.render(moment.picture, reference_.width, reference_.height);
            const ErrorMeasures error = measure_error(image.pixels, reference_.pixels);
            curves_.push_back({method, moment.standing, error.l1, error.rmse});
            write_image(image, options_.out / fmt::format("{}-{}.png", moment.name, method));
        }
        line_.clear();
    }

    const CompareOptions& options_;
    Offscreen offscreen_;
    Image reference_;
    std::vector<CurvePoint> curves_;
    ProgressLine line_;
};

}  // namespace

Exit compare(const CompareOptions& options) { return Comparison(options).run(); }

}  // namespace povpreview
