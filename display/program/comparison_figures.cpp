// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/program/comparison_figures.h"

#include <fmt/format.h>

#include <array>

#include "core/error_measures.h"
#include "display/atomic_file.h"
#include "display/offscreen.h"
#include "display/program/curves.h"
#include "display/program/figure_sheet.h"
#include "display/program/folder.h"
#include "display/program/interrupt.h"
#include "display/program/method_run.h"
#include "display/program/plot.h"
#include "display/program/reference.h"
#include "display/program/scene_list.h"

namespace povpreview {
namespace {

constexpr std::array<const char*, 3> methods{"blocks", "delaunay", "mesh"};
constexpr int rows = 4;
constexpr int samples_per_pixel = 4;

class ComparisonFigures {
   public:
    explicit ComparisonFigures(const FiguresOptions& options)
        : options_(options), offscreen_(open_offscreen(options.backend)) {}

    Exit run() {
        make_folder(options_.out, "--out");
        const std::vector<NamedScene> scenes = scene_list(options_.povray);
        if (scenes.size() > 1)
            throw Error(Exit::usage, "a figure shows one scene", "figures", "name one of them");
        scene_.name = scenes.front().name;
        scene_.words = scenes.front().words;
        scene_.folder = options_.out;
        scene_.reference = stock_reference(scene_.words, options_.out, interrupted);
        for (const char* method : methods) {
            trace(method);
            if (interrupted()) return Exit::interrupted;
        }
        if (options_.figure == 3)
            draw_pictures();
        else
            draw_curves();
        return Exit::success;
    }

   private:
    void trace(const std::string& method) {
        CompareOptions compare;
        static_cast<TracingOptions&>(compare) = options_;
        moments_.push_back(run_method(method, scene_, compare, line_).moments);
        for (const Moment& moment : moments_.back()) {
            const Image image =
                offscreen_.render(moment.picture, scene_.reference.width, scene_.reference.height);
            CurvePoint point;
            point.scene = scene_.name;
            point.method = method;
            point.moment = moment.number;
            point.standing = moment.standing;
            point.plain.l1 = measure_error(image.pixels, scene_.reference.pixels).l1;
            curves_.push_back(std::move(point));
        }
        line_.clear();
    }

    void draw_pictures() {
        std::vector<FigurePart> parts;
        for (const int number :
             telling_moments(run_of(curves_, scene_.name, methods.back(), 1), rows))
            for (std::size_t m = 0; m < methods.size(); ++m) {
                const std::string name(1, char('a' + parts.size()));
                parts.push_back(part(name, m, number));
            }
        write_figure(parts, options_.out);
    }

    /// The latest that a method has by a moment of the schedule; black before its first.
    FigurePart part(const std::string& name, std::size_t m, int number) {
        const std::string what = name + ": " + methods[m];
        const auto run = run_of(curves_, scene_.name, methods[m], 1);
        std::size_t i = run.size();
        while (i > 0 && run[i - 1]->moment > number) --i;
        const int width = scene_.reference.width, height = scene_.reference.height;
        if (i == 0) return {name, Image(width, height), what + "\nnothing yet"};
        const CurvePoint& point = *run[i - 1];
        return {name,
                offscreen_.render(moments_[m][i - 1].picture, width, height, samples_per_pixel,
                                  Overlay::none, Range::display),
                fmt::format("{}, {:.3f} s\n{} samples, error L1 {:.5f}", what,
                            point.standing.time_s, point.standing.full, point.plain.l1)};
    }

    void draw_curves() {
        draw_curves_over(axes().front(), "figure.svg");
        draw_curves_over(axes().back(), "rays.svg");
        std::string text = "method,time_s,full,probe,albedo,l1\n";
        for (const CurvePoint& p : curves_)
            text += fmt::format("{},{:.6f},{},{},{},{:.8g}\n", p.method, p.standing.time_s,
                                p.standing.full, p.standing.probe, p.standing.albedo, p.plain.l1);
        write_text(options_.out / "curves.csv", text);
    }

    void draw_curves_over(const Axis& axis, const char* file) {
        Plot plot{.title = "Error of previews of " + scene_.name,
                  .x_title = axis.title,
                  .y_title = "L1 error",
                  .curves = {},
                  .least_y = 2e-4};
        for (const char* method : methods) {
            Plot::Curve curve{.name = method, .colour = method_colour(method), .points = {}};
            for (const CurvePoint* p : run_of(curves_, scene_.name, method, 1))
                curve.points.emplace_back(axis.of(*p), p->plain.l1);
            plot.curves.push_back(std::move(curve));
        }
        draw_plot(plot, options_.out / file);
    }

    const FiguresOptions& options_;
    Offscreen offscreen_;
    ComparedScene scene_;
    std::vector<std::vector<Moment>> moments_;  // by method, then one for each of its points
    std::vector<CurvePoint> curves_;
    ProgressLine line_;
};

}  // namespace

Exit comparison_figures(const FiguresOptions& options) { return ComparisonFigures(options).run(); }

}  // namespace povpreview
