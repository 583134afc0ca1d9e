// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "core/detail/drawable_scene.h"

namespace povpreview {

/// Linear albedo of an image-mapped surface at a point: what POV-Ray 3.7's image_map pigment has
/// there (its map types, interpolations, `once`), also where the bicubic interpolation overshoots
/// to below 0.
///
/// Nothing outside of a `once` map and where the mapping itself has no value (on the axis of a
/// cylinder, say); where the image is not opaque; and where anything is amiss: an image that is
/// missing, empty or not of its size, numbers that are not finite. Any input is safe.
///
/// `point` is in world space; for Mapping::uv, `uv` takes its place.
std::optional<glm::vec3> image_albedo(const DrawableScene& scene, const ImageLook& look,
                                      const glm::dvec3& point, const glm::dvec2& uv);

}  // namespace povpreview
