// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <memory>

#include "core/detail/item_buffer.h"
#include "display/gl_context.h"

namespace povpreview {

/// Draws the item buffer of a scene: what each pixel's centre shows, without tracing.
///
/// Polygons are rasterised; curved objects are found by their pixels' rays in fragment shaders. On
/// borders between surfaces, and where two surfaces coincide, single pixels may show the one or the
/// other as 32-bit floats have it; where conditions of pieces cannot be told in floats, and where
/// data makes no sense (numbers that are none, indices out of range), the surface is unknown.
class ItemPainter {
   public:
    /// Compiles all that paint() needs, which takes a second or so in software. Every call makes
    /// `context` current on the calling thread.
    explicit ItemPainter(GlContext& context);
    ~ItemPainter();

    /// Throws Error if GL cannot hold the image or the scene.
    ItemBuffer paint(const DrawableScene& scene);

   private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace povpreview
