// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>

#include "core/detail/drawable_scene.h"
#include "display/items/pixel_rays.h"

namespace povpreview::items {

/// How the rays of pixels run near an object, in a frame around it that 32-bit floats are fine
/// enough for: q = (p - centre) / size. The ray of a pixel, (x, y) from `reference`, is
///
///     q = base + base_factor (x across + y down)
///         + s (direction + direction_factor (x across + y down))      at depth + s size
///
///                  | base            Where the object is in front of the eye, rays start on the
///     eye <:-------o--( object )     plane of its centre, so that nothing large is subtracted
///          `-------|--(--------)     from anything large; where the eye is in its midst, at the
///             depth|                 eye.
struct LocalFrame {
    LocalFrame(const PixelRays& rays, const Bounds& bounds, int width, int height);

    /// Of finite numbers; where not, the object cannot be drawn.
    bool valid() const;

    glm::dvec3 centre{};
    double size = 1;
    glm::dvec2 reference{};  ///< pixels
    double depth = 0;
    glm::dvec3 base{}, direction{};
    double base_factor = 0, direction_factor = 0;
};

bool is_finite(const Bounds& bounds);

/// A convex polygon of the image that holds all pixel centres whose rays may meet the box in front
/// of the eye; empty if there are none.
std::vector<glm::dvec2> outline_of(const PixelRays& rays, const Bounds& bounds, int width,
                                   int height);
/// The same for a box by its corners; bits of their numbers: which end along its sides.
std::vector<glm::dvec2> outline_of(const PixelRays& rays, const std::array<glm::dvec3, 8>& box,
                                   int width, int height);

}  // namespace povpreview::items
