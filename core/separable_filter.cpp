// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/separable_filter.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace povpreview {
namespace {

/// A row with its first and last pixel repeated `radius` times.
void pad(std::span<const float> row, int radius, std::vector<float>& padded) {
    padded.resize(row.size() + 2 * static_cast<std::size_t>(radius));
    std::fill_n(padded.begin(), radius, row.front());
    std::copy(row.begin(), row.end(), padded.begin() + radius);
    std::fill_n(padded.end() - radius, radius, row.back());
}

Plane filtered_rows(const Plane& image, const Weights& weights) {
    const int w = image.width, radius = static_cast<int>(weights.size() / 2);
    Plane result(w, image.height);
    std::vector<float> padded;
    for (int y = 0; y < image.height; ++y) {
        const std::size_t begin = static_cast<std::size_t>(y) * w;
        pad(std::span(image.values).subspan(begin, w), radius, padded);
        float* const out = &result.values[begin];
        for (std::size_t k = 0; k < weights.size(); ++k)
            for (int x = 0; x < w; ++x) out[x] += weights[k] * padded[k + x];
    }
    return result;
}

Plane filtered_columns(const Plane& image, const Weights& weights) {
    const int w = image.width, h = image.height, radius = static_cast<int>(weights.size() / 2);
    Plane result(w, h);
    for (int y = 0; y < h; ++y)
        for (int k = -radius; k <= radius; ++k) {
            const float weight = weights[k + radius];
            const float* const in =
                &image.values[static_cast<std::size_t>(std::clamp(y + k, 0, h - 1)) * w];
            float* const out = &result.values[static_cast<std::size_t>(y) * w];
            for (int x = 0; x < w; ++x) out[x] += weight * in[x];
        }
    return result;
}

}  // namespace

Weights gaussian(double sigma, int radius) {
    Weights weights;
    for (int x = -radius; x <= radius; ++x)
        weights.push_back(static_cast<float>(std::exp(-x * x / (2 * sigma * sigma))));
    return weights;
}

Weights scaled(Weights weights, double scale) {
    for (float& weight : weights) weight = static_cast<float>(weight * scale);
    return weights;
}

Plane filtered(const Plane& image, const Weights& across, const Weights& down) {
    assert(across.size() % 2 == 1 && down.size() % 2 == 1);
    if (image.values.empty()) return image;
    return filtered_columns(filtered_rows(image, across), down);
}

}  // namespace povpreview
