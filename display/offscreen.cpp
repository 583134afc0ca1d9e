// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/offscreen.h"

#include <algorithm>
#include <new>

#include "core/error.h"

namespace povpreview {

namespace {

// Memory for drawing stays small, whatever the picture's size: 2048^2 pixels of 4 floats are 64 MiB
// for each sample of a pixel.
constexpr int largest_tile = 2048;
constexpr int largest_side = 65535;
constexpr long long most_pixels = 1LL << 28;

void check_size(int width, int height) {
    if (width > 0 && height > 0 && width <= largest_side && height <= largest_side &&
        1LL * width * height <= most_pixels)
        return;
    throw Error(Exit::usage,
                "a picture of " + std::to_string(width) + " x " + std::to_string(height) +
                    " pixels cannot be drawn",
                "", "choose sides from 1 to 65535 pixels and no more than 2^28 pixels in all");
}

Image allocate(int width, int height) {
    try {
        return Image(width, height);
    } catch (const std::bad_alloc&) {
        throw Error(Exit::usage,
                    "no memory for a picture of " + std::to_string(width) + " x " +
                        std::to_string(height) + " pixels",
                    "", "choose a smaller size");
    }
}

}  // namespace

Offscreen::Offscreen(std::unique_ptr<GlContext> context) : context_(std::move(context)) {
    context_->make_current();
    painter_.emplace(*context_);
}

Offscreen::~Offscreen() { context_->make_current(); }  // for what the members delete

void Offscreen::prepare(int width, int height, int samples) {
    const int limit = std::min(largest_tile, context_->max_texture_size());
    width = std::min(width, limit);
    height = std::min(height, limit);
    if (canvas_ && canvas_->width() == width && canvas_->height() == height &&
        samples_asked_ == samples)
        return;
    canvas_.reset();  // first, so that there are never two
    canvas_.emplace(*context_, width, height, samples);
    samples_asked_ = samples;
}

Image Offscreen::render(const Picture& picture, int width, int height, int samples_per_pixel,
                        Overlay overlay, Range range) {
    check_size(width, height);
    check_size(picture.width, picture.height);
    Image image = allocate(width, height);
    context_->make_current();
    prepare(width, height, samples_per_pixel);
    painter_->load(picture);
    for (int y = 0; y < height; y += canvas_->height()) {
        for (int x = 0; x < width; x += canvas_->width()) {
            canvas_->begin();
            painter_->draw({.width = width,
                            .height = height,
                            .x = x,
                            .y = y,
                            .tile_width = canvas_->width(),
                            .tile_height = canvas_->height(),
                            .range = range},
                           overlay);
            canvas_->resolve();
            canvas_->read(image, x, y, std::min(canvas_->width(), width - x),
                          std::min(canvas_->height(), height - y));
        }
    }
    return image;
}

}  // namespace povpreview
