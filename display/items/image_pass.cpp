// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/items/image_pass.h"

#include <algorithm>
#include <bit>
#include <glm/glm.hpp>
#include <string>

#include "display/items/image_shaders.h"
#include "display/items/item_shaders.h"

namespace povpreview::items {

namespace {

/// Texels in a row of the image's texture; the shader knows it.
constexpr std::uint32_t texel_row = 2048;

}  // namespace

ImagePass::ImagePass(GlContext& context)
    : context_(context), gl_(context.gl()), no_attributes_(gl_), image_(gl_) {
    for (const char* angles : {"false", "true"})
        for (const char* taps : {"1", "2", "4"})
            for (const char* linear : {"false", "true"})
                programs_.emplace_back(
                    gl_, whole_viewport_shader,
                    (std::string("const bool angles = ") + angles + ";\nconst int taps = " + taps +
                     ";\nconst bool linear = " + linear + ";\n" + shaders::records +
                     shaders::image_inputs + shaders::image_angles + shaders::image_mapping +
                     shaders::image_fragment)
                        .c_str());
}

void ImagePass::prepare(int width, int height) {
    if (!albedo_ || width != width_ || height != height_) {
        framebuffer_.reset();
        albedo_.emplace(gl_);
        make_texture(gl_, *albedo_, GL_RGBA32F, width, height, GL_RGBA, GL_FLOAT);
        framebuffer_.emplace(gl_);
        gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_->id());
        gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, albedo_->id(),
                                 0);
        check_framebuffer(context_, "a buffer of albedo", width, height);
        width_ = width, height_ = height;
    }
    gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_->id());
    gl_.Viewport(0, 0, width, height);
    const GLfloat nothing[4] = {};
    gl_.ClearBufferfv(GL_COLOR, 0, nothing);
}

/// The texels run on from row to row of a texture of one width, of a power of two of rows: so
/// images may be of any shape, and drivers need not compile for each anew.
bool ImagePass::load(const ImageTexels& image) {
    const std::size_t texels = std::size_t{image.width} * image.height;
    if (texels == 0 || texels > most_texels || image.texels.size() != texels) return false;
    const auto whole_rows = static_cast<GLsizei>(texels / texel_row),
               rest = static_cast<GLsizei>(texels % texel_row);
    const auto rows = static_cast<int>(std::bit_ceil(texels / texel_row + (rest ? 1 : 0)));
    if (rows > context_.max_texture_size()) return false;
    make_texture(gl_, image_, GL_RGBA16F, texel_row, rows, GL_RGBA, GL_HALF_FLOAT);
    gl_.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, texel_row, whole_rows, GL_RGBA, GL_HALF_FLOAT,
                      image.texels.data());
    gl_.TexSubImage2D(GL_TEXTURE_2D, 0, 0, whole_rows, rest, 1, GL_RGBA, GL_HALF_FLOAT,
                      image.texels.data() + texels - static_cast<std::size_t>(rest));
    return gl_.GetError() == GL_NO_ERROR;  // out of memory: left out
}

/// The rays in the pigment's space, from the middle of the image.
void ImagePass::set_rays(const GlProgram& program, const PixelRays& rays,
                         const glm::dmat4x3& to_map) const {
    const auto set = [&](const char* name, const glm::dvec3& v) {
        const glm::vec3 f(v);
        gl_.Uniform3f(program.uniform(name), f.x, f.y, f.z);
    };
    const glm::dvec2 middle(width_ / 2, height_ / 2);
    const glm::dmat3 turn(to_map[0], to_map[1], to_map[2]);
    const glm::dvec3 origin = rays.orthographic ? rays.point(middle, 0) : rays.origin;
    set("origin", turn * origin + to_map[3]);
    set("along", turn * rays.direction(middle));
    set("across", turn * rays.across);
    set("down", turn * rays.down);
    set("from_u", to_map[0]);
    set("from_v", to_map[1]);
    set("from_zero", to_map[3]);
    gl_.Uniform2f(program.uniform("middle"), static_cast<float>(middle.x),
                  static_cast<float>(middle.y));
    gl_.Uniform1i(program.uniform("orthographic"), rays.orthographic);
}

