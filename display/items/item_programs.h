// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "display/gl_context.h"
#include "display/gl_objects.h"
#include "display/items/draw_lists.h"

namespace povpreview::items {

/// Draws lists into the current framebuffer by depth.
class ItemPrograms {
   public:
    explicit ItemPrograms(GlContext& context);

    /// Throws Error if GL cannot hold the lists. Leaves the records bound to texture unit 0.
    void draw(DrawLists& lists, const PixelRays& rays, int width, int height);

   private:
    void upload_records(Records& records);
    void draw_corners(const GlProgram& program, const std::vector<ItemCorner>& corners);
    void draw_spheres(const std::vector<SphereInstance>& spheres);
    void set_uniforms(const GlProgram& program, const PixelRays& rays, int width, int height) const;

    GlContext& context_;
    const GlFunctions& gl_;
    GlProgram faces_, spheres_, unknown_, simple_objects_, objects_, torus_objects_;
    GlTexture records_;
    GlBuffer corner_buffer_, sphere_buffer_;
    GlVertexArray corner_array_, sphere_array_;
};

}  // namespace povpreview::items
