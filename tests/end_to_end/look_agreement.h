// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>

#include "tests/end_to_end/drawable_agreement.h"

namespace povpreview {

/// The albedo that an image look says is seen, linear; nothing outside of an image used once.
/// REQUIRES: the material's look is an image.
std::optional<glm::dvec3> image_albedo(const DrawableScene& scene, const Seen& seen);

}  // namespace povpreview
