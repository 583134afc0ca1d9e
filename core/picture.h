// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <vector>

#include "core/image_edge.h"

namespace povpreview {

class DetailMap;

/// What a previewer shows, ready to draw: triangles, and pixels on top of them. Colours are linear
/// light, positions pixel coordinates (see oracle.h).
struct Picture {
    struct Corner {
        glm::vec2 position;
        glm::vec3 colour;
    };
    /// What a pixel of known detail takes from a corner: colour = albedo * illumination + remainder
    /// where the pixel's albedo is known, else the corner's colour.
    struct Light {
        glm::vec3 illumination{}, remainder{};
        std::uint32_t item = 0xffffffff;  ///< of the corner's surface in the DetailMap, or unknown
        bool shaded = false;              ///< else only the colour is known
    };
    /// A sample that stands for its item where no corner does.
    struct Anchor {
        Corner corner;
        Light light;
    };
    struct Line {
        glm::vec2 from, to;
        bool constraint;
        EdgeKind kind = EdgeKind::traced;  ///< constraints: what they stand for
        std::uint16_t light = 0;           ///< shadows and their reflections: whose
    };

    int width = 0, height = 0;
    std::vector<Corner> corners;  ///< three for each triangle, unshared; colour is interpolated

    /// Pixels whose item is known take only corners of that item; if a face has none, the nearest
    /// anchor of theirs. Null: nothing is known.
    std::shared_ptr<const DetailMap> detail;
    std::vector<Light> lights;                 ///< with `detail`: beside `corners`
    std::vector<Anchor> anchors;               ///< with `detail`: item by item
    std::vector<std::uint32_t> first_anchors;  ///< with `detail`: by item, and the end of the last

    std::vector<glm::vec3> pixels;    ///< row by row from the top; empty, or width x height
    std::vector<std::uint8_t> known;  ///< beside `pixels`: 1 where the pixel hides the triangles

    std::vector<Line> lines;         ///< for overlays: the edges of the triangulation
    std::vector<glm::vec2> samples;  ///< for overlays: where full samples were traced
};

}  // namespace povpreview
