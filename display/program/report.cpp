// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/program/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "display/atomic_file.h"
#include "display/program/data_uri.h"
#include "display/program/plot.h"
#include "display/program/report_pictures.h"
#include "display/program/report_style.h"

namespace povpreview {
namespace {

const Measure& measure_named(const std::string& name) {
    return *std::find_if(measures().begin(), measures().end(),
                         [&](const Measure& m) { return m.name == name; });
}

std::string name_cell(const std::string& method) {
    return fmt::format("<th style=\"color:{}\">{}</th>", method_colour(method),
                       html_escaped(method));
}

/// A ratio to the first method, coloured by who leads.
std::string ratio_class(const std::optional<double>& ratio) {
    if (!ratio) return "none";
    return *ratio > tie ? "win" : *ratio < 1 / tie ? "loss" : "tie";
}

/// Whatever can be counted, with blanks between thousands.
std::string thousands(double number) {
    std::string digits = fmt::format("{:.0f}", number);
    for (std::size_t i = digits.size(); i > 3; i -= 3) digits.insert(i - 3, "&#8239;");
    return digits;
}

class Report {
   public:
    explicit Report(const ReportContents& contents)
        : contents_(contents), methods_(contents.options.methods) {}

    std::string html() {
        std::string text = fmt::format(
            "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n<meta "
            "name=\"viewport\" "
            "content=\"width=device-width, initial-scale=1\">\n<title>povpreview: {} "
            "compared</title>\n"
            "<style>{}</style></head><body>\n",
            html_escaped(fmt::format("{}", fmt::join(methods_, ", "))), report_style);
        text += "<h1>Previews compared</h1>\n" + introduction() + summary();
        for (const ReportScene& scene : contents_.scenes) text += scene_html(scene);
        return text + how_measured() + "</body></html>\n";
    }

   private:
    const std::string& first() const { return methods_.front(); }

    std::string introduction() const {
        std::string text = fmt::format(
            "<p>How long does a preview take to come within an error of the finished picture? {} "
            "scene{}, {} method{}, {} run{} of each. Times count from the end of the parse; "
            "<a href=\"#how\">how it was measured</a>.</p>\n",
            contents_.scenes.size(), contents_.scenes.size() == 1 ? "" : "s", methods_.size(),
            methods_.size() == 1 ? "" : "s", contents_.options.repeat,
            contents_.options.repeat == 1 ? "" : "s");
        for (const std::string& failure : contents_.failures)
            text += "<p class=\"failure\">Left out: " + html_escaped(failure) + "</p>\n";
        return text;
    }

    // ---- over all scenes

    std::string summary() const {
        if (methods_.size() < 2) return "";
        std::string text = fmt::format(
            "<h2>Summary</h2>\n<p>How many times as long as <b>{}</b> the others take to each "
            "error: "
            "geometric mean over the scenes where both came to it. Below: scenes that {} won / "
            "lost by more than 5 %, or alone came to the error / did not.</p>\n",
            html_escaped(first()), html_escaped(first()));
        for (const char* name : {"l1", "flip", "edge_l1", "aa_l1"})
            text += ratio_table(measure_named(name), axes()[0]);
        text +=
            "<details><summary>Counted from the launch of the programs, and in rays</summary>\n";
        for (const Axis* axis : {&axes()[1], &axes()[2]})
            text += ratio_table(measure_named("l1"), *axis);
        return text + "</details>\n" + losses();
    }

    std::string ratio_table(const Measure& measure, const Axis& axis) const {
        std::string text = fmt::format(
            "<div class=\"scroll\"><table><caption>{}, over {}</caption><tr><th>error</th>",
            measure.title, axis.title);
        for (std::size_t m = 1; m < methods_.size(); ++m) text += name_cell(methods_[m]);
        text += "</tr>\n";
        for (const double level : measure.levels) {
            text += fmt::format("<tr><td>{}</td>", level);
            for (const MeanRatio& mean : contents_.summary.means) {
                if (mean.measure != &measure || mean.axis != &axis || mean.level != level) continue;
                text += fmt::format("<td class=\"{}\">{}<br><small>{} / {}</small></td>",
                                    ratio_class(mean.geometric_mean),
                                    mean.geometric_mean
                                        ? fmt::format("{:.2f}&#8239;&times;", *mean.geometric_mean)
                                        : std::string("&ndash;"),
                                    mean.wins, mean.losses);
            }
            text += "</tr>\n";
        }
        return text + "</table></div>\n";
    }

