// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/detail/pixel_rays.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <limits>

namespace povpreview {

namespace {

/// What lies this many image sizes beside the image is cut off.
constexpr double margin = 1;

bool finite(const glm::dvec3& v) { return std::isfinite(v.x + v.y + v.z); }

/// The i-th of eight; the lower four have the lower z.
glm::dvec3 corner_of(const Bounds& box, int i) {
    return {i & 1 ? box.high.x : box.low.x, i & 2 ? box.high.y : box.low.y,
            i & 4 ? box.high.z : box.low.z};
}

glm::dvec3 matrix_row(const glm::dmat4x3& m, int i) { return {m[0][i], m[1][i], m[2][i]}; }

/// The matrix with these rows, turned around; columns are what (1, 0, 0) ... come from.
glm::dmat3 inverse_of_rows(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    return glm::inverse(glm::transpose(glm::dmat3(a, b, c)));
}

}  // namespace

PixelRays::PixelRays(const StraightCamera& camera) {
    const glm::dvec3 x = matrix_row(camera.to_pixels, 0), y = matrix_row(camera.to_pixels, 1),
                     w = matrix_row(camera.to_pixels, 2), depth(camera.depth);
    orthographic = camera.eye.w == 0;
    if (orthographic) {
        const glm::dmat3 back = inverse_of_rows(x, y, depth);
        across = back[0], down = back[1], along = back[2];
        origin = -back * glm::dvec3(camera.to_pixels[3].x, camera.to_pixels[3].y, camera.depth.w);
        row_x_ = x, row_y_ = y, row_depth_ = depth;
    } else {
        origin = glm::dvec3(camera.eye) / camera.eye.w;
        const glm::dmat3 back = inverse_of_rows(x, y, w);
        // w is the depth but for a factor, which is the same everywhere.
        const double depth_of_w = glm::dot(depth, back[2]);
        across = back[0] / depth_of_w, down = back[1] / depth_of_w, along = back[2] / depth_of_w;
        row_x_ = x * depth_of_w, row_y_ = y * depth_of_w, row_depth_ = w * depth_of_w;
    }
    valid = finite(origin) && finite(along) && finite(across) && finite(down);
}

PixelRays PixelRays::reflected(const MirrorPlane& mirror) const {
    const auto turn = [&mirror](glm::dvec3& v) {
        v -= 2 * glm::dot(mirror.normal, v) * mirror.normal;
    };
    PixelRays result = *this;
    result.after_mirror = !after_mirror;
    result.origin -= 2 * glm::dot(mirror.normal, origin - mirror.through) * mirror.normal;
    for (glm::dvec3* v : {&result.along, &result.across, &result.down, &result.row_x_,
                          &result.row_y_, &result.row_depth_})
        turn(*v);
    return result;
}

Projected PixelRays::project(const glm::dvec3& p) const {
    const glm::dvec3 from_origin = p - origin;
    const double depth = glm::dot(row_depth_, from_origin);
    return {glm::dot(row_x_, from_origin), glm::dot(row_y_, from_origin), orthographic ? 1 : depth,
            depth};
}

glm::dvec3 PixelRays::point(const glm::dvec2& pixel, double depth) const {
    if (orthographic) return origin + depth * along + pixel.x * across + pixel.y * down;
    return origin + depth * direction(pixel);
}

namespace {

/// Keeps the side where `inside` is not negative. The point where an edge crosses comes out the
/// same whichever of its ends comes first.
template <class Inside>
void cut(std::vector<Projected>& polygon, const Inside& inside) {
    std::vector<Projected> kept;
    kept.reserve(polygon.size() + 2);
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Projected &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        const double at_a = inside(a), at_b = inside(b);
        if (at_a >= 0) kept.push_back(a);
        if ((at_a >= 0) == (at_b >= 0)) continue;
        const double whole = at_a - at_b;
        const auto between = [&](double from, double to) {
            return (at_a * to - at_b * from) / whole;
        };
        kept.push_back(
            {between(a.x, b.x), between(a.y, b.y), between(a.w, b.w), between(a.depth, b.depth)});
    }
    polygon.swap(kept);
}

}  // namespace

