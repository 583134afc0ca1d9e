// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <deque>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <vector>

#include "core/detail/drawable_scene.h"
#include "display/gl_context.h"
#include "display/gl_objects.h"
#include "display/items/item_target.h"
#include "display/items/pixel_rays.h"

namespace povpreview::items {

/// A look with an image, and the part of the image of the scene that shows it.
struct SeenImage {
    std::uint32_t look = 0;             ///< in DrawableScene::looks
    glm::ivec2 low{1 << 30}, high{-1};  ///< first and last pixel
};

/// Draws the albedo of surfaces with image maps, after the items.
class ImagePass {
   public:
    explicit ImagePass(GlContext& context);

    /// Linear albedo, row by row from the top, and 0 where no image was drawn, 1 where one was, 2
    /// where one was that is not opaque there. Images that GL cannot hold, or larger than
    /// most_texels, are left out; one is held at a time. REQUIRES: the items are in `target`, their
    /// records bound to texture unit 0.
    std::vector<glm::vec4> draw(const DrawableScene& scene, const PixelRays& rays,
                                const ItemTarget& target, std::vector<SeenImage> seen);

    static constexpr std::size_t most_texels = std::size_t{1} << 25;  ///< 256 MiB

   private:
    void prepare(int width, int height);
    bool load(const ImageTexels& image);
    void draw_look(const DrawableScene& scene, const PixelRays& rays, const SeenImage& seen);
    void set_rays(const GlProgram& program, const PixelRays& rays,
                  const glm::dmat4x3& to_map) const;

    GlContext& context_;
    const GlFunctions& gl_;
    /// By whether the mapping is by angles, texels a side (1, 2, 4) and whether gamma is 1.
    GlProgram& program(bool angles, int taps, bool linear) {
        return programs_[(angles ? 6u : 0u) + (taps == 4 ? 4u : taps == 2 ? 2u : 0u) + linear];
    }

    std::deque<GlProgram> programs_;
    GlVertexArray no_attributes_;
    GlTexture image_;
    std::optional<GlTexture> albedo_;
    std::optional<GlFramebuffer> framebuffer_;
    int width_ = 0, height_ = 0;
};

}  // namespace povpreview::items
