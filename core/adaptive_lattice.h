// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <queue>
#include <span>
#include <vector>

#include "core/bf_squares.h"
#include "core/detail/detail_map.h"
#include "core/picture.h"
#include "core/rung_shift.h"

namespace povpreview {

/// For scenes whose samples cost less than a vertex of a triangulation does: square cells with
/// samples at their corners, all on pixel centres. The cell that promises most is split in four,
/// and so on down to the pixels, until each has its sample.
///
///     o-------o---o---o      o  samples
///     |       | 4 | 4 |
///     |   8   o---o---o      a cell 8 pixels wide, and one that was split; what a cell shares with
///     |       | 4 | 4 |      its neighbours is asked for once
///     o-------o---o---o
///
/// Between the corners, pixels are interpolated bilinearly in encoded colour. A pixel whose item is
/// known takes only corners on that item; one whose albedo is known interpolates the light on it
/// (paper, section 2).
class AdaptiveLattice {
   public:
    /// Side of the first cells, in pixels.
    static constexpr int first_side = 16;

    /// Over the pixels of a picture, `squares`, which must outlive it; those that are known already
    /// are taken as they are.
    AdaptiveLattice(const BfSquares& squares, int width, int height);

    /// A pixel that is to be asked for at once; nothing while answers must be waited for, or when
    /// all pixels are asked for. What is known of the pixels, `detail`, may be null.
    std::optional<Pixel> next(const DetailMap* detail);
    /// Takes the light of a pixel, after `squares`; again where it was traced more accurately.
    void accept(Pixel pixel, const RungLight& light);
    /// More has become known of the pixels: what cells promise is reckoned anew.
    void accept_detail(const DetailMap& detail);
    /// The same around a pixel that was found to show something else than was thought.
    void accept_doubt(Pixel pixel, const DetailMap& detail);

    /// Adds to a picture, in which the known pixels stand, those that lie between them. `anchors`:
    /// for each item a pixel whose sample stands for it where no corner does, or none.
    void draw(Picture& picture, const DetailMap* detail, std::span<const Pixel> anchors) const;
    static constexpr Pixel no_anchor = 0xffffffff;

   private:
    /// A square of pixels, cut off at the picture's border; a sample in its first pixel, and in the
    /// ones that lie `side` from that.
    struct Cell {
        std::uint16_t x, y;  ///< first pixel
        std::uint16_t side;
    };
    /// Cells whose corners are on their way.
    struct Coming {
        std::optional<Cell> split;   ///< into quarters; else the first cells
        std::size_t complete_after;  ///< answers, from the beginning
    };
    struct Weighed {
        float weight;
        Cell cell;
        bool operator<(const Weighed& other) const { return weight < other.weight; }
    };
    struct Light {
        glm::vec3 illumination, remainder;
    };
    struct Part {
        Pixel pixel;
        float share;
    };
    using Corners = std::array<Pixel, 4>;  // row by row
    using Parts4 = std::array<Part, 4>;

    static constexpr std::uint8_t splitting = 0x80;
    int side_at(Pixel first) const { return leaf_side_[first] & ~splitting; }
    bool waits(const Cell& cell) const { return leaf_side_[pixel_at(cell.x, cell.y)] == cell.side; }
    Pixel pixel_at(int x, int y) const;  // clamped to the last ones
    Corners corners(const Cell& cell) const;
    void want(Pixel pixel);
    void want_first_cells();
    void want_quarters(const Cell& cell);
    void take_complete(const DetailMap* detail);
    void weigh(const Cell& cell, const DetailMap* detail);
    float weight(const Cell& cell, const DetailMap* detail) const;
    float contrast(const Corners& corners, const DetailMap* detail) const;
    float jump(Pixel p, Pixel q) const;
    template <class Visit>
    void for_each_quarter(const Cell& cell, const Visit& visit) const;
    template <class Visit>
    void for_each_leaf(const Cell& cell, const Visit& visit) const;
    template <class Visit>
    void for_each_leaf(const Visit& visit) const;
    Parts4 parts(const Cell& cell, int x, int y) const;
    std::optional<Parts4> parts_on(std::uint32_t item, const Cell& cell, int x, int y,
                                   const DetailMap& detail, std::span<const Pixel> anchors) const;
    void draw(const Cell& cell, int x, int y, const DetailMap* detail,
              std::span<const Pixel> anchors, Picture& picture) const;
    bool mix(std::span<const Part> parts, glm::vec3& encoded) const;
    bool mix_light(std::span<const Part> parts, const glm::vec3& albedo, glm::vec3& linear) const;

    const BfSquares& squares_;
    int width_, height_;
    std::unique_ptr<glm::vec3[]> encoded_;  // by pixel: the known samples, unclamped
    std::vector<std::uint32_t> lights_of_;  // by pixel: 1 + number in lights_; empty: none is known
    std::vector<Light> lights_;
    std::vector<std::uint8_t> leaf_side_;  // at the first pixel of each leaf, with `splitting`
    std::vector<Pixel> wanted_;            // points of what is asked for now, last first
    std::optional<Coming> asking_;         // that
    std::deque<Coming> coming_;            // oldest first
    std::priority_queue<Weighed> heap_;    // leaves of more than a pixel, some of them twice
};

}  // namespace povpreview
