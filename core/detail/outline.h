// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "core/detail/bernstein_roots.h"
#include "core/detail/drawable_scene.h"

namespace povpreview {

/// A set of curves in the plane, of cubic Bézier segments; what an odd number of them surround is
/// inside.
class Outline {
   public:
    /// Of u and v by their Bernstein coefficients.
    struct Segment {
        Bernstein<3> u, v;
        glm::dvec2 low, high;  ///< of its control points

        glm::dvec2 at(double s) const {
            return {bernstein_value<3>(u, s).value, bernstein_value<3>(v, s).value};
        }
    };

    /// Four control points (u, v) a segment. REQUIRES: as many numbers.
    explicit Outline(std::span<const double> control_points);

    const std::vector<Segment>& segments() const { return segments_; }
    const glm::dvec2& low() const { return low_; }  ///< of all control points
    const glm::dvec2& high() const { return high_; }

    /// Negative inside, positive outside, 0 where rounding may decide: within 1e-9 of the outline's
    /// size of it.
    double side(const glm::dvec2& p) const;

   private:
    bool surrounds(const glm::dvec2& p) const;

    std::vector<Segment> segments_;
    glm::dvec2 low_{}, high_{};
    double slack_ = 0;
};

}  // namespace povpreview
