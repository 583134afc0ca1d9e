// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "core/detail/item_canvas.h"
#include "core/detail/painting_pace.h"
#include "core/detail/pixel_rays.h"

namespace povpreview {

/// Of a canvas, hides what is not nearer than a box in the world of which nothing but its place is
/// known. Ends early when it is stopped.
void hide_behind(const Bounds& box, const PixelRays& rays, ItemCanvas& canvas,
                 const PaintingPace& pace);

}  // namespace povpreview
