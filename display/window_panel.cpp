// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/window_panel.h"

#include <algorithm>

#include "core/error.h"
#include "display/caption.h"

namespace povpreview {

namespace {

constexpr int narrowest_caption = 160;  ///< pixels; below, no word would fit

}  // namespace

WindowPanel::WindowPanel(GlContext& context)
    : context_(context), painter_(context), strip_(context.gl()) {}

void WindowPanel::load(const Picture& picture, const std::string& caption) {
    painter_.load(picture);
    width_ = picture.width;
    height_ = picture.height;
    caption_ = caption;
}

void WindowPanel::set_caption(int width) {
    if (no_font_ || (strip_text_ == caption_ && strip_width_ == width)) return;
    strip_text_ = caption_;
    strip_width_ = width;
    strip_height_ = 0;
    if (caption_.empty() || width < narrowest_caption) return;
    try {
        const Image strip = caption_strip(caption_, width);
        const GlFunctions& gl = context_.gl();
        gl.BindTexture(GL_TEXTURE_2D, strip_.id());
        gl.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
        gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGB32F, strip.width, strip.height, 0, GL_RGB, GL_FLOAT,
                      strip.pixels.data());
        for (GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
            gl.TexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
        strip_height_ = strip.height;
    } catch (const Error&) {
        no_font_ = true;  // a picture without caption is better than none; the title still has it
    }
}

/// Paints at the place's size, but never with less than a pixel for each of the picture's: what is
/// too fine for the window is averaged, not skipped.
void WindowPanel::paint(const Rectangle& place, Overlay overlay, int samples) {
    const int limit = context_.max_texture_size();
    const int width = std::min(std::max(place.width, width_), limit);
    const int height = std::min(std::max(place.height, height_), limit);
    if (!canvas_ || canvas_->width() != width || canvas_->height() != height ||
        samples_asked_ != samples) {
        canvas_.reset();  // first, so that there are never two
        canvas_.emplace(context_, width, height, samples);
        samples_asked_ = samples;
    }
    canvas_->begin();
    painter_.draw({.width = width,
                   .height = height,
                   .tile_width = width,
                   .tile_height = height,
                   .range = Range::display},
                  overlay);
    canvas_->resolve();
}

void WindowPanel::draw(const Presenter& presenter, const Rectangle& column, int window_height,
                       Overlay overlay, int samples) {
    set_caption(column.width);
    const Places where = places(column, width_, height_, strip_height_);
    paint(where.picture, overlay, samples);
    presenter.draw(canvas_->texture(), where.picture, window_height);
    if (where.caption.height > 0) presenter.draw(strip_.id(), where.caption, window_height);
}

}  // namespace povpreview
