// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "core/detail/item_canvas.h"
#include "core/detail/painting_pace.h"
#include "core/detail/pixel_rays.h"

namespace povpreview {

/// Draws the faces that the rays see: a pixel shows a face if its centre does. Of two faces that
/// share an edge exactly one takes a centre on it. Ends early when it is stopped.
void draw_faces(const PolygonScene& scene, const PixelRays& rays, ItemCanvas& canvas,
                const PaintingPace& pace);

}  // namespace povpreview
