// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <random>

#include "core/picture.h"

namespace povpreview::test {

/// A jittered grid of `columns` x `rows` cells, two triangles each, over the whole picture; corners
/// take their colour from `colour` at their place.
inline Picture jittered_grid(int width, int height, int columns, int rows, unsigned seed,
                             const std::function<glm::vec3(glm::vec2)>& colour) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> jitter(-.35f, .35f);
    std::vector<glm::vec2> nodes;
    for (int j = 0; j <= rows; ++j) {
        for (int i = 0; i <= columns; ++i) {
            const float dx = i > 0 && i < columns ? jitter(random) : 0;
            const float dy = j > 0 && j < rows ? jitter(random) : 0;
            nodes.push_back({(static_cast<float>(i) + dx) * static_cast<float>(width) /
                                 static_cast<float>(columns),
                             (static_cast<float>(j) + dy) * static_cast<float>(height) /
                                 static_cast<float>(rows)});
        }
    }
    Picture picture;
    picture.width = width;
    picture.height = height;
    for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < columns; ++i) {
            const int a = j * (columns + 1) + i, b = a + 1, c = a + columns + 1, d = c + 1;
            for (int node : {a, b, c, c, b, d}) {
                const glm::vec2 place = nodes[static_cast<std::size_t>(node)];
                picture.corners.push_back({place, colour(place)});
            }
        }
    }
    return picture;
}

/// Fills the picture's pixels, known where `known` says so.
inline void fill_pixels(Picture& picture, const std::function<glm::vec3(int, int)>& colour,
                        const std::function<bool(int, int)>& known) {
    picture.pixels.clear();
    picture.known.clear();
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            picture.pixels.push_back(colour(x, y));
            picture.known.push_back(known(x, y) ? 1 : 0);
        }
    }
}

/// Two sides of a straight edge through (top, 0) and (bottom, height), 0 to its left, 1 to its
/// right.
inline Picture step_edge(int width, int height, float top, float bottom) {
    const auto w = static_cast<float>(width), h = static_cast<float>(height);
    const glm::vec3 dark(0), light(1);
    Picture picture;
    picture.width = width;
    picture.height = height;
    picture.corners = {{{0, 0}, dark},       {{top, 0}, dark}, {{0, h}, dark},
                       {{0, h}, dark},       {{top, 0}, dark}, {{bottom, h}, dark},
                       {{top, 0}, light},    {{w, 0}, light},  {{bottom, h}, light},
                       {{bottom, h}, light}, {{w, 0}, light},  {{w, h}, light}};
    return picture;
}

}  // namespace povpreview::test
