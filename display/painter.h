// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <memory>

#include "core/picture.h"
#include "core/previewer.h"
#include "display/gl_context.h"

namespace povpreview {

/// Which light is drawn. Where samples of a pixel or pixels are averaged afterwards, what a display
/// cannot show must be cut off before: else the rim of a light ten times as bright as white would
/// come out white wherever a tenth of the pixel is covered, and look ragged.
enum class Range { unclamped, display };

/// The part of a magnified picture that the viewport, which starts at (0, 0), shows.
struct View {
    int width, height;            ///< of the whole picture as drawn, target pixels
    int x = 0, y = 0;             ///< upper left corner of the part, target pixels
    int tile_width, tile_height;  ///< of the part, and of the viewport, target pixels
    bool top_row_first = true;    ///< GL's lowest row shows the top: for reading back row by row
    Range range = Range::unclamped;
};

/// Draws pictures into the current framebuffer, which takes linear light.
///
/// Triangles are vector data: they stay crisp at any size, and their colours are interpolated in
/// linear light. Known pixels lie over them as squares with hard sides, then comes the overlay.
class Painter {
   public:
    /// Draws with `context`, which must be current for every call.
    explicit Painter(GlContext& context);
    ~Painter();

    /// Takes over the picture to draw; it need not live on.
    void load(const Picture& picture);
    /// Draws the picture loaded last. Of its overlays only what `overlay` names: all edges, the
    /// constrained ones alone, or the positions of samples.
    void draw(const View& view, Overlay overlay) const;

   private:
    struct Layers;
    std::unique_ptr<Layers> layers_;
};

}  // namespace povpreview
