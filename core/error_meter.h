// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>
#include <limits>
#include <span>
#include <vector>

#include "core/flip.h"
#include "core/structural_similarity.h"

namespace povpreview {

/// How an image differs from a reference, by several measures of display-encoded colour in [0, 1].
struct ImageErrors {
    double l1 = 0, rmse = 0;                                ///< as in ErrorMeasures
    double psnr = std::numeric_limits<double>::infinity();  ///< decibels, of the rmse against 1
    double ssim = 1;     ///< StructuralSimilarity of luma (ITU-R BT.601); 1 is equal
    double flip = 0;     ///< mean of Flip
    double edge_l1 = 0;  ///< l1 of the pixels near edges of the reference; 0 where it has none
};

/// Measures images against one reference.
class ErrorMeter {
   public:
    /// `encoded_reference`: display-encoded, row by row. REQUIRES: width x height colours.
    ErrorMeter(std::span<const glm::vec3> encoded_reference, int width, int height);

    /// `linear`: linear light, which is encoded and clamped as a display would. A channel that is
    /// not finite in either image counts as the worst error (see measure_error).
    /// REQUIRES: of the reference's size.
    ImageErrors measure(std::span<const glm::vec3> linear) const;
    /// The Flip error of each pixel of such an image.
    std::vector<float> error_map(std::span<const glm::vec3> linear) const;

    /// The pixels within 2 pixels of an edge of the reference; an edge runs between two neighbours
    /// in a row or column that differ by more than a tenth of the range in some channel.
    const std::vector<bool>& near_edges() const { return near_edges_; }

   private:
    std::vector<glm::vec3> encoded(std::span<const glm::vec3> linear) const;
    Plane luma(std::span<const glm::vec3> encoded) const;

    int width_, height_;
    std::vector<glm::vec3> reference_;  ///< as given
    std::vector<glm::vec3> finite_;     ///< the same with 0 for what is not finite
    std::vector<bool> near_edges_;
    StructuralSimilarity similarity_;
    Flip flip_;
};

}  // namespace povpreview
