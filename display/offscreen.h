// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "core/picture.h"
#include "core/previewer.h"
#include "display/canvas.h"
#include "display/gl_context.h"
#include "display/image.h"
#include "display/painter.h"

namespace povpreview {

/// Draws pictures without a window.
class Offscreen {
   public:
    explicit Offscreen(std::unique_ptr<GlContext> context);
    ~Offscreen();

    /// The picture magnified or shrunk to `width` x `height` pixels, in linear light; unclamped, or
    /// cut to what a display can show before samples are averaged.
    /// `samples_per_pixel` above 1 smooths the edges of triangles and is cut to what the context
    /// offers (4 with Mesa in software). With 1, at the picture's own size, known pixels come back
    /// bit by bit. Drawn in tiles, so GL's limits do not matter; throws Error for sizes below 1 or
    /// of more than 2^16 - 1 a side or 2^28 pixels, and when memory runs out.
    Image render(const Picture& picture, int width, int height, int samples_per_pixel = 1,
                 Overlay overlay = Overlay::none, Range range = Range::unclamped);

    /// Which context draws.
    const std::string& description() const { return context_->description(); }

   private:
    void prepare(int width, int height, int samples);

    std::unique_ptr<GlContext> context_;
    std::optional<Painter> painter_;
    std::optional<Canvas> canvas_;
    int samples_asked_ = 0;  ///< for the canvas, which may have fewer
};

}  // namespace povpreview
