// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/picture.h"
#include "core/pixel_memory.h"

namespace povpreview {

/// The centre of a pixel, in pixel coordinates.
inline glm::dvec2 pixel_centre(int x, int y) { return {x + .5, y + .5}; }

/// A picture of pixels alone; black where nothing was painted yet.
class PixelCanvas {
   public:
    PixelCanvas(int width, int height)
        : width_(width), height_(height), pixels_(std::size_t(width) * std::size_t(height)) {}

    int width() const { return width_; }
    int height() const { return height_; }
    std::size_t index(int x, int y) const {
        return std::size_t(y) * std::size_t(width_) + std::size_t(x);
    }
    glm::vec3& at(int x, int y) { return pixels_[index(x, y)]; }

    /// Paints pixels [x0, x1) x [y0, y1), which must lie on the canvas.
    void fill(int x0, int y0, int x1, int y1, const glm::vec3& colour) {
        for (int y = y0; y < y1; ++y) std::fill_n(&at(x0, y), x1 - x0, colour);
    }

    Picture picture() const {
        Picture picture;
        picture.width = width_;
        picture.height = height_;
        picture.pixels.assign(pixels_.all().begin(), pixels_.all().end());
        picture.known.assign(pixels_.size(), 1);
        return picture;
    }

   private:
    int width_, height_;
    PixelMemory<glm::vec3> pixels_;
};

}  // namespace povpreview
