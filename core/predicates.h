// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <glm/vec2.hpp>

/// Exact predicates on positions given as doubles (CGAL's filtered kernel behind them).
///
/// "Left" and "counter-clockwise" are meant in the numbers x and y. Pixel coordinates have y down,
/// so on the screen a counter-clockwise triangle runs clockwise.
namespace povpreview {

/// +1 where c lies left of the directed line from a to b, -1 right of it, 0 exactly on it.
/// Laws: orientation(a, b, c) = orientation(b, c, a) = -orientation(b, a, c); it is zero where two
/// of the points are equal.
int orientation(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c);

/// +1 where d lies inside the circle through a, b, c, -1 outside, 0 exactly on it.
/// REQUIRES: orientation(a, b, c) > 0.
int in_circle(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c, glm::dvec2 d);

}  // namespace povpreview
