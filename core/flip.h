// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "core/separable_filter.h"

namespace povpreview {

/// FLIP, how different two images look when one alternates with the other: Andersson, Nilsson,
/// Akenine-Moller, Oskarsson, Astrom and Fairchild, "FLIP: a difference evaluator for alternating
/// images", 2020, for images of low dynamic range and their viewing conditions, a display 3840
/// pixels and .7 m wide seen from .7 m.
///
/// Made for one reference and many images of sRGB-encoded colours in [0, 1].
class Flip {
   public:
    Flip(std::span<const glm::vec3> reference, int width, int height);

    /// The error of each pixel, 0 (equal) to 1. REQUIRES: of the reference's size.
    std::vector<float> map(std::span<const glm::vec3> image) const;

    /// What the eye makes of an image.
    struct Percept {
        std::vector<glm::vec3> colour;     ///< filtered, in Hunt-adjusted L*a*b*
        std::vector<float> edges, points;  ///< strength of features in the luminance
    };

   private:
    Percept perceive(std::span<const glm::vec3> image) const;

    int width_, height_;
    Percept reference_;
};

}  // namespace povpreview
