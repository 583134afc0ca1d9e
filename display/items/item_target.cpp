// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/items/item_target.h"

#include <string>

#include "core/error.h"

namespace povpreview::items {

void make_texture(const GlFunctions& gl, const GlTexture& texture, GLint internal, int width,
                  int height, GLenum format, GLenum type, const void* texels) {
    gl.BindTexture(GL_TEXTURE_2D, texture.id());
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl.TexImage2D(GL_TEXTURE_2D, 0, internal, width, height, 0, format, type, texels);
    for (GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        gl.TexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
}

void check_framebuffer(const GlContext& context, const char* what, int width, int height) {
    const GLenum status = context.gl().CheckFramebufferStatus(GL_FRAMEBUFFER);
    const GLenum error = context.gl().GetError();
    if (status == GL_FRAMEBUFFER_COMPLETE && error == GL_NO_ERROR) return;
    throw Error(Exit::usage,
                std::string("OpenGL cannot make ") + what + " of " + std::to_string(width) + " x " +
                    std::to_string(height) + " pixels" +
                    (error == GL_OUT_OF_MEMORY ? " (out of memory)" : ""),
                context.description(), "choose a smaller size or another display backend");
}

ItemTarget::ItemTarget(GlContext& context, int width, int height)
    : context_(context),
      gl_(context.gl()),
      width_(width),
      height_(height),
      items_(gl_),
      depths_(gl_),
      framebuffer_(gl_) {
    make_texture(gl_, items_, GL_R32UI, width, height, GL_RED_INTEGER, GL_UNSIGNED_INT);
    make_texture(gl_, depths_, GL_DEPTH_COMPONENT32F, width, height, GL_DEPTH_COMPONENT, GL_FLOAT);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, items_.id(), 0);
    gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depths_.id(), 0);
    check_framebuffer(context, "an item buffer", width, height);
}

void ItemTarget::begin(std::uint32_t item) const {
    gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    gl_.Viewport(0, 0, width_, height_);
    const GLuint value[] = {item, 0, 0, 0};
    const GLfloat infinitely_far = 0;
    gl_.ClearBufferuiv(GL_COLOR, 0, value);
    gl_.ClearBufferfv(GL_DEPTH, 0, &infinitely_far);
}

std::vector<std::uint32_t> ItemTarget::read() const {
    std::vector<std::uint32_t> pixels(static_cast<std::size_t>(width_) * height_);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    gl_.PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl_.ReadPixels(0, 0, width_, height_, GL_RED_INTEGER, GL_UNSIGNED_INT, pixels.data());
    gl_.PixelStorei(GL_PACK_ALIGNMENT, 4);
    return pixels;
}

}  // namespace povpreview::items
