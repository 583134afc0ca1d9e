// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/flip.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>
#include <numbers>
#include <numeric>

#include "core/colour.h"

namespace povpreview {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double pixels_per_degree = .7 * 3840 / .7 * pi / 180;

// ---- colour spaces (section 4.1 of the paper; sRGB's primaries, white D65)

/// Linear sRGB to CIE XYZ; glm's matrices are written column by column.
const glm::mat3 xyz_of_rgb =
    glm::mat3(10135552. / 24577794, 2613072. / 12288897, 1425312. / 73733382, 8788810. / 24577794,
              8788810. / 12288897, 8788810. / 73733382, 4435075. / 24577794, 887015. / 12288897,
              70074185. / 73733382);
const glm::mat3 rgb_of_xyz = glm::inverse(xyz_of_rgb);
const glm::vec3 white = xyz_of_rgb * glm::vec3(1);

glm::vec3 ycxcz_of_rgb(const glm::vec3& linear) {
    const glm::vec3 xyz = xyz_of_rgb * linear / white;
    return {116 * xyz.y - 16, 500 * (xyz.x - xyz.y), 200 * (xyz.y - xyz.z)};
}

glm::vec3 rgb_of_ycxcz(const glm::vec3& c) {
    const float y = (c.x + 16) / 116;
    return rgb_of_xyz * (glm::vec3(y + c.y / 500, y, y - c.z / 200) * white);
}

/// CIE L*a*b* with a* and b* less in the dark, where colours look paler (Hunt's effect).
glm::vec3 hunt_lab_of_rgb(const glm::vec3& linear) {
    constexpr float delta = 6.f / 29;
    const auto f = [](float t) {
        return t > delta * delta * delta ? std::cbrt(t) : t / (3 * delta * delta) + 4.f / 29;
    };
    const glm::vec3 xyz = xyz_of_rgb * linear / white;
    const float x = f(xyz.x), y = f(xyz.y), z = f(xyz.z);
    const float lightness = 116 * y - 16;
    return {lightness, .01f * lightness * 500 * (x - y), .01f * lightness * 200 * (y - z)};
}

// ---- filters

/// A term a * sqrt(pi / b) * exp(-pi^2 r^2 / b) of a contrast sensitivity function, r in degrees.
struct SensitivityTerm {
    double a, b;
};
/// Achromatic, red against green, blue against yellow (table 1; a second term of weight 0 is left
/// out).
const std::array<std::vector<SensitivityTerm>, 3> sensitivity{
    {{{1, .0047}}, {{1, .0053}}, {{34.1, .04}, {13.5, .025}}}};
constexpr double widest_b = .04;

double sum(const Weights& weights) { return std::accumulate(weights.begin(), weights.end(), 0.); }

/// One channel of the opponent space as the eye resolves it: each term is a product of a Gaussian
/// in x and one in y, so their sum takes a pass for each.
Plane as_resolved(const Plane& channel, const std::vector<SensitivityTerm>& terms) {
    const int radius =
        static_cast<int>(std::ceil(3 * std::sqrt(widest_b / (2 * pi * pi)) * pixels_per_degree));
    double total = 0;
    Plane result(channel.width, channel.height);
    for (const SensitivityTerm& term : terms) {
        const double sigma = std::sqrt(term.b / 2) / pi * pixels_per_degree;
        const Weights weights = gaussian(sigma, radius);
        const double scale = term.a * std::sqrt(pi / term.b);
        total += scale * sum(weights) * sum(weights);
        const Plane part = filtered(channel, scaled(weights, scale), weights);
        for (std::size_t i = 0; i < result.size(); ++i) result.values[i] += part.values[i];
    }
    for (float& value : result.values) value = static_cast<float>(value / total);
    return result;
}

/// Width of the eye's feature detectors, peak to trough, in degrees (section 4.2).
constexpr double feature_width = .082;

/// Scales the weights so that those above 0 sum to 1 and those below to -1, in the plane: across
/// them stands a Gaussian whose weights sum to `other_axis`.
Weights balanced(Weights weights, double other_axis) {
    double above = 0, below = 0;
    for (const float weight : weights) (weight > 0 ? above : below) += weight;
    for (float& weight : weights)
        weight = static_cast<float>(weight / ((weight > 0 ? above : -below) * other_axis));
    return weights;
}

/// The length of the gradient that a detector sees along x and along y.
std::vector<float> strength(const Plane& luminance, const Weights& detector,
                            const Weights& gaussian_across) {
    const Plane x = filtered(luminance, detector, gaussian_across),
                y = filtered(luminance, gaussian_across, detector);
    std::vector<float> result(luminance.size());
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i] = glm::length(glm::vec2(x.values[i], y.values[i]));
    return result;
}

