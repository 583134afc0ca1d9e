// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

namespace povpreview {

/// A single-channel image, row by row from the top.
struct Plane {
    int width = 0, height = 0;
    std::vector<float> values;

    Plane() = default;
    Plane(int w, int h) : width(w), height(h), values(static_cast<std::size_t>(w) * h) {}
    std::size_t size() const { return values.size(); }
};

/// Weights of a filter along one axis; the middle one is the pixel itself.
using Weights = std::vector<float>;

/// Weights of exp(-x^2 / (2 sigma^2)) at x = -radius .. radius, as they are, not normalised.
Weights gaussian(double sigma, int radius);
/// The same weights times `scale`.
Weights scaled(Weights weights, double scale);

/// The image filtered along its rows by `across`, then along its columns by `down`: a convolution
/// by the product of both. Beyond the border the nearest pixel goes on. REQUIRES: odd numbers of
/// weights.
Plane filtered(const Plane& image, const Weights& across, const Weights& down);

}  // namespace povpreview
