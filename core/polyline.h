// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <vector>

namespace povpreview {

using Polyline = std::vector<glm::dvec2>;

/// Distance from `p` to the segment a-b (to the point a where they coincide).
double distance_to_segment(glm::dvec2 p, glm::dvec2 a, glm::dvec2 b);

/// Drops vertices such that every dropped one stays within `tolerance` of the segment that replaces
/// it (Douglas and Peucker 1973). Keeps the ends; of a closed polyline (first vertex not repeated)
/// the first vertex and the one farthest from it.
Polyline simplify(const Polyline& line, double tolerance, bool closed);

/// The point where the segment from `inside` to `outside` leaves the rectangle [0, size.x] x
/// [0, size.y]; one of its coordinates is exactly the border's. REQUIRES: `inside` is in it,
/// `outside` is not.
glm::dvec2 clip_to_border(glm::dvec2 inside, glm::dvec2 outside, glm::dvec2 size);

/// A circle, or nothing where three points are collinear as far as numbers can tell.
struct Circle {
    glm::dvec2 centre;
    double radius;
};
std::optional<Circle> circle_through(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c);

/// `p` turned about the circle's centre by `angle` radians, from the x axis towards the y axis.
glm::dvec2 turned(const Circle& circle, glm::dvec2 p, double angle);

/// Angle from `a` to `b` about the circle's centre, in (-pi, pi], from the x axis towards the y
/// axis.
double angle_between(const Circle& circle, glm::dvec2 a, glm::dvec2 b);

}  // namespace povpreview