    /// Every scene and L1 error that other methods came to sooner, a line each.
    std::string losses() const {
        std::string items;
        for (const ReportScene& scene : contents_.scenes)
            for (const double level : measures().front().levels) {
                const std::string sooner = sooner_than_first(scene.name, level);
                if (!sooner.empty())
                    items += fmt::format("<li>{}, L1 {}: {}</li>\n", html_escaped(scene.name),
                                         level, sooner);
            }
        if (items.empty())
            return fmt::format("<p>No other method came to any of these L1 errors before {}.</p>\n",
                               html_escaped(first()));
        return fmt::format("<h3>Where {} lost, by L1</h3>\n<ul class=\"losses\">{}</ul>\n",
                           html_escaped(first()), items);
    }

    std::string sooner_than_first(const std::string& scene, double level) const {
        std::string text;
        for (const Reached& r : contents_.summary.reached) {
            if (r.measure != &measures().front() || r.axis != &axes().front()) continue;
            if (r.scene != scene || r.level != level || r.method == first() || !r.median) continue;
            if (r.ratio && *r.ratio >= 1 / tie) continue;
            text += fmt::format("{}<span style=\"color:{}\">{}</span> {}", text.empty() ? "" : ", ",
                                method_colour(r.method), html_escaped(r.method),
                                r.ratio ? fmt::format("{:.2f}&#8239;&times;", *r.ratio)
                                        : fmt::format("{:.2f}&#8239;s", *r.median));
        }
        return text;
    }

    // ---- one scene

    std::string scene_html(const ReportScene& scene) const {
        return fmt::format("<section><h2>{}</h2>\n", html_escaped(scene.name)) +
               times_table(scene) + plots(scene) + pictures_html(contents_, scene) +
               totals_table(scene) + notes(scene) + "</section>\n";
    }

    std::string times_table(const ReportScene& scene) const {
        std::string text =
            "<div class=\"scroll\"><table><caption>Seconds to each error (median; least to "
            "greatest)</caption><tr><th>error</th>";
        for (const std::string& method : methods_) text += name_cell(method);
        text += "</tr>\n";
        for (const char* name : {"l1", "flip"})
            for (const double level : measure_named(name).levels) {
                text += fmt::format("<tr><td>{} {}</td>", measure_named(name).title, level);
                for (const Reached& r : contents_.summary.reached) {
                    if (r.scene != scene.name || r.measure->name != std::string(name) ||
                        r.axis != &axes().front() || r.level != level)
                        continue;
                    text += time_cell(r);
                }
                text += "</tr>\n";
            }
        return text + "</table></div>\n";
    }

    std::string time_cell(const Reached& r) const {
        if (!r.median) return "<td class=\"none\">&ndash;</td>";
        std::string spread;
        if (r.repeats > 1)
            spread = fmt::format("<br><small>{:.3f} to {:.3f}</small>", *r.least, *r.greatest);
        const std::string ratio =
            r.ratio && r.method != first() ? fmt::format(" ({:.2f}&#8239;&times;)", *r.ratio) : "";
        return fmt::format("<td class=\"{}\">{:.3f}{}{}</td>",
                           r.method == first() ? "own" : ratio_class(r.ratio), *r.median, ratio,
                           spread);
    }

    std::string plots(const ReportScene& scene) const {
        struct Choice {
            const char* measure;
            std::size_t axis;
        };
        std::string text = "<div class=\"plots\">";
        for (const Choice& choice : {Choice{"l1", 0}, {"flip", 0}, {"edge_l1", 0}, {"l1", 2}}) {
            const Measure& measure = measure_named(choice.measure);
            const Axis& axis = axes()[choice.axis];
            const auto file =
                scene.folder / fmt::format("curve-{}-{}.svg", measure.name, axis.name);
            draw_plot(plot(scene, measure, axis), file);
            std::ifstream stream(file);
            std::stringstream svg;
            svg << stream.rdbuf();
            const std::string bytes = svg.str();
            text += fmt::format(
                "<img alt=\"{} over {}\" src=\"{}\">", measure.title, axis.title,
                data_uri("image/svg+xml",
                         {reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()}));
        }
        return text + "</div>\n";
    }

