// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

// The order of POV-Ray's headers matters: frame.h first, povdebug.h last.
// clang-format off
#include "backend/frame.h"
#include "backend/math/matrices.h"
// clang-format on

#include "backend/oracle/convex.h"

/// From an object's own space to the world; without a transformation they are the same.
namespace povpreview::tracer {

inline Point to_world(const pov::TRANSFORM* transform, const Point& p) {
    if (transform == nullptr) return p;
    const pov::VECTOR local = {p.x, p.y, p.z};
    pov::VECTOR world;
    pov::MTransPoint(world, local, transform);
    return {world[0], world[1], world[2]};
}

/// A plane dot(normal, p) + distance = 0 of the object's own space; normals go by the inverse.
inline Plane plane_to_world(const pov::TRANSFORM* transform, const Point& normal, double distance) {
    Point n = normal;
    double d = distance;
    if (transform != nullptr) {
        const auto& m = transform->inverse;
        const auto row = [&](int i) {
            return m[i][0] * normal.x + m[i][1] * normal.y + m[i][2] * normal.z;
        };
        n = {row(0), row(1), row(2)};
        d += row(3);
    }
    const double size = length(n);
    if (!(size > 0)) return {};
    return {(1 / size) * n, -d / size};
}

}  // namespace povpreview::tracer
