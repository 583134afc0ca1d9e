// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "core/detail/drawable_scene.h"
#include "display/items/draw_lists.h"

namespace povpreview::items {

/// Adds the visible faces to the lists. Record of a face, in texels:
///
///     reference x, y (pixels); v there; -
///     dv/dx, dv/dy; -; -
///     label: surface; look; -; -
///
/// where v, over the face linear in the image, is nearest_depth / depth under a perspective camera
/// (0 at the horizon) and the depth itself under an orthographic one. Faces with texture
/// coordinates, one record per triangle, have u and v of the texture in the same way, each times
/// nearest_depth / depth in perspective:
///
///     u at the reference, du/dx, du/dy; v at the reference
///     dv/dx, dv/dy; -; -
void list_faces(const DrawableScene& scene, const PixelRays& rays, DrawLists& lists);

/// Whether the face's image is laid by texture coordinates of its corners.
bool has_uv_image(const DrawableScene& scene, std::uint32_t material);

/// A material as the lists name looks.
std::uint32_t look_of(std::uint32_t material);

}  // namespace povpreview::items
