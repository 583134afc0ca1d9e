// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/canvas.h"

#include <algorithm>
#include <cassert>

#include "core/error.h"

namespace povpreview {

Canvas::Canvas(GlContext& context, int width, int height, int samples)
    : context_(context),
      gl_(context.gl()),
      width_(width),
      height_(height),
      samples_(samples > 1 ? std::min(samples, context.max_samples()) : 1),
      texture_(gl_),
      resolved_(gl_) {
    assert(width > 0 && height > 0);
    const int limit = context.max_texture_size();
    if (width > limit || height > limit)
        throw Error(Exit::usage,
                    std::to_string(width) + " x " + std::to_string(height) +
                        " pixels are more than OpenGL's limit of " + std::to_string(limit) +
                        " a side",
                    context.description(), "choose a smaller size");
    attach_texture();
    if (samples_ > 1) attach_multisamples();
}

void Canvas::attach_texture() const {
    gl_.BindTexture(GL_TEXTURE_2D, texture_.id());
    gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, width_, height_, 0, GL_RGBA, GL_FLOAT, nullptr);
    for (GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        gl_.TexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, resolved_.id());
    gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_.id(), 0);
    check("framebuffer");
}

void Canvas::attach_multisamples() {
    multisamples_.emplace(gl_);
    target_.emplace(gl_);
    gl_.BindRenderbuffer(GL_RENDERBUFFER, multisamples_->id());
    gl_.RenderbufferStorageMultisample(GL_RENDERBUFFER, samples_, GL_RGBA32F, width_, height_);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, target_->id());
    gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                                multisamples_->id());
    check("multisampled framebuffer");
}

void Canvas::check(const char* what) const {
    const GLenum status = gl_.CheckFramebufferStatus(GL_FRAMEBUFFER);
    const GLenum error = gl_.GetError();
    if (status == GL_FRAMEBUFFER_COMPLETE && error == GL_NO_ERROR) return;
    throw Error(Exit::usage,
                std::string("OpenGL cannot make a ") + what + " of " + std::to_string(width_) +
                    " x " + std::to_string(height_) + " pixels" +
                    (error == GL_OUT_OF_MEMORY ? " (out of memory)" : ""),
                context_.description(), "choose a smaller size or another display backend");
}

void Canvas::begin() const {
    gl_.BindFramebuffer(GL_FRAMEBUFFER, target_ ? target_->id() : resolved_.id());
    gl_.Viewport(0, 0, width_, height_);
    gl_.ClearColor(0, 0, 0, 1);
    gl_.Clear(GL_COLOR_BUFFER_BIT);
}

void Canvas::resolve() const {
    if (!target_) return;
    gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, target_->id());
    gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_.id());
    gl_.BlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT,
                        GL_NEAREST);
}

void Canvas::read(Image& image, int x, int y, int width, int height) const {
    assert(width <= width_ && height <= height_);
    assert(x + width <= image.width && y + height <= image.height);
    static_assert(sizeof(glm::vec3) == 3 * sizeof(float));
    gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, resolved_.id());
    gl_.PixelStorei(GL_PACK_ALIGNMENT, 4);
    gl_.PixelStorei(GL_PACK_ROW_LENGTH, image.width);
    gl_.ReadPixels(0, 0, width, height, GL_RGB, GL_FLOAT, &image.at(x, y));
    gl_.PixelStorei(GL_PACK_ROW_LENGTH, 0);
    if (gl_.GetError() != GL_NO_ERROR)
        throw Error(Exit::usage, "OpenGL cannot draw or read back the picture",
                    context_.description(), "choose a smaller size or another display backend");
}

}  // namespace povpreview
