// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/mosaic.h"

#include <algorithm>
#include <cassert>

namespace povpreview {
namespace {

constexpr int tile = 32;  ///< POV-Ray's default Render_Block_Size, pixels

}  // namespace

Mosaic::Mosaic(int width, int height, int start_size)
    : canvas_(width, height), start_size_(start_size) {
    assert(width >= 1 && height >= 1);
    assert(start_size >= 1 && start_size <= tile && (start_size & (start_size - 1)) == 0);
    start_level(start_size);
}

bool Mosaic::start_level(int size) {
    size_ = size;
    tile_x_ = tile_y_ = x_ = y_ = 0;
    // On levels after the first, the very first block has its pixel already.
    level_asked_ = size_ > 0 && has_its_pixel() && !advance();
    return !level_asked_;
}

bool Mosaic::advance() {
    do {
        x_ += size_;
        if (x_ >= std::min(tile_x_ + tile, canvas_.width())) {
            x_ = tile_x_;
            y_ += size_;
        }
        if (y_ >= std::min(tile_y_ + tile, canvas_.height())) {
            tile_x_ += tile;
            if (tile_x_ >= canvas_.width()) {
                tile_x_ = 0;
                tile_y_ += tile;
            }
            if (tile_y_ >= canvas_.height()) return false;
            x_ = tile_x_;
            y_ = tile_y_;
        }
    } while (has_its_pixel());
    return true;
}

std::optional<Request> Mosaic::next() {
    while (level_asked_ && size_ > 0) {
        if (!outstanding_.empty()) return std::nullopt;
        start_level(size_ / 2);
    }
    if (size_ == 0) return std::nullopt;
    outstanding_.push_back({x_, y_, size_});
    const Request request{pixel_centre(x_, y_)};
    level_asked_ = !advance();
    return request;
}

void Mosaic::accept(const Sample& sample) {
    assert(!outstanding_.empty());
    const Block b = outstanding_.front();
    outstanding_.pop_front();
    canvas_.fill(b.x, b.y, std::min(b.x + b.size, canvas_.width()),
                 std::min(b.y + b.size, canvas_.height()), sample.colour);
    samples_.push_back(sample.position);
}

bool Mosaic::done() const {
    return samples_.size() == std::size_t(canvas_.width()) * std::size_t(canvas_.height());
}

Picture Mosaic::picture(Overlay overlay) const {
    Picture picture = canvas_.picture();
    if (overlay == Overlay::samples) picture.samples = samples_;
    return picture;
}

Statistics Mosaic::statistics() const {
    Statistics statistics;
    statistics.filled = samples_.size();
    return statistics;
}

}  // namespace povpreview
