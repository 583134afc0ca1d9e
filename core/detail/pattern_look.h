// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>
#include <optional>

#include "core/detail/drawable_scene.h"

namespace povpreview {

/// Linear albedo of a surface with a pattern of colours at two points in world space, just before
/// and just behind it: what POV-Ray 3.7's checker, brick and hexagon have there, with the same
/// nudges, so that surfaces in a border (checkers on the plane y = 0) take the colour that they
/// take there.
///
/// Nothing where the two differ: the surface lies in a border of the pattern, and a ray's rounding
/// would decide, all over it. Nothing where a point is so far out in the pattern that POV-Ray's
/// integers no longer hold it, and where anything is amiss: numbers that are not finite, bricks of
/// no size. Any input is safe.
std::optional<glm::vec3> pattern_albedo(const PatternLook& look, const glm::dvec3& before,
                                        const glm::dvec3& behind);

}  // namespace povpreview
