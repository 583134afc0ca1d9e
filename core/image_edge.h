// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

namespace povpreview {

/// What makes the image jump at an edge.
enum class EdgeKind : std::uint8_t {
    geometric,   ///< silhouette, crease or border of a surface, or where two surfaces meet
    shadow,      ///< border of a shadow
    reflection,  ///< either of them, seen in a mirror
    traced       ///< found by tracing; of any origin
};
inline constexpr std::size_t edge_kinds = 4;

/// A straight piece of a discontinuity in the image, known before any sample is traced.
struct ImageEdge {
    glm::dvec2 from, to;  ///< pixel coordinates, inside the image or on its border
    EdgeKind kind = EdgeKind::geometric;
    std::uint16_t light = 0;  ///< shadows and their reflections: the number of the light
    float importance = 1;  ///< expected jump, 0..1: what the piece weighs for each pixel of length
};

/// Pieces joined end to end: what becomes a chain of constraints in the mesh.
struct EdgeChain {
    std::vector<glm::dvec2> vertices;  ///< at least two; closed where the last equals the first
    EdgeKind kind = EdgeKind::geometric;
    std::uint16_t light = 0;
    float weight = 0;  ///< importance x length, pixels: its place in the order of insertion
};

}  // namespace povpreview
