// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "core/detail/pixel_rays.h"
#include "core/detail/runs.h"
#include "core/pixel_memory.h"

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

    /// Nothing may be read or drawn before clear(), hide_all() or close().
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
    /// Nothing is shown, and there is no limit.
    void clear() { fill(-infinity, nothing); }
    /// Nothing can be told of any pixel.
    void hide_all() { fill(infinity, unknown); }
    /// From now on only these pixels may be drawn to, when they have been closed and some of them
    /// opened.
    void limit_to(const PixelBox& area) {
        if (!planes_->limits) planes_->limits.emplace(index(0, height_), Touched::all_over);
        ties_.clear();
        area_ = area;
    }
    /// All pixels of the area. REQUIRES: limit_to().
    void close() {
        hide_all();
        for (int y = area_.top; y < area_.bottom; ++y)
            std::fill(&(*planes_->limits)[index(area_.left, y)],
                      &(*planes_->limits)[index(area_.left, y)] + (area_.right - area_.left),
                      -infinity);
    }
    /// What is no farther than the limit is not drawn.
    void open(std::size_t pixel, double limit) {
        planes_->nearness[pixel] = -infinity;
        planes_->sources[pixel] = nothing;
        (*planes_->limits)[pixel] = limit - coincidence * std::abs(limit);
    }
    /// Whether something with this nearness is too near to be drawn.
    bool too_near(std::size_t pixel, double nearness) const {
        return planes_->limits && !(nearness < (*planes_->limits)[pixel]);
    }

    int width() const { return width_; }
    int height() const { return height_; }
    std::size_t index(int x, int y) const { return std::size_t(y) * std::size_t(width_) + x; }
    double nearness(std::size_t pixel) const { return planes_->nearness[pixel]; }
    /// Of the pixels from this one on.
    const double* nearness_from(std::size_t pixel) const { return &planes_->nearness[pixel]; }
    Source source(std::size_t pixel) const { return planes_->sources[pixel]; }
    /// Calls visit(first, last) for the pixels of a row, from `first` to before `last`, that show
    /// one source.
    template <class Visit>
    void visit_row(int y, const Visit& visit) const {
        const Source* const sources = &planes_->sources[0];
        visit_runs(sources + index(0, y), sources + index(0, y + 1),
                   [&](const Source* first, const Source* last) {
                       visit(std::size_t(first - sources), std::size_t(last - sources));
                   });
    }

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
    /// The same of some in a row, [left, right), where nearness_at(x) tells how near.
    template <class NearnessAt>
    void draw_row(int y, int left, int right, const NearnessAt& nearness_at, Source source) {
        double* const shown = &planes_->nearness[index(0, y)];
        Source* const sources = &planes_->sources[index(0, y)];
        const bool unlimited = !planes_->limits;
        for (int x = left; x < right; ++x) {
            const double nearness = nearness_at(x), slack = coincidence * std::abs(nearness);
            if (unlimited && nearness > shown[x] + slack) {
                shown[x] = nearness;
                sources[x] = source;
            } else {
                draw(index(x, y), nearness, source);
            }
        }
    }
    /// Hides what is not nearer than this behind something unknown.
    void hide(std::size_t pixel, double nearness) {
        if (too_near(pixel, nearness)) nearness = (*planes_->limits)[pixel];
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
    static constexpr double infinity = std::numeric_limits<double>::infinity();

    struct Planes {
        explicit Planes(std::size_t pixels)
            : nearness(pixels, Touched::all_over), sources(pixels, Touched::all_over) {}
        PixelMemory<double> nearness;
        PixelMemory<Source> sources;
        std::optional<PixelMemory<double>> limits{};  // of a mirror's canvas
    };
    void fill(double nearness, Source source) {
        for (int y = area_.top; y < area_.bottom; ++y) {
            const std::size_t first = index(area_.left, y),
                              count = std::size_t(area_.right - area_.left);
            std::fill_n(&planes_->nearness[first], count, nearness);
            std::fill_n(&planes_->sources[first], count, source);
        }
    }
    ItemCanvas(const ItemCanvas& whole, const PixelBox& area)
        : width_(whole.width_), height_(whole.height_), planes_(whole.planes_), area_(area) {}

    int width_, height_;
    std::shared_ptr<Planes> planes_;
    std::vector<Tie> ties_;
    PixelBox area_;
};

}  // namespace povpreview
