// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>

namespace povpreview {

/// What a pixel of the completed picture is made of: the full sample at its centre.
struct PixelLight {
    glm::vec3 colour{};       ///< linear light
    float transmittance = 0;  ///< share of the background that shines through, 0..1
    bool known = false;       ///< else the sample has not come, or failed
};

}  // namespace povpreview