// ---- differences (section 4.3)

/// HyAB: lightness and chroma differ each for itself.
float hyab(const glm::vec3& a, const glm::vec3& b) {
    const glm::vec3 d = a - b;
    return std::abs(d.x) + glm::length(glm::vec2(d.y, d.z));
}

float colour_difference(const glm::vec3& a, const glm::vec3& b) {
    constexpr float exponent = .7f, share = .4f, most_of_range = .95f;
    static const float greatest =
        std::pow(hyab(hunt_lab_of_rgb({0, 1, 0}), hunt_lab_of_rgb({0, 0, 1})), exponent);
    const float difference = std::pow(hyab(a, b), exponent), knee = share * greatest;
    if (difference < knee) return most_of_range / knee * difference;
    return most_of_range + (difference - knee) / (greatest - knee) * (1 - most_of_range);
}

}  // namespace

Flip::Flip(std::span<const glm::vec3> reference, int width, int height)
    : width_(width), height_(height), reference_(perceive(reference)) {}

Flip::Percept Flip::perceive(std::span<const glm::vec3> image) const {
    assert(image.size() == static_cast<std::size_t>(width_) * height_);
    std::array<Plane, 3> channels;
    for (Plane& channel : channels) channel = Plane(width_, height_);
    Plane luminance(width_, height_);
    for (std::size_t i = 0; i < image.size(); ++i) {
        const glm::vec3 linear(decode_srgb(image[i].x), decode_srgb(image[i].y),
                               decode_srgb(image[i].z));
        const glm::vec3 opponent = ycxcz_of_rgb(linear);
        for (int c = 0; c < 3; ++c) channels[c].values[i] = opponent[c];
        luminance.values[i] = (opponent.x + 16) / 116;
    }

    Percept percept;
    for (int c = 0; c < 3; ++c) channels[c] = as_resolved(channels[c], sensitivity[c]);
    percept.colour.reserve(image.size());
    for (std::size_t i = 0; i < image.size(); ++i) {
        const glm::vec3 linear =
            rgb_of_ycxcz({channels[0].values[i], channels[1].values[i], channels[2].values[i]});
        percept.colour.push_back(hunt_lab_of_rgb(glm::clamp(linear, glm::vec3(0), glm::vec3(1))));
    }

    const double sigma = .5 * feature_width * pixels_per_degree;
    const int radius = static_cast<int>(std::ceil(3 * sigma));
    const Weights across = gaussian(sigma, radius);
    Weights edge = across, point = across;
    for (int x = -radius; x <= radius; ++x) {
        edge[x + radius] *= static_cast<float>(-x);
        point[x + radius] *= static_cast<float>(x * x / (sigma * sigma) - 1);
    }
    percept.edges = strength(luminance, balanced(edge, sum(across)), across);
    percept.points = strength(luminance, balanced(point, sum(across)), across);
    return percept;
}

std::vector<float> Flip::map(std::span<const glm::vec3> image) const {
    const Percept seen = perceive(image);
    std::vector<float> errors(image.size());
    for (std::size_t i = 0; i < image.size(); ++i) {
        const float colour = colour_difference(reference_.colour[i], seen.colour[i]);
        const float feature = std::max(std::abs(reference_.edges[i] - seen.edges[i]),
                                       std::abs(reference_.points[i] - seen.points[i]));
        const float amplified = std::sqrt(feature / std::numbers::sqrt2_v<float>);
        errors[i] = std::pow(colour, 1 - std::min(1.f, amplified));
    }
    return errors;
}

}  // namespace povpreview
