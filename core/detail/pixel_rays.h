// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "core/detail/drawable_scene.h"

namespace povpreview {

/// Depths nearer than this, in units of the scene, are all taken for this one.
constexpr double nearest_depth = 1e-15;

/// A point as the camera projects it: pixel = (x / w, y / w). Perspective: w is the depth.
struct Projected {
    double x, y, w, depth;
    glm::dvec2 pixel() const { return {x / w, y / w}; }
};

/// Through a point, across a normal of unit length.
struct MirrorPlane {
    glm::dvec3 through{}, normal{};
};

/// A camera turned around: the points that a place of the image shows, by depth.
///
///     perspective:  origin + depth (along + px across + py down)
///     orthographic: origin + depth along + px across + py down
struct PixelRays {
    explicit PixelRays(const StraightCamera& camera);

    /// The same rays after a mirror: they come from the eye's mirror image, and are where the eye's
    /// rays are after the same depth once those are reflected.
    PixelRays reflected(const MirrorPlane& mirror) const;

    /// Whether the camera could be turned around; if not, nothing else here means anything.
    bool valid = false;
    bool orthographic = false;
    bool after_mirror = false;
    glm::dvec3 origin{}, along{}, across{}, down{};

    Projected project(const glm::dvec3& p) const;
    glm::dvec3 direction(const glm::dvec2& pixel) const {
        return orthographic ? along : along + pixel.x * across + pixel.y * down;
    }
    glm::dvec3 point(const glm::dvec2& pixel, double depth) const;

    /// What is compared in the depth buffer: greater is nearer, and over the pixels that show a
    /// plane it is linear.
    double nearness(double depth) const { return orthographic ? -depth : 1 / depth; }
    double depth(double nearness) const { return orthographic ? -nearness : 1 / nearness; }

   private:
    // Applied to (p - origin): w px, w py, w scaled so that w, or the fourth, is the depth.
    glm::dvec3 row_x_{}, row_y_{}, row_depth_{};
};

/// The part of a convex polygon that is in front of the eye and in the image or a little beside it;
/// empty if there is none. Neighbours that share an edge still share what is left of it, to the
/// bit.
void clip_to_view(std::vector<Projected>& polygon, int width, int height);

/// Pixels [left, right) x [top, bottom).
struct PixelBox {
    int left = 0, top = 0, right = 0, bottom = 0;
};

PixelBox common_box(const PixelBox& a, const PixelBox& b);

/// The pixels that may show something within the bounds.
PixelBox pixel_box(const PixelRays& rays, const Bounds& bounds, int width, int height);

/// Nothing within the bounds is nearer than this; infinity where that is not known.
double greatest_nearness(const PixelRays& rays, const Bounds& bounds);

}  // namespace povpreview
