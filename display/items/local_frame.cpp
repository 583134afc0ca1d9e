// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/items/local_frame.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>

namespace povpreview::items {

namespace {

/// An object starts on its own plane if the whole of it is this far in front of the eye, in units
/// of its size.
constexpr double in_front = .05;
/// Outlines are this much larger than what they outline, pixels: what floats and the rasteriser's
/// grid may lose.
constexpr double outline_slack = .02;

glm::dvec3 corner_of(const Bounds& bounds, int corner) {
    return {corner & 1 ? bounds.high.x : bounds.low.x, corner & 2 ? bounds.high.y : bounds.low.y,
            corner & 4 ? bounds.high.z : bounds.low.z};
}

}  // namespace

bool is_finite(const Bounds& bounds) {
    const glm::dvec3 sum = bounds.low + bounds.high;
    return std::isfinite(sum.x + sum.y + sum.z);
}

LocalFrame::LocalFrame(const PixelRays& rays, const Bounds& bounds, int width, int height) {
    const glm::dvec2 middle(width / 2, height / 2);
    const bool finite = is_finite(bounds);
    bool own_plane = false;
    if (finite) {
        centre = (bounds.low + bounds.high) / 2.;
        size = glm::length(bounds.high - bounds.low) / 2;
        if (!(size > 0)) size = 1;
        double nearest = rays.project(centre).depth;
        for (int corner = 0; corner < 8; ++corner)
            nearest = std::min(nearest, rays.project(corner_of(bounds, corner)).depth);
        own_plane = rays.orthographic || nearest > in_front * size;
    } else {
        centre = rays.orthographic ? rays.point(middle, 0) : rays.origin;
    }
    if (own_plane) {
        const Projected projected = rays.project(centre);
        reference = glm::vec2(projected.pixel());  // as the shader has it: exactly 32 bits
        depth = static_cast<float>(projected.depth);
    } else {
        reference = middle;
    }
    base = (rays.point(reference, depth) - centre) / size;
    direction = rays.direction(reference);
    base_factor = (rays.orthographic ? 1 : depth) / size;
    direction_factor = rays.orthographic ? 0 : 1;
}

bool LocalFrame::valid() const {
    return std::isfinite(glm::dot(centre, glm::dvec3(1)) + size + depth + reference.x +
                         reference.y + glm::dot(base + direction, glm::dvec3(1)) + base_factor);
}

std::vector<glm::dvec2> outline_of(const PixelRays& rays, const Bounds& bounds, int width,
                                   int height) {
    if (!is_finite(bounds))
        return {{0, 0}, {double(width), 0}, {double(width), double(height)}, {0, double(height)}};
    std::array<glm::dvec3, 8> corners;
    for (std::size_t i = 0; i < 8; ++i) corners[i] = corner_of(bounds, static_cast<int>(i));
    return outline_of(rays, corners, width, height);
}

std::vector<glm::dvec2> outline_of(const PixelRays& rays, const std::array<glm::dvec3, 8>& box,
                                   int width, int height) {
    std::array<Projected, 8> corners;
    std::transform(box.begin(), box.end(), corners.begin(),
                   [&](const glm::dvec3& p) { return rays.project(p); });
    // What is in front of the eye of its sides outlines it, wherever the eye is.
    static constexpr std::array<std::array<std::size_t, 4>, 6> sides{
        {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}}};
    std::vector<glm::dvec2> points;
    std::vector<Projected> polygon;
    for (const auto& side : sides) {
        polygon.clear();
        for (const std::size_t corner : side) polygon.push_back(corners[corner]);
        clip_to_view(polygon, width, height);
        for (const Projected& p : polygon)
            for (const double x : {-outline_slack, outline_slack})
                for (const double y : {-outline_slack, outline_slack})
                    points.push_back(p.pixel() + glm::dvec2(x, y));
    }
    return convex_hull(std::move(points));
}

}  // namespace povpreview::items
