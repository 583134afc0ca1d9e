// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "display/gl_context.h"
#include "display/gl_objects.h"

namespace povpreview::items {

/// The framebuffer that items are drawn into: the texel of the label that is seen, and
/// depth. GL's
/// lowest row is the image's top.
class ItemTarget {
   public:
    /// Throws Error if GL cannot make it.
    ItemTarget(GlContext& context, int width, int height);

    int width() const { return width_; }
    int height() const { return height_; }

    /// Makes it the target of drawing, whole, and clears it: `item` everywhere, infinitely far.
    void begin(std::uint32_t item) const;
    /// What was drawn, row by row from the top.
    std::vector<std::uint32_t> read() const;

    GLuint items() const { return items_.id(); }
    GLuint depths() const { return depths_.id(); }

   private:
    GlContext& context_;
    const GlFunctions& gl_;
    int width_, height_;
    GlTexture items_, depths_;
    GlFramebuffer framebuffer_;
};

/// Throws Error(Exit::usage) if the bound framebuffer is not complete or GL reports an error.
void check_framebuffer(const GlContext& context, const char* what, int width, int height);

/// An empty texture of unfiltered texels, bound.
void make_texture(const GlFunctions& gl, const GlTexture& texture, GLint internal, int width,
                  int height, GLenum format, GLenum type, const void* texels = nullptr);

}  // namespace povpreview::items
