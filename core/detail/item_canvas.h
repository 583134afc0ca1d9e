// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/detail/pixel_rays.h"

namespace povpreview {

/// A depth buffer with what was drawn into it. Nearness: see PixelRays::nearness().
///
/// One for what a mirror shows is closed but for the mirror's own pixels, and takes there only what
/// lies behind the mirror's plane as rays go on from it.
class ItemCanvas {
   public:
    /// What a pixel shows: the number of a face, that of a curved piece with this bit set, or one
    /// of the two values below.
    using Source = std::uint32_t;
    static constexpr std::size_t read_beyond = 64;  ///< pixels, see nearness_from()
    static constexpr Source piece_bit = 0x80000000, unknown = 0xffffffff, nothing = 0xfffffffe;
    /// Share of the nearness by which rounding, ours and the ray tracer's, may move a surface.
    static constexpr double coincidence = 1e-9;

    ItemCanvas(int width, int height)
        : width_(width),
          height_(height),
          nearness_(std::size_t(width) * std::size_t(height) + read_beyond,
                    -std::numeric_limits<double>::infinity()),
          sources_(nearness_.size(), nothing),
          area_{0, 0, width, height} {}

    /// Pixels outside of it take nothing.
    const PixelBox& area() const { return area_; }
    /// Closes all pixels; those within the area are to be opened.
    void close_all(const PixelBox& area) {
        limits_.resize(nearness_.size());
        for (int y = area_.top; y < area_.bottom; ++y)  // beyond it they are closed
            for (std::size_t pixel = index(0, y); pixel < index(0, y + 1); ++pixel) {
                nearness_[pixel] = std::numeric_limits<double>::infinity();
                sources_[pixel] = unknown;
                limits_[pixel] = -std::numeric_limits<double>::infinity();
            }
        ties_.clear();
        area_ = area;
    }
    /// What is no farther than the limit is not drawn.
    void open(std::size_t pixel, double limit) {
        nearness_[pixel] = -std::numeric_limits<double>::infinity();
        sources_[pixel] = nothing;
        limits_[pixel] = limit - coincidence * std::abs(limit);
    }
    /// Whether something with this nearness is too near to be drawn.
    bool too_near(std::size_t pixel, double nearness) const {
        return !limits_.empty() && !(nearness < limits_[pixel]);
    }

    int width() const { return width_; }
    int height() const { return height_; }
    std::size_t index(int x, int y) const { return std::size_t(y) * std::size_t(width_) + x; }
    double nearness(std::size_t pixel) const { return nearness_[pixel]; }
    /// Of the pixels from this one on; a few may be read beyond the last.
    const double* nearness_from(std::size_t pixel) const { return &nearness_[pixel]; }
    Source source(std::size_t pixel) const { return sources_[pixel]; }

    /// Draws where it is nearer than what is there. Of two that coincide none is known to be seen.
    void draw(std::size_t pixel, double nearness, Source source) {
        const double before = nearness_[pixel], slack = coincidence * std::abs(nearness);
        if (!(nearness > before - slack) || too_near(pixel, nearness)) return;
        if (nearness <= before + slack) {
            const bool same = sources_[pixel] == source;
            if (!same) ties_.push_back({pixel, nearness, sources_[pixel], source});
            if (nearness <= before) return;
        }
        nearness_[pixel] = nearness;
        sources_[pixel] = source;
    }
    /// Hides what is not nearer than this behind something unknown.
    void hide(std::size_t pixel, double nearness) {
        if (too_near(pixel, nearness)) nearness = limits_[pixel];
        if (nearness < nearness_[pixel]) return;
        nearness_[pixel] = nearness;
        sources_[pixel] = unknown;
    }

    /// Two that coincided when the later one was drawn; something may have come before them since.
    struct Tie {
        std::size_t pixel;
        double nearness;
        Source first, second;
    };
    const std::vector<Tie>& ties() const { return ties_; }
    /// Whether a tie still stands.
    bool stands(const Tie& tie) const {
        return nearness_[tie.pixel] <= tie.nearness * (1 + 2 * coincidence) &&
               sources_[tie.pixel] != unknown;
    }

   private:
    int width_, height_;
    std::vector<double> nearness_;
    std::vector<Source> sources_;
    std::vector<double> limits_;  // by pixel, of a mirror's canvas
    std::vector<Tie> ties_;
    PixelBox area_;
};

}  // namespace povpreview
