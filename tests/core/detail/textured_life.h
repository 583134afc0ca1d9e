// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cmath>
#include <vector>

#include "core/colour.h"
#include "core/detail/item_buffer.h"
#include "tests/core/detail/shown_detail.h"
#include "tests/core/function_oracle.h"

namespace povpreview {

/// images::still_life() with the floor's texture told apart from the light on it.
inline FunctionImage textured_life(int width, int height) {
    FunctionImage image = images::still_life(width, height);
    const FunctionImage floor = images::checker(height * .06);
    image.albedo = [surface = image.surface, floor](glm::dvec2 p) {
        return surface(p) == 2 ? floor.colour(p) : glm::vec3(1);
    };
    return image;
}

/// What a painter would say of the image, with the albedo of surface 2.
inline ItemBuffer items_of(const FunctionImage& image, int width, int height) {
    ItemBuffer items{width, height, {}, {}, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const glm::dvec2 centre(x + .5, y + .5);
            items.surfaces.push_back(image.surface(centre));
            items.kinds.push_back(items.surfaces.back() == 2 ? Look::Kind::image
                                                             : Look::Kind::plain);
            items.albedos.push_back(image.albedo(centre));
        }
    return items;
}

/// L1 of what a picture shows, as displayed.
inline double error_of(const Picture& picture, const FunctionImage& image) {
    const std::vector<glm::vec3> shown = test::rasterise_detail(picture);
    double sum = 0;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const glm::vec3 d =
                display_encoded(shown[static_cast<std::size_t>(y * picture.width + x)]) -
                display_encoded(image.colour({x + .5, y + .5}));
            sum += (std::abs(d.x) + std::abs(d.y) + std::abs(d.z)) / 3;
        }
    return sum / (picture.width * picture.height);
}

}  // namespace povpreview
