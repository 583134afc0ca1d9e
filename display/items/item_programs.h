// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <initializer_list>

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
    template <class Instance>
    void draw_instances(const GlProgram& program, const GlVertexArray& array,
                        const GlBuffer& buffer, const std::vector<Instance>& instances);
    /// Where a vertex attribute lies in an instance, and how many values it has.
    struct Attribute {
        GLint values;
        std::size_t at;
    };
    void declare_instances(const GlVertexArray& array, const GlBuffer& buffer, std::size_t stride,
                           std::initializer_list<Attribute> floats,
                           const Attribute& integers) const;
    void set_uniforms(const GlProgram& program, const PixelRays& rays, int width, int height) const;

    GlContext& context_;
    const GlFunctions& gl_;
    GlProgram faces_, spheres_, capped_, unknown_, simple_objects_, objects_, torus_objects_;
    GlTexture records_;
    GlBuffer record_buffer_, corner_buffer_, sphere_buffer_, capped_buffer_;
    GlVertexArray corner_array_, sphere_array_, capped_array_;
};

}  // namespace povpreview::items