    /// Each run a line; the first one with marks and a name.
    Plot plot(const ReportScene& scene, const Measure& measure, const Axis& axis) const {
        Plot plot{.title = fmt::format("{}: {} over {}", scene.name, measure.title, axis.title),
                  .x_title = axis.title,
                  .y_title = measure.title,
                  .curves = {},
                  .least_y = 2e-4};
        for (const std::string& method : methods_)
            for (int repeat = 1; repeat <= contents_.options.repeat; ++repeat) {
                Plot::Curve curve{.name = repeat == 1 ? method : "",
                                  .colour = method_colour(method),
                                  .points = {}};
                for (const CurvePoint* p : run_of(contents_.curves, scene.name, method, repeat))
                    curve.points.emplace_back(axis.of(*p), measure.of(*p));
                if (!curve.points.empty()) plot.curves.push_back(std::move(curve));
            }
        return plot;
    }

    std::string totals_table(const ReportScene& scene) const {
        std::string text =
            "<div class=\"scroll\"><table><caption>In the end (medians)</caption><tr><th></th><th>"
            "seconds</th><th>since launch</th><th>full rays</th><th>probes</th><th>albedo</th>"
            "<th>&micro;s each</th><th>memory, MB</th><th>L1</th><th>complete</th></tr>\n";
        for (const Totals& t : contents_.summary.totals) {
            if (t.scene != scene.name) continue;
            const auto each = [](double seconds, double rays) {
                if (rays <= 0 || seconds <= 0) return std::string("&ndash;");
                const double microseconds = 1e6 * seconds / rays;
                return fmt::format("{:.{}f}", microseconds, microseconds < 10 ? 1 : 0);
            };
            const auto complete = std::find_if(scene.complete.begin(), scene.complete.end(),
                                               [&](const auto& c) { return c.first == t.method; });
            text += fmt::format(
                "<tr>{}<td>{:.3f}</td><td>{:.3f}</td><td>{}</td><td>{}</td><td>{}</td><td>{} / {} "
                "/ "
                "{}</td><td>{}</td><td>{:.5f}</td><td>{}</td></tr>\n",
                name_cell(t.method), t.time_s, t.launch_s, thousands(t.full), thousands(t.probe),
                thousands(t.albedo), each(t.full_s, t.full), each(t.probe_s, t.probe),
                each(t.albedo_s, t.albedo),
                t.memory_mb > 0 ? fmt::format("{:.0f}", t.memory_mb) : std::string("&ndash;"), t.l1,
                complete != scene.complete.end() && complete->second ? "yes" : "no");
        }
        return text + "</table></div>\n";
    }

    std::string notes(const ReportScene& scene) const {
        std::string text;
        for (const auto& [method, plan] : scene.plans)
            text += fmt::format(
                "<div class=\"scroll\"><p><b>The plan of {}, and what it took</b></p><pre>{}</pre>"
                "</div>\n",
                html_escaped(method), html_escaped(plan));
        std::string items;
        for (const auto& [method, sentences] : scene.notes)
            for (const std::string& sentence : sentences)
                items += fmt::format("<li><b>{}</b>: {}</li>\n", html_escaped(method),
                                     html_escaped(sentence));
        if (!items.empty()) text += "<ul class=\"notes\">" + items + "</ul>\n";
        return text;
    }

    // ---- the end

    std::string how_measured() const {
        std::string text = "<section id=\"how\"><h2>How it was measured</h2>\n<dl>\n";
        for (const auto& [name, value] : contents_.machine)
            text +=
                fmt::format("<dt>{}</dt><dd>{}</dd>\n", html_escaped(name), html_escaped(value));
        text +=
            fmt::format("<dt>POV-Ray's words</dt><dd><code>{}</code></dd></dl>\n",
                        html_escaped(fmt::format("{}", fmt::join(contents_.options.povray, " "))));
        return text + report_explanation + "</section>\n";
    }

    const ReportContents& contents_;
    const std::vector<std::string>& methods_;
};

}  // namespace

void write_report(const ReportContents& contents) {
    write_text(contents.options.out / "report.html", Report(contents).html());
}

}  // namespace povpreview
