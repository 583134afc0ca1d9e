// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "display/canvas.h"
#include "display/layout.h"
#include "display/painter.h"
#include "display/presenter.h"

namespace povpreview {

/// One picture and its caption in a window's column. Its context must be current for every call.
class WindowPanel {
   public:
    explicit WindowPanel(GlContext& context);

    void load(const Picture& picture, const std::string& caption);
    bool loaded() const { return width_ > 0; }
    /// Draws into the column of a window `window_height` pixels high, with `samples` per pixel.
    void draw(const Presenter& presenter, const Rectangle& column, int window_height,
              Overlay overlay, int samples);

   private:
    void paint(const Rectangle& place, Overlay overlay, int samples);
    void set_caption(int width);

    GlContext& context_;
    Painter painter_;
    std::optional<Canvas> canvas_;
    int samples_asked_ = 0;  ///< for the canvas, which may have fewer
    GlTexture strip_;
    std::string caption_, strip_text_;
    int width_ = 0, height_ = 0;  ///< of the picture
    int strip_width_ = 0, strip_height_ = 0;
    bool no_font_ = false;
};

}  // namespace povpreview
