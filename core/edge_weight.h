// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cmath>
#include <glm/vec3.hpp>

namespace povpreview {

/// How badly an edge wants a sample in its middle.
enum class WeightKind {
    paper,  ///< l + d, as printed (section 2)
    area    ///< l^2 (k + sqrt d): the error that an edge leaves grows with the area around it
};

/// The paper's colour norm (section 2), squared differences weighted by the eye's sensitivity. Here
/// it is taken of display-encoded colour in [0, 1], since it is the displayed error that counts.
inline float colour_distance(const glm::vec3& a, const glm::vec3& b) {
    const glm::vec3 d = a - b;
    return .3f * d.x * d.x + .59f * d.y * d.y + .11f * d.z * d.z;
}

/// What an edge between equal colours weighs against one between black and white: how far blank
/// areas are searched for what the samples have missed so far. Best of .005 to .1 on rendered
/// scenes.
inline constexpr float blank_share = .02f;

/// Weight of an edge; `length` over the larger image side, `distance` from colour_distance().
inline float edge_weight(WeightKind kind, float length, float distance) {
    if (kind == WeightKind::paper) return length + distance;
    return length * length * (blank_share + std::sqrt(distance));
}

}  // namespace povpreview
