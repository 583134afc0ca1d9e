// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "core/detail/drawable_scene.h"

namespace povpreview::items {

/// A solid in the form that shaders take: with p = linear_part q + offset for a point q relative to
/// `centre`, in units of `size`, it is the points where
///
///     signs.x p.x^2 + signs.y p.y^2 + signs.z p.z^2 + slope p.z + constant <= 0
///
/// with signs of -1, 0 and 1, or that torus, around the y axis, of minor radius `constant`.
struct CanonicalSolid {
    CanonicalSolid(const Solid& solid, const glm::dvec3& centre, double size);

    bool valid() const;  ///< of finite numbers

    glm::dmat3 linear_part{1};
    glm::dvec3 offset{};
    glm::dvec3 signs{};
    double slope = 0, constant = 0;
    bool torus = false;

   private:
    void set_quadric(const Solid& solid);
};

}  // namespace povpreview::items
