// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <atomic>

#include "core/detail/item_buffer.h"

namespace povpreview {

/// What each pixel's centre shows of a scene, found without tracing: polygons are rasterised,
/// curved objects are met by the pixels' rays, and images are looked up where they are seen. Where
/// two surfaces coincide, and where the data makes no sense, the surface is unknown. Flat mirrors
/// are painted with what they show.
///
/// Everything is computed in double precision on the calling thread, since fragment shaders proved
/// to be slower where there is no GPU, and no faster than needed where there is one. Equal scenes
/// give equal buffers. Ends early, with a result of no use, when `stop` is set.
ItemBuffer paint_items(const DrawableScene& scene, const std::atomic<bool>& stop);

}  // namespace povpreview
