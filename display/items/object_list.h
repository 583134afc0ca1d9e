// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "core/detail/drawable_scene.h"
#include "display/items/draw_lists.h"

namespace povpreview::items {

/// Adds the objects to the lists, and the boxes of what is unknown; objects that cannot be made
/// sense of are unknown too. Record of an object, in texels:
///
///     reference x, y (pixels); depth there; size              (see LocalFrame)
///     base; base factor
///     direction; direction factor
///     first texel of its pieces, their number; -, -
///
/// of a piece, its label: surface; look; first texel of its solid; first texel of its tests, or ~0
/// of a test: first texel of its solid; whether inverted; texel of the next test if inside, if
/// outside (see ConditionTest)
/// of a solid (see CanonicalSolid), rows of its linear part with its offset:
///
///     row x; offset x
///     row y; offset y
///     row z; offset z
///     signs + 1, two bits each, or ~0 for a torus; slope; constant; -
///
/// of an unknown box: the first three texels of an object, then low and high, a texel each, in its
/// local frame.
void list_objects(const DrawableScene& scene, const PixelRays& rays, DrawLists& lists);

}  // namespace povpreview::items
