// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/error_meter.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

#include "core/colour.h"
#include "core/error_measures.h"

namespace povpreview {
namespace {

constexpr float edge_contrast = .1f;
constexpr int edge_reach = 2;  // pixels

std::vector<glm::vec3> without_infinities(std::span<const glm::vec3> colours) {
    std::vector<glm::vec3> result(colours.begin(), colours.end());
    for (glm::vec3& c : result)
        for (int i = 0; i < 3; ++i)
            if (!std::isfinite(c[i])) c[i] = 0;
    return result;
}

bool is_edge(const glm::vec3& a, const glm::vec3& b) {
    return std::max({std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z)}) >
           edge_contrast;
}

/// The pixels whose distance to a pixel at an edge is at most `edge_reach` - 1: the edge itself
/// runs half a pixel beside that.
///
///        edge                  x: pixels at the edge, which have neighbours across it
///     o o x|x o o              o: further ones that are near
std::vector<bool> pixels_near_edges(std::span<const glm::vec3> image, int width, int height) {
    std::vector<bool> near(image.size());
    const auto mark = [&](int x, int y) {
        constexpr int reach = edge_reach - 1;
        for (int j = std::max(0, y - reach); j <= std::min(height - 1, y + reach); ++j)
            for (int i = std::max(0, x - reach); i <= std::min(width - 1, x + reach); ++i)
                near[static_cast<std::size_t>(j) * width + i] = true;
    };
    const auto at = [&](int x, int y) { return image[static_cast<std::size_t>(y) * width + x]; };
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            if (x + 1 < width && is_edge(at(x, y), at(x + 1, y))) mark(x, y), mark(x + 1, y);
            if (y + 1 < height && is_edge(at(x, y), at(x, y + 1))) mark(x, y), mark(x, y + 1);
        }
    return near;
}

}  // namespace

ErrorMeter::ErrorMeter(std::span<const glm::vec3> encoded_reference, int width, int height)
    : width_(width),
      height_(height),
      reference_(encoded_reference.begin(), encoded_reference.end()),
      finite_(without_infinities(encoded_reference)),
      near_edges_(pixels_near_edges(finite_, width, height)),
      similarity_(luma(finite_)),
      flip_(finite_, width, height) {
    assert(reference_.size() == static_cast<std::size_t>(width) * height);
}

/// What is not finite on either side becomes black or white, whichever is farther from the
/// reference.
std::vector<glm::vec3> ErrorMeter::encoded(std::span<const glm::vec3> linear) const {
    assert(linear.size() == reference_.size());
    std::vector<glm::vec3> result(linear.size());
    for (std::size_t i = 0; i < linear.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            const bool measurable = std::isfinite(linear[i][c]) && std::isfinite(reference_[i][c]);
            result[i][c] = measurable            ? display_encoded(linear[i][c])
                           : finite_[i][c] < .5f ? 1.f
                                                 : 0.f;
        }
    return result;
}

Plane ErrorMeter::luma(std::span<const glm::vec3> encoded) const {
    Plane result(width_, height_);
    for (std::size_t i = 0; i < encoded.size(); ++i)
        result.values[i] = .299f * encoded[i].x + .587f * encoded[i].y + .114f * encoded[i].z;
    return result;
}

ImageErrors ErrorMeter::measure(std::span<const glm::vec3> linear) const {
    ImageErrors errors;
    const ErrorMeasures whole = measure_error(linear, reference_);
    errors.l1 = whole.l1;
    errors.rmse = whole.rmse;
    if (whole.rmse > 0) errors.psnr = -20 * std::log10(whole.rmse);
    if (linear.empty()) return errors;

    const std::vector<glm::vec3> image = encoded(linear);
    errors.ssim = similarity_.mean(luma(image));
    const std::vector<float> map = flip_.map(image);
    errors.flip = std::accumulate(map.begin(), map.end(), 0.) / static_cast<double>(map.size());

    std::vector<glm::vec3> near_linear, near_reference;
    for (std::size_t i = 0; i < linear.size(); ++i)
        if (near_edges_[i]) {
            near_linear.push_back(linear[i]);
            near_reference.push_back(reference_[i]);
        }
    errors.edge_l1 = measure_error(near_linear, near_reference).l1;
    return errors;
}

std::vector<float> ErrorMeter::error_map(std::span<const glm::vec3> linear) const {
    return flip_.map(encoded(linear));
}

}  // namespace povpreview
