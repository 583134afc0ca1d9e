// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <vector>

namespace povpreview {

/// A raster of colours, row by row from the top. Linear light unless its maker says otherwise.
struct Image {
    int width = 0, height = 0;
    std::vector<glm::vec3> pixels;

    Image() = default;
    Image(int w, int h, glm::vec3 colour = {})
        : width(w), height(h), pixels(static_cast<std::size_t>(w) * h, colour) {}

    glm::vec3& at(int x, int y) { return pixels[static_cast<std::size_t>(y) * width + x]; }
    const glm::vec3& at(int x, int y) const {
        return pixels[static_cast<std::size_t>(y) * width + x];
    }
};

}  // namespace povpreview
