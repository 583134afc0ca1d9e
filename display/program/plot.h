// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace povpreview {

/// Curves on logarithmic axes.
struct Plot {
    struct Curve {
        std::string name;                               ///< empty: not in the key
        std::string colour;                             ///< #rrggbb
        std::vector<std::pair<double, double>> points;  ///< those with x above 0 are drawn
    };
    std::string title, x_title, y_title;
    std::vector<Curve> curves;
    double least_y =
        1e-4;  ///< the lower end of the y axis, above 0; what lies below is drawn there
};

/// Draws it by gnuplot into an SVG file. Throws Error(Exit::usage) if there is no gnuplot, or the
/// file cannot be written.
void draw_plot(const Plot& plot, const std::filesystem::path& svg);

/// The colour that a method has in all plots and tables, #rrggbb: Okabe and Ito's palette, which
/// colour-blind people can tell apart.
std::string method_colour(const std::string& method);

}  // namespace povpreview
