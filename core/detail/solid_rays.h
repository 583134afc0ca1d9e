// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "core/detail/intricate_solid.h"
#include "core/detail/pixel_rays.h"
#include "core/detail/wide_vectors.h"

namespace povpreview {

/// Pixels of a row that are worked on at a time: enough for the compiler to use vectors.
inline constexpr int ray_lanes = 16;
using RayLanes = std::array<double, ray_lanes>;

/// The rays of a row of pixels in a solid's own frame: from + x from_step + t (along + x
/// along_step) for the pixel coordinate x and the depth t.
struct RowRays {
    glm::dvec3 from{}, from_step{}, along{}, along_step{};
};

/// `y`: pixel coordinate of the row.
RowRays row_rays(const PixelRays& rays, const glm::dmat4x3& to_frame, double y);

/// The depths where the rays meet the solid's surface, in any order; not-a-number where there are
/// fewer. An array for each time that a ray may. REQUIRES: not is_intricate().
void find_roots(const Solid& solid, const RowRays& rays, const RayLanes& x,
                std::vector<RayLanes>& roots);
/// The same of an intricate one; only those within the bounds, in the world, and if so asked for,
/// only the nearest.
void find_roots(const IntricateSolid& solid, const RowRays& rays, const RayLanes& x,
                const RowRays& in_world, const Bounds& bounds, bool nearest_only,
                std::vector<RayLanes>& roots);

/// Of depths along the rays, see PixelRays::nearness(); negative infinity for what lies behind the
/// eye or is not a number.
void find_nearness(bool orthographic, const RayLanes& depths, RayLanes& nearness);

/// The solid's f at depths along the rays: inside is f <= 0. Where f has no scale of its own, of a
/// cone and a quadric, it is divided by the size of its terms; a half space's is in its frame's.
/// REQUIRES: not is_intricate().
void find_values(const Solid& solid, const RowRays& rays, const RayLanes& x, const RayLanes& t,
                 RayLanes& values);
/// Of an intricate one where a bit of `lanes` is set.
void find_values(const IntricateSolid& solid, const RowRays& rays, const RayLanes& x,
                 const RayLanes& t, std::uint32_t lanes, RayLanes& values);

}  // namespace povpreview
