// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>
#include <span>

namespace povpreview {

/// Differences between two images in display-encoded colour in [0, 1], averaged over pixels and
/// channels: 0 is equal, 1 is black against white everywhere.
struct ErrorMeasures {
    double l1 = 0;    ///< mean absolute difference (the paper's figure 4)
    double rmse = 0;  ///< root of the mean squared difference
};

/// Compares an image of linear light, which is encoded and clamped as a display would, with a
/// reference that is display-encoded already. Empty images are equal. A channel that is not finite
/// in either image counts as the worst error, 1, though a display would show it as black or white:
/// such a pixel must not pass for a lucky hit.
///
/// REQUIRES: both have the same number of pixels.
ErrorMeasures measure_error(std::span<const glm::vec3> linear,
                            std::span<const glm::vec3> encoded_reference);

}  // namespace povpreview
