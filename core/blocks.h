// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <deque>
#include <random>
#include <vector>

#include "core/pixel_canvas.h"
#include "core/previewer.h"

namespace povpreview {

/// Blocks of constant colour, as in Radiance's rview (the paper's first comparison): a quadtree
/// over the image, where a block shows one sample at a random place in it. Splitting a block makes
/// four children; the one that holds the parent's sample inherits it, the others are traced.
///
/// First the whole tree is split level by level until no block is wider or higher than 8 pixels
/// (rview's psample); then in every pass the blocks that differ from a neighbour by more than 15 %
/// (maxdiff) in any channel are split once, for each level down to pixels. There rview stops; here
/// the remaining blocks are split, coarse ones first, until every pixel has its sample.
///
/// Where it departs from rview: a block's sample is at the centre of a random pixel of it (rview
/// takes any point and remembers the pixel), so that no sample is lost on the way down, every pixel
/// is traced once, and the complete picture is POV-Ray's; and a pass judges the colours that were
/// there when it began, so that the result does not depend on how answers are batched.
class Blocks final : public Previewer {
   public:
    Blocks(int width, int height, std::uint32_t seed = 1);

    std::string_view name() const override { return "blocks"; }
    Parts parts() const override { return Parts::colour; }
    std::optional<Request> next() override;
    void accept(const Sample& sample) override;
    bool done() const override;
    Picture picture(Overlay overlay) const override;
    Statistics statistics() const override;

   private:
    using Coordinate = std::uint16_t;
    /// A block of pixels [x0, x1) x [y0, y1); empty ones, beside blocks one pixel wide, are never
    /// sampled.
    struct Node {
        Coordinate x0, y0, x1, y1;
        Coordinate x, y;             ///< the sample's pixel
        glm::vec3 colour{};          ///< valid once its sample was answered
        std::uint32_t children = 0;  ///< index of the first of four; 0: a leaf
        bool empty() const { return x0 == x1 || y0 == y1; }
        bool is_pixel() const { return x1 - x0 == 1 && y1 - y0 == 1; }
    };

    void ask(std::uint32_t node);
    void split(std::uint32_t node);
    void split_all_leaves();
    void split_where_different();
    std::uint32_t child_at(const Node& parent, int x, int y) const;
    /// The block at pixel (x, y), at most `depth_` splits down, among the first `count` nodes.
    std::uint32_t find(int x, int y, std::size_t count) const;
    /// The next pass's requests; false where it must wait for answers first or none is left.
    bool start_pass();

    PixelCanvas canvas_;
    std::mt19937 random_;
    std::vector<Node> nodes_;
    int depth_ = 0;           ///< of the pass that comes next
    bool all_asked_ = false;  ///< every leaf is a pixel
    std::deque<std::uint32_t> wanted_, outstanding_;
    std::vector<glm::vec2> samples_;
};

}  // namespace povpreview
