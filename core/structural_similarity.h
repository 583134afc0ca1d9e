// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "core/separable_filter.h"

namespace povpreview {

/// The mean structural similarity index (MSSIM) of Wang, Bovik, Sheikh and Simoncelli, "Image
/// quality assessment: from error visibility to structural similarity", 2004, with their constants:
/// windows of 11 x 11 pixels weighted by a Gaussian of sigma 1.5, K1 = .01, K2 = .03, averaged over
/// the windows that lie wholly in the image. 1: equal; lower is worse, below 0 is possible.
///
/// Made for one reference and many images. Values in [0, 1]. In images narrower than a window the
/// window is cut to the largest square with a pixel in its middle that fits.
class StructuralSimilarity {
   public:
    explicit StructuralSimilarity(Plane reference);

    /// REQUIRES: of the reference's size.
    double mean(const Plane& image) const;

   private:
    Plane smooth(const Plane& image) const { return filtered(image, window_, window_); }

    Weights window_;
    Plane reference_, mean_, mean_of_squares_;
};

}  // namespace povpreview
