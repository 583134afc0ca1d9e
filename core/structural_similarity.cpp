// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/structural_similarity.h"

#include <algorithm>
#include <cassert>
#include <numeric>

namespace povpreview {
namespace {

constexpr double sigma = 1.5;
constexpr int radius = 5;
constexpr double c1 = .01 * .01, c2 = .03 * .03;  // (K L)^2 for values in [0, L = 1]

Plane product(const Plane& a, const Plane& b) {
    Plane result(a.width, a.height);
    for (std::size_t i = 0; i < a.size(); ++i) result.values[i] = a.values[i] * b.values[i];
    return result;
}

Weights window_for(const Plane& image) {
    const int shortest = std::min(image.width, image.height);
    const Weights weights = gaussian(sigma, std::clamp((shortest - 1) / 2, 0, radius));
    return scaled(weights, 1 / std::accumulate(weights.begin(), weights.end(), 0.));
}

}  // namespace

StructuralSimilarity::StructuralSimilarity(Plane reference)
    : window_(window_for(reference)),
      reference_(std::move(reference)),
      mean_(smooth(reference_)),
      mean_of_squares_(smooth(product(reference_, reference_))) {}

double StructuralSimilarity::mean(const Plane& image) const {
    assert(image.width == reference_.width && image.height == reference_.height);
    if (image.values.empty()) return 1;
    const Plane means = smooth(image), squares = smooth(product(image, image)),
                products = smooth(product(image, reference_));
    const int margin = static_cast<int>(window_.size() / 2);
    double sum = 0;
    std::size_t windows = 0;
    for (int y = margin; y < image.height - margin; ++y)
        for (int x = margin; x < image.width - margin; ++x) {
            const std::size_t i = static_cast<std::size_t>(y) * image.width + x;
            const double a = mean_.values[i], b = means.values[i];
            const double variance_a = mean_of_squares_.values[i] - a * a,
                         variance_b = squares.values[i] - b * b,
                         covariance = products.values[i] - a * b;
            sum += (2 * a * b + c1) * (2 * covariance + c2) /
                   ((a * a + b * b + c1) * (variance_a + variance_b + c2));
            ++windows;
        }
    return sum / static_cast<double>(windows);
}

}  // namespace povpreview
