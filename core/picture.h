// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "core/image_edge.h"

namespace povpreview {

/// What a previewer shows, ready to draw: triangles, and pixels on top of them. Colours are linear
/// light, positions pixel coordinates (see oracle.h).
struct Picture {
    struct Corner {
        glm::vec2 position;
        glm::vec3 colour;
    };
    struct Line {
        glm::vec2 from, to;
        bool constraint;
        EdgeKind kind = EdgeKind::traced;  ///< constraints: what they stand for
        std::uint16_t light = 0;           ///< shadows and their reflections: whose
    };

    int width = 0, height = 0;
    std::vector<Corner> corners;      ///< three for each triangle, unshared; colour is interpolated
    std::vector<glm::vec3> pixels;    ///< row by row from the top; empty, or width x height
    std::vector<std::uint8_t> known;  ///< beside `pixels`: 1 where the pixel hides the triangles

    std::vector<Line> lines;         ///< for overlays: the edges of the triangulation
    std::vector<glm::vec2> samples;  ///< for overlays: where full samples were traced
};

}  // namespace povpreview
