// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "display/image.h"
#include "display/layout.h"
#include "display/program/report.h"

namespace povpreview {

/// The pictures of a scene for the report, as HTML: the reference, then for some moments what each
/// method shows then, with two crops, magnified, and a map of its FLIP errors.
std::string pictures_html(const ReportContents& contents, const ReportScene& scene);

/// Where a window of this size has the greatest sum of `weights`, one a pixel in rows of `width`;
/// only windows at multiples of half their size are looked at. REQUIRES: one fits.
Rectangle heaviest_window(const std::vector<float>& weights, int width, int height,
                          int window_width, int window_height);

/// An error in [0, 1] as a colour, linear light: black, violet, red, orange, yellow, ever lighter
/// (matplotlib's inferno, which is in the public domain).
glm::vec3 error_colour(float error);

}  // namespace povpreview
