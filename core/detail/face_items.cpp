// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/detail/face_items.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>

#include "core/detail/row_bands.h"

namespace povpreview {

namespace {

/// A linear function of the pixel: the nearness of a plane.
struct Nearness {
    double base, across, down;
};

/// Of the plane through a face; nothing where the face is seen edge-on or is none.
std::optional<Nearness> nearness_of(const PolygonScene& scene, const Face& face,
                                    const PixelRays& rays) {
    // Newell's normal, with corners as seen from the camera, so that far from the origin of the
    // world nothing is lost.
    glm::dvec3 normal(0), middle(0);
    glm::dvec3 before = scene.corner(face, face.count - 1) - rays.origin;
    for (std::size_t i = 0; i < face.count; ++i) {
        const glm::dvec3 corner = scene.corner(face, i) - rays.origin;
        normal += glm::cross(before - corner, before + corner);
        middle += corner;
        before = corner;
    }
    const double offset = glm::dot(normal, middle) / double(face.count);
    const double along = glm::dot(normal, rays.along), across = glm::dot(normal, rays.across),
                 down = glm::dot(normal, rays.down);
    //  normal (depth (along + px across + py down)) = offset, or orthographic
    //  normal (depth along + px across + py down) = offset
    const Nearness result = rays.orthographic
                                ? Nearness{-offset / along, across / along, down / along}
                                : Nearness{along / offset, across / offset, down / offset};
    if (!std::isfinite(result.base + result.across + result.down)) return std::nullopt;
    return result;
}

/// Where an edge crosses a row; the same from whichever side it is looked at.
double crossing(const glm::dvec2& a, const glm::dvec2& b, double y) {
    const glm::dvec2 &p = a.y < b.y ? a : b, &q = a.y < b.y ? b : a;
    return p.x + (y - p.y) / (q.y - p.y) * (q.x - p.x);
}

/// First pixel of which the centre does not lie before `x`, kept within [first, last].
int first_from(double x, int first, int last) {
    return static_cast<int>(std::clamp(std::ceil(x - .5), double(first), double(last)));
}

void draw_polygon(const std::vector<glm::dvec2>& corners, const Nearness& plane,
                  ItemCanvas::Source source, ItemCanvas& canvas, const PaintingPace& pace) {
    double top = corners[0].y, bottom = top;
    for (const glm::dvec2& p : corners) {
        top = std::min(top, p.y);
        bottom = std::max(bottom, p.y);
    }
    const PixelBox& area = canvas.area();
    const int last = first_from(bottom, area.top, area.bottom);
    for (int y = first_from(top, area.top, area.bottom); y < last; ++y) {
        const double row = y + .5;
        double left = std::numeric_limits<double>::infinity(), right = -left;
        for (std::size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++) {
            if ((corners[i].y <= row) == (corners[j].y <= row)) continue;
            const double x = crossing(corners[i], corners[j], row);
            left = std::min(left, x);
            right = std::max(right, x);
        }
        if (!(left <= right)) continue;
        const int end = first_from(right, area.left, area.right);
        canvas.draw_row(
            y, first_from(left, area.left, area.right), end,
            [&](int x) { return plane.base + plane.across * (x + .5) + plane.down * row; }, source);
        pace.row_done();
    }
}

void draw_in_band(const PolygonScene& scene, const PixelRays& rays, ItemCanvas& canvas,
                  const PaintingPace& pace) {
    std::vector<Projected> clipped;
    std::vector<glm::dvec2> corners;
    for (std::size_t f = 0; f < scene.faces.size() && !pace.stopped(); ++f) {
        const Face& face = scene.faces[f];
        const bool seen = rays.after_mirror ? face.reflected : face.visible;
        if (!seen || face.count < 3) continue;
        clipped.clear();
        for (std::size_t i = 0; i < face.count; ++i)
            clipped.push_back(rays.project(scene.corner(face, i)));
        clip_to_view(clipped, canvas.width(), canvas.height());
        if (clipped.size() < 3) continue;
        const auto plane = nearness_of(scene, face, rays);
        if (!plane) continue;
        corners.clear();
        bool sound = true;
        for (const Projected& p : clipped) {
            corners.push_back(p.pixel());
            sound = sound && std::isfinite(corners.back().x + corners.back().y);
        }
        if (sound) draw_polygon(corners, *plane, static_cast<ItemCanvas::Source>(f), canvas, pace);
    }
}

}  // namespace

void draw_faces(const PolygonScene& scene, const PixelRays& rays, ItemCanvas& canvas,
                const PaintingPace& pace) {
    const PixelBox& area = canvas.area();
    draw_bands(canvas, rows_for_threads(area.bottom - area.top),
               [&](ItemCanvas& band) { draw_in_band(scene, rays, band, pace); });
}

}  // namespace povpreview
