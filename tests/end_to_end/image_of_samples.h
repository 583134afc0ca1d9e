// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "tests/end_to_end/real_tracer.h"

namespace povpreview {

/// How far samples are from an image of stock POV-Ray, in units of 1/65535 of the sRGB-encoded
/// value.
struct Difference {
    int worst = 0;                ///< of all pixels and channels
    std::size_t differing = 0;    ///< pixels off by more than one unit in some channel
    std::size_t failed = 0;       ///< samples without an answer
    double root_mean_square = 0;  ///< over all channels, as a share of full scale
};

/// Renders by stock POV-Ray with the same words and compares. Throws Error as
/// render_by_stock_povray does, or if the images differ in size.
Difference compare_with_stock(const TracedImage& image, const std::vector<std::string>& words,
                              const WorkFolder& folder);

}  // namespace povpreview
