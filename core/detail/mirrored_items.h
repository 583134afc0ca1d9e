// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <atomic>

#include "core/detail/item_buffer.h"
#include "core/detail/item_canvas.h"
#include "core/detail/pixel_rays.h"

namespace povpreview {

/// Finds what flat mirrors show: `mirrors` and `mirrored` of a buffer whose other parts were read
/// from the canvas. For each mirror the scene is drawn again, as seen from behind it.
///
///          eye      | mirror    p          The eye sees p where the line from its mirror image
///             \     |         .'           crosses the mirror; what lies before the mirror on that
///              \    |       .'             line is not there.
///               q   |     .'
///                \  |   .'
///                 \ | .'
///      eye's image  .'
///                .'
///
/// Allocates nothing where nothing is a mirror, as may_mirror() tells beforehand. Ends early, with
/// a result of no use, when `stop` is set.
bool may_mirror(const DrawableScene& scene);
void paint_mirrored(const DrawableScene& scene, const PixelRays& rays, const ItemCanvas& canvas,
                    const std::atomic<bool>& stop, ItemBuffer& items);

}  // namespace povpreview
