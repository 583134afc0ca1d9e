// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "core/detail/pixel_rays.h"

namespace povpreview {

/// A depth buffer with what was drawn into it. Nearness: see PixelRays::nearness().
///
/// Bands of its rows can be drawn side by side. One for what a mirror shows is closed but for the
/// mirror's own pixels, and takes there only what lies behind the mirror's plane as rays go on from
/// it.
class ItemCanvas {
   public:
    /// What a pixel shows: the number of a face, that of a curved piece with this bit set, or one
    /// of the two values below.
    using Source = std::uint32_t;
    static constexpr Source piece_bit = 0x80000000, unknown = 0xffffffff, nothing = 0xfffffffe;
    /// Share of the nearness by which rounding, ours and the ray tracer's, may move a surface.
    static constexpr double coincidence = 1e-9;

    ItemCanvas(int width, int height)
        : width_(width),
          height_(height),
          planes_(std::make_shared<Planes>(std::size_t(width) * std::size_t(height))),
          area_{0, 0, width, height} {}
    ItemCanvas(const ItemCanvas&) = delete;
    ItemCanvas(ItemCanvas&&) = default;

    /// The same pixels, of which those outside of these rows take nothing. What it says of ties is
    /// told by take_ties().
    ItemCanvas band(int top, int bottom) const {
        return {*this, common_box(area_, {0, top, width_, bottom})};
    }
    void take_ties(ItemCanvas&& band) {
        ties_.insert(ties_.end(), band.ties_.begin(), band.ties_.end());
    }

    /// Pixels outside of it take nothing.
    const PixelBox& area() const { return area_; }
    /// Closes all pixels; those within the area are to be opened.
    void close_all(const PixelBox& area) {
        planes_->limits.resize(planes_->nearness.size());
        for (int y = area_.top; y < area_.bottom; ++y)  // beyond it they are closed
            for (std::size_t pixel = index(0, y); pixel < index(0, y + 1); ++pixel) {
                planes_->nearness[pixel] = std::numeric_limits<double>::infinity();
                planes_->sources[pixel] = unknown;
                planes_->limits[pixel] = -std::numeric_limits<double>::infinity();
            }
        ties_.clear();
        area_ = area;
    }
    /// What is no farther than the limit is not drawn.
    void open(std::size_t pixel, double limit) {
        planes_->nearness[pixel] = -std::numeric_limits<double>::infinity();
        planes_->sources[pixel] = nothing;
        planes_->limits[pixel] = limit - coincidence * std::abs(limit);
    }
    /// Whether something with this nearness is too near to be drawn.
    bool too_near(std::size_t pixel, double nearness) const {
        return !planes_->limits.empty() && !(nearness < planes_->limits[pixel]);
    }

    int width() const { return width_; }
    int height() const { return height_; }
    std::size_t index(int x, int y) const { return std::size_t(y) * std::size_t(width_) + x; }
    double nearness(std::size_t pixel) const { return planes_->nearness[pixel]; }
    /// Of the pixels from this one on.
    const double* nearness_from(std::size_t pixel) const { return &planes_->nearness[pixel]; }
    Source source(std::size_t pixel) const { return planes_->sources[pixel]; }

    /// Draws where it is nearer than what is there. Of two that coincide none is known to be seen.
    void draw(std::size_t pixel, double nearness, Source source) {
        double& at = planes_->nearness[pixel];
        Source& shown = planes_->sources[pixel];
        const double before = at, slack = coincidence * std::abs(nearness);
        if (!(nearness > before - slack) || too_near(pixel, nearness)) return;
        if (nearness <= before + slack) {
            if (shown != source) ties_.push_back({pixel, nearness, shown, source});
            if (nearness <= before) return;
        }
        at = nearness;
        shown = source;
    }
    /// Hides what is not nearer than this behind something unknown.
    void hide(std::size_t pixel, double nearness) {
        if (too_near(pixel, nearness)) nearness = planes_->limits[pixel];
        if (nearness < planes_->nearness[pixel]) return;
        planes_->nearness[pixel] = nearness;
        planes_->sources[pixel] = unknown;
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
        return planes_->nearness[tie.pixel] <= tie.nearness * (1 + 2 * coincidence) &&
               planes_->sources[tie.pixel] != unknown;
    }

   private:
    /// By pixel.
    struct Planes {
        explicit Planes(std::size_t pixels)
            : nearness(pixels, -std::numeric_limits<double>::infinity()),
              sources(pixels, nothing) {}
        std::vector<double> nearness;
        std::vector<Source> sources;
        std::vector<double> limits{};  // of a mirror's canvas
    };
    ItemCanvas(const ItemCanvas& whole, const PixelBox& area)
        : width_(whole.width_), height_(whole.height_), planes_(whole.planes_), area_(area) {}

    int width_, height_;
    std::shared_ptr<Planes> planes_;
    std::vector<Tie> ties_;
    PixelBox area_;
};

}  // namespace povpreview
