// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace povpreview {

/// Corners in order around, as indices.
using IndexRing = std::vector<std::uint32_t>;

/// Cuts the inside of a flat polygon (what an odd number of its rings surround) into convex ones.
/// Rings may touch, cross, repeat points and each other, and wind either way. Corners of the pieces
/// are corners of the rings; where rings cross, points are appended to `points`. A polygon without
/// area, or with points that are not finite, gives none.
std::vector<IndexRing> convex_pieces(const std::vector<IndexRing>& rings,
                                     std::vector<glm::dvec3>& points);

}  // namespace povpreview
