// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "display/gl_context.h"
#include "display/gl_objects.h"
#include "display/layout.h"

namespace povpreview {

/// Puts textures of linear light on the screen: clamped, sRGB-encoded, and where there are fewer
/// pixels than texels, averaged by area in linear light.
class Presenter {
   public:
    explicit Presenter(GlContext& context);

    /// Clears the whole window.
    void begin(int width, int height) const;
    /// `texture`, whose first row is its top, over `place` in a window `window_height` high. At
    /// equal sizes texels and pixels coincide.
    void draw(GLuint texture, const Rectangle& place, int window_height) const;

   private:
    const GlFunctions& gl_;
    GlProgram program_;
    GlVertexArray no_attributes_;
};

}  // namespace povpreview
