// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <deque>
#include <glm/vec2.hpp>
#include <vector>

#include "core/pixel_canvas.h"
#include "core/previewer.h"

namespace povpreview {

/// POV-Ray's own mosaic preview (+SP, +EP1), as of 3.7 (`TraceTask::SimpleSamplingM0P`): square
/// blocks of a power of two show their upper left pixel; the next level halves the blocks and
/// leaves out the pixels that are there already. POV-Ray walks tiles of 32 x 32 pixels row by row,
/// the blocks of a tile likewise, and waits for a level's end before the next. Every pixel is
/// traced once, at its centre.
class Mosaic final : public Previewer {
   public:
    /// `start_size`: side of the first blocks in pixels, a power of two up to the tile's 32.
    /// POV-Ray has no mosaic unless asked; the default here is the one with the earliest whole
    /// picture.
    Mosaic(int width, int height, int start_size = 32);

    std::string_view name() const override { return "mosaic"; }
    Parts parts() const override { return Parts::colour; }
    std::optional<Request> next() override;
    void accept(const Sample& sample) override;
    bool done() const override;
    Picture picture(Overlay overlay) const override;
    Statistics statistics() const override;

   private:
    struct Block {
        int x, y, size;
    };
    /// Moves the cursor from block to block; false at the end of the level.
    bool advance();
    bool has_its_pixel() const {
        return size_ < start_size_ && x_ % (2 * size_) == 0 && y_ % (2 * size_) == 0;
    }
    bool start_level(int size);

    PixelCanvas canvas_;
    int start_size_;
    int size_ = 0;                 ///< of this level's blocks; 0: all levels are asked for
    int tile_x_ = 0, tile_y_ = 0;  ///< upper left pixel of the cursor's tile
    int x_ = 0, y_ = 0;            ///< upper left pixel of the cursor's block
    bool level_asked_ = false;     ///< the cursor has passed the level's last block
    std::deque<Block> outstanding_;
    std::vector<glm::vec2> samples_;
};

}  // namespace povpreview