void clip_to_view(std::vector<Projected>& polygon, int width, int height) {
    const double x0 = -margin * width, x1 = (1 + margin) * width, y0 = -margin * height,
                 y1 = (1 + margin) * height;
    bool whole = true;
    for (const Projected& p : polygon)
        whole = whole && p.depth >= nearest_depth && p.x >= x0 * p.w && p.x <= x1 * p.w &&
                p.y >= y0 * p.w && p.y <= y1 * p.w;
    if (whole) return;
    cut(polygon, [](const Projected& p) { return p.depth - nearest_depth; });
    cut(polygon, [&](const Projected& p) { return p.x - x0 * p.w; });
    cut(polygon, [&](const Projected& p) { return x1 * p.w - p.x; });
    cut(polygon, [&](const Projected& p) { return p.y - y0 * p.w; });
    cut(polygon, [&](const Projected& p) { return y1 * p.w - p.y; });
}

PixelBox common_box(const PixelBox& a, const PixelBox& b) {
    return {std::max(a.left, b.left), std::max(a.top, b.top), std::min(a.right, b.right),
            std::min(a.bottom, b.bottom)};
}

PixelBox pixel_box(const PixelRays& rays, const Bounds& bounds, int width, int height) {
    const PixelBox whole{0, 0, width, height};
    if (!finite(bounds.low) || !finite(bounds.high)) return whole;
    PixelBox box{width, height, 0, 0};
    const auto corner = [&](int i) { return rays.project(corner_of(bounds, i)); };
    constexpr int sides[6][4] = {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                 {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}};
    std::vector<Projected> polygon;
    const auto include = [&](const Projected& p) {
        const glm::dvec2 pixel = p.pixel();
        if (std::isnan(pixel.x) || std::isnan(pixel.y)) return void(box = whole);  // 0 / 0
        const glm::dvec2 within = glm::clamp(pixel, glm::dvec2(0), glm::dvec2(width, height));
        box.left = std::min(box.left, static_cast<int>(std::floor(within.x)));
        box.top = std::min(box.top, static_cast<int>(std::floor(within.y)));
        box.right = std::max(box.right, static_cast<int>(std::ceil(within.x)));
        box.bottom = std::max(box.bottom, static_cast<int>(std::ceil(within.y)));
    };
    // What is seen of a box lies within the hull of its sides in front of the eye; all around the
    // eye it is everywhere.
    bool in_front = false, behind = false;
    for (int i = 0; i < 8; ++i) (corner(i).depth >= nearest_depth ? in_front : behind) = true;
    if (in_front && behind && glm::all(glm::lessThanEqual(bounds.low, rays.origin)) &&
        glm::all(glm::lessThanEqual(rays.origin, bounds.high)))
        return whole;
    for (const auto& side : sides) {
        polygon.clear();
        for (int i : side) polygon.push_back(corner(i));
        clip_to_view(polygon, width, height);
        for (const Projected& p : polygon) include(p);
    }
    return box;
}

double greatest_nearness(const PixelRays& rays, const Bounds& bounds) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    // POV-Ray knows its bounding boxes in single precision.
    constexpr double doubt = 1e-6;
    if (!finite(bounds.low) || !finite(bounds.high)) return infinity;
    const glm::dvec3 slack = doubt * glm::max(glm::abs(bounds.low), glm::abs(bounds.high));
    const Bounds box{bounds.low - slack, bounds.high + slack};
    double depth = infinity;
    for (int i = 0; i < 8; ++i) depth = std::min(depth, rays.project(corner_of(box, i)).depth);
    if (!rays.orthographic && depth < nearest_depth) return infinity;
    const double nearness = rays.nearness(depth);
    return nearness + doubt * std::abs(nearness);
}

}  // namespace povpreview
