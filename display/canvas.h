// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>

#include "display/gl_context.h"
#include "display/gl_objects.h"
#include "display/image.h"

namespace povpreview {

/// A framebuffer of linear, unclamped 32-bit floats, with several samples per pixel if wanted.
class Canvas {
   public:
    /// `samples` per pixel: 1, or as many as asked for but no more than the context offers.
    /// Throws Error if GL cannot make it.
    Canvas(GlContext& context, int width, int height, int samples);

    int width() const { return width_; }
    int height() const { return height_; }
    int samples() const { return samples_; }

    /// Makes it the target of drawing, with a viewport over all of it, and clears it to black.
    void begin() const;
    /// Averages the samples of each pixel, in linear light, into texture().
    void resolve() const;
    /// The picture after resolve(); RGBA, 32-bit float.
    GLuint texture() const { return texture_.id(); }
    /// Copies the first `width` x `height` pixels after resolve() to (x, y) in `image`, GL's lowest
    /// row first.
    void read(Image& image, int x, int y, int width, int height) const;

   private:
    void attach_texture() const;
    void attach_multisamples();
    void check(const char* what) const;

    GlContext& context_;
    const GlFunctions& gl_;
    int width_, height_, samples_;
    GlTexture texture_;
    GlFramebuffer resolved_;
    std::optional<GlRenderbuffer> multisamples_;
    std::optional<GlFramebuffer> target_;
};

}  // namespace povpreview
