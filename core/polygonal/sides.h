// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

/// On which side of a plane a point lies, decided exactly (CGAL's filtered kernel behind it).
///
/// A viewpoint is homogeneous: (x, y, z, 1) is a point, (x, y, z, 0) lies infinitely far in that
/// direction: a parallel light, or the eye of an orthographic camera.
namespace povpreview {

/// +1 where the viewpoint sees a, b, c clockwise, -1 counter-clockwise, 0 in one plane with them.
/// Laws: unchanged by turning a, b, c around, negated by swapping two of them.
int exact_side(const glm::dvec4& viewpoint, const glm::dvec3& a, const glm::dvec3& b,
               const glm::dvec3& c);

/// From the viewpoint to a point, or the way that its light takes there if it is far away.
inline glm::dvec3 sight_line(const glm::dvec4& viewpoint, const glm::dvec3& p) {
    return viewpoint.w * p - glm::dvec3(viewpoint);
}

/// Whether coordinates can be computed with: no NaN, no infinity, and small enough for products of
/// three of them.
inline bool usable(const glm::dvec3& p) {
    constexpr double largest = 1e60;
    return std::abs(p.x) < largest && std::abs(p.y) < largest && std::abs(p.z) < largest;
}
/// The same of a viewpoint, which must be a point or have a direction.
inline bool usable(const glm::dvec4& v) {
    return usable(glm::dvec3(v)) && (v.w == 1 || (v.w == 0 && glm::dvec3(v) != glm::dvec3(0)));
}

}  // namespace povpreview
