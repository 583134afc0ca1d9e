// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "core/detail/item_canvas.h"
#include "core/detail/painting_pace.h"
#include "core/detail/pixel_rays.h"

namespace povpreview {

/// Draws the curved objects, by the rays of the pixels that may show them, and then hides what the
/// scene's unknown boxes may hide from those rays. An object that would take too long is taken for
/// unknown. Ends early when it is stopped.
void draw_curved(const DrawableScene& scene, const PixelRays& rays, ItemCanvas& canvas,
                 const PaintingPace& pace);

}  // namespace povpreview