void ImagePass::draw_look(const DrawableScene& scene, const PixelRays& rays,
                          const SeenImage& seen) {
    using Mapping = ImageLook::Mapping;
    using Interpolation = ImageLook::Interpolation;
    const ImageLook& look = scene.looks[seen.look].image;
    const ImageTexels& texels = scene.images[look.image];
    const int taps = look.interpolation == Interpolation::none      ? 1
                     : look.interpolation == Interpolation::bicubic ? 4
                                                                    : 2;
    const GlProgram& with = program(look.mapping != Mapping::planar && look.mapping != Mapping::uv,
                                    taps, scene.working_gamma == 1);
    with.use();
    const char* const samplers[] = {"records", "items", "depths", "image"};
    for (int unit = 0; unit < 4; ++unit) gl_.Uniform1i(with.uniform(samplers[unit]), unit);
    set_rays(with, rays, look.to_map);
    gl_.Uniform1f(with.uniform("gamma"), scene.working_gamma);
    gl_.Uniform1ui(with.uniform("look"), seen.look);
    gl_.Uniform1i(with.uniform("mapping"), static_cast<int>(look.mapping));
    gl_.Uniform1i(with.uniform("interpolation"), static_cast<int>(look.interpolation));
    gl_.Uniform1i(with.uniform("once"), look.once);
    gl_.Uniform2i(with.uniform("size"), static_cast<GLint>(texels.width),
                  static_cast<GLint>(texels.height));
    const glm::ivec2 size = seen.high - seen.low + 1;
    gl_.Scissor(seen.low.x, seen.low.y, size.x, size.y);
    gl_.DrawArrays(GL_TRIANGLES, 0, 3);
}

std::vector<glm::vec4> ImagePass::draw(const DrawableScene& scene, const PixelRays& rays,
                                       const ItemTarget& target, std::vector<SeenImage> seen) {
    gl_.ActiveTexture(GL_TEXTURE3);  // what is made is bound there, the records stay
    prepare(target.width(), target.height());
    const auto image_of = [&](const SeenImage& part) { return scene.looks[part.look].image.image; };
    std::sort(seen.begin(), seen.end(),
              [&](const SeenImage& a, const SeenImage& b) { return image_of(a) < image_of(b); });

    gl_.ActiveTexture(GL_TEXTURE1);
    gl_.BindTexture(GL_TEXTURE_2D, target.items());
    gl_.ActiveTexture(GL_TEXTURE2);
    gl_.BindTexture(GL_TEXTURE_2D, target.depths());
    gl_.ActiveTexture(GL_TEXTURE3);
    gl_.BindVertexArray(no_attributes_.id());
    gl_.Enable(GL_SCISSOR_TEST);
    bool loaded = false;
    for (std::size_t i = 0; i < seen.size(); ++i) {
        const std::uint32_t image = image_of(seen[i]);
        if (image >= scene.images.size()) continue;
        if (i == 0 || image != image_of(seen[i - 1])) loaded = load(scene.images[image]);
        if (loaded) draw_look(scene, rays, seen[i]);
    }
    gl_.Disable(GL_SCISSOR_TEST);

    std::vector<glm::vec4> albedo(static_cast<std::size_t>(width_) * height_);
    gl_.ReadPixels(0, 0, width_, height_, GL_RGBA, GL_FLOAT, albedo.data());
    // Holds little until the next time.
    make_texture(gl_, image_, GL_RGBA16F, 1, 1, GL_RGBA, GL_HALF_FLOAT);
    for (const GLenum unit : {GL_TEXTURE3, GL_TEXTURE2, GL_TEXTURE1, GL_TEXTURE0}) {
        gl_.ActiveTexture(unit);
        gl_.BindTexture(GL_TEXTURE_2D, 0);
    }
    return albedo;
}

}  // namespace povpreview::items
