// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "core/detail/drawable_scene.h"

namespace povpreview::test {

/// Intricate solids by their definitions in drawable_scene.h and without haste: curves are taken
/// for many chords, fields are walked along in many steps.

/// Negative inside; in the solid's frame. Of outlines the sign alone means something.
double plain_value(const DrawableScene& scene, const Solid& solid, const glm::dvec3& p);
/// Where a ray from + t along, in the solid's frame, meets its surface for t in [first, last]; of
/// blobs only what is farther apart than a part in 250 of that.
std::vector<double> plain_roots(const DrawableScene& scene, const Solid& solid,
                                const glm::dvec3& from, const glm::dvec3& along, double first,
                                double last);

}  // namespace povpreview::test
