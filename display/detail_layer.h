// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>

#include "core/picture.h"
#include "display/gl_context.h"
#include "display/gl_objects.h"

namespace povpreview {

/// The triangles of pictures with detail (Picture::detail): each pixel takes what it shows from
/// corners on its own surface, and their light instead of their colour where it knows its albedo.
class DetailLayer {
   public:
    /// All calls draw with `context`, which must be current.
    explicit DetailLayer(const GlContext& context);

    /// Whether the picture has detail, and no more pixels than a texture may have.
    bool takes(const Picture& picture) const;
    /// Takes over the triangles of a picture that it takes.
    void load(const Picture& picture);
    /// Draws them; `place` sets a program's uniforms for where they go.
    void draw(const std::function<void(const GlProgram&)>& place) const;

   private:
    void load_triangles(const Picture& picture);
    void load_pixels(const Picture& picture);
    void load_anchors(const Picture& picture);

    const GlContext& context_;
    const GlFunctions& gl_;
    GlProgram even_program_, odd_program_;
    GlVertexArray array_;
    GlBuffer corners_;
    GlTexture items_, albedos_, ranges_, anchors_;
    GLsizei even_ = 0, odd_ = 0;  ///< corners; the even ones come first
};

}  // namespace povpreview
