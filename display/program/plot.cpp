// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/program/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <memory>

#include "core/error.h"

namespace povpreview {
namespace {

/// As gnuplot reads it back in single quotes; its enhanced text is off.
std::string quoted(const std::string& text) {
    std::string result = "'";
    for (const char c : text) result += c == '\'' ? std::string("''") : std::string(1, c);
    return result + "'";
}

/// The ends of an axis, with room; gnuplot itself fails where there is a single point, or none.
struct Range {
    double least = 0, most = 0;

    void include(double value) {
        least = least > 0 ? std::min(least, value) : value;
        most = std::max(most, value);
    }
    std::string text() const {
        return least > 0 ? fmt::format("[{:g}:{:g}]", least / 1.2, most * 1.2) : "[.1:1]";
    }
};

std::string script_for(const Plot& plot, const std::filesystem::path& svg) {
    Range x_range, y_range;
    y_range.include(plot.least_y);
    std::string data, lines;
    for (std::size_t i = 0; i < plot.curves.size(); ++i) {
        const Plot::Curve& curve = plot.curves[i];
        data += fmt::format("$curve{} << end_of_curve\n", i);
        for (const auto& [x, y] : curve.points) {
            if (x <= 0) continue;
            const double shown = std::max(y, plot.least_y);
            x_range.include(x);
            y_range.include(shown);
            data += fmt::format("{:.7g} {:.7g}\n", x, shown);
        }
        data += "end_of_curve\n";
        const bool main = !curve.name.empty();
        lines += fmt::format(
            "$curve{} using 1:2 with {} linecolor '{}' {}, ", i,
            main ? "linespoints pointtype 7 pointsize .35 linewidth 2" : "lines linewidth .6",
            curve.colour, main ? "title " + quoted(curve.name) : "notitle");
    }
    return data + fmt::format(
                      "set terminal svg size 560,400 dynamic noenhanced font 'sans-serif,15' "
                      "background '#ffffff'\n"
                      "set output {}\n"
                      "set logscale xy\nset format x '%g'\nset format y '%g'\n"
                      "set grid xtics ytics mxtics linecolor '#dddddd', linecolor '#eeeeee'\n"
                      "set border 3 linecolor '#555555'\nset tics nomirror\n"
                      "set key below horizontal maxrows 3\n"
                      "set title {}\nset xlabel {}\nset ylabel {}\nset xrange {}\nset yrange {}\n"
                      "plot {} NaN notitle\n",
                      quoted(svg.string()), quoted(plot.title), quoted(plot.x_title),
                      quoted(plot.y_title), x_range.text(), y_range.text(), lines);
}

}  // namespace

void draw_plot(const Plot& plot, const std::filesystem::path& svg) {
    const std::string script = script_for(plot, svg);
    const auto failure = [&](const char* cause) {
        return Error(
            Exit::usage, cause, svg.string(),
            "install Debian's package gnuplot-nox, and see that the folder can be written");
    };
    FILE* const gnuplot = popen("gnuplot 2>/dev/null", "w");
    if (!gnuplot) throw failure("gnuplot cannot be started");
    std::fwrite(script.data(), 1, script.size(), gnuplot);
    if (pclose(gnuplot) != 0 || !std::filesystem::exists(svg))
        throw failure("gnuplot could not draw the curves");
}

std::string method_colour(const std::string& method) {
    static const std::map<std::string, std::string> colours{
        {"mesh", "#d55e00"},        {"constrained", "#f0a070"}, {"delaunay", "#0072b2"},
        {"blocks", "#009e73"},      {"mosaic", "#cc79a7"},      {"bicubic", "#e6b800"},
        {"stock-mosaic", "#444444"}};
    const auto found = colours.find(method);
    return found == colours.end() ? "#56b4e9" : found->second;
}

}  // namespace povpreview
