// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/adaptive_lattice.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/common.hpp>

#include "core/colour.h"
#include "core/colour_table.h"
#include "core/edge_weight.h"

namespace povpreview {
namespace {

/// What a cell promises whose corners are alike, against one between black and white: how far blank
/// areas are searched for what the samples have missed so far. .001 to .02 serve alike.
constexpr float blank_contrast = .004f;

/// Of the jump between two corners, what counts where their items are known to differ: between them
/// nothing is smeared.
constexpr float jump_share = .1f;

/// What a pixel promises whose item no corner is on: its colour is a guess.
constexpr float orphan_contrast = .1f;

}  // namespace

AdaptiveLattice::AdaptiveLattice(const BfSquares& squares, int width, int height)
    : squares_(squares),
      width_(width),
      height_(height),
      encoded_(std::make_unique_for_overwrite<glm::vec3[]>(squares.pixels())),
      leaf_side_(squares.pixels()) {
    assert(width >= 1 && height >= 1 && width <= UINT16_MAX && height <= UINT16_MAX);
    for (Pixel pixel = 0; pixel < squares.pixels(); ++pixel)
        if (squares.has_colour(pixel)) encoded_[pixel] = encode_srgb(squares.colour(pixel));
    want_first_cells();
}

Pixel AdaptiveLattice::pixel_at(int x, int y) const {
    return static_cast<Pixel>(std::min(y, height_ - 1)) * static_cast<Pixel>(width_) +
           static_cast<Pixel>(std::min(x, width_ - 1));
}

AdaptiveLattice::Corners AdaptiveLattice::corners(const Cell& cell) const {
    const int right = cell.x + cell.side, below = cell.y + cell.side;
    return {pixel_at(cell.x, cell.y), pixel_at(right, cell.y), pixel_at(cell.x, below),
            pixel_at(right, below)};
}

template <class Visit>
void AdaptiveLattice::for_each_quarter(const Cell& cell, const Visit& visit) const {
    const auto half = static_cast<std::uint16_t>(cell.side / 2);
    for (const std::uint16_t y : {cell.y, static_cast<std::uint16_t>(cell.y + half)})
        for (const std::uint16_t x : {cell.x, static_cast<std::uint16_t>(cell.x + half)})
            if (x < width_ && y < height_) visit(Cell{x, y, half});
}

/// A cell that was split has left a smaller side at its first pixel.
template <class Visit>
void AdaptiveLattice::for_each_leaf(const Cell& cell, const Visit& visit) const {
    const int side = side_at(pixel_at(cell.x, cell.y));
    if (side == 0) return;
    if (side == cell.side) return visit(cell);
    for_each_quarter(cell, [&](const Cell& quarter) { for_each_leaf(quarter, visit); });
}

template <class Visit>
void AdaptiveLattice::for_each_leaf(const Visit& visit) const {
    for (int y = 0; y < height_; y += first_side)
        for (int x = 0; x < width_; x += first_side)
            for_each_leaf(
                {static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y), first_side}, visit);
}

void AdaptiveLattice::want(Pixel pixel) {
    if (squares_.state(pixel) == BfSquares::State::unsampled) wanted_.push_back(pixel);
}

void AdaptiveLattice::want_first_cells() {
    const auto over = [](int end, const auto& visit) {
        for (int i = 0; i < end - 1; i += first_side) visit(i);
        visit(end - 1);
    };
    over(height_, [&](int y) { over(width_, [&](int x) { want(pixel_at(x, y)); }); });
    std::reverse(wanted_.begin(), wanted_.end());
    asking_ = Coming{};
}

/// The corners that the quarters add; of quarters that are pixels, those alone.
void AdaptiveLattice::want_quarters(const Cell& cell) {
    const int half = cell.side / 2, end = half > 1 ? 2 : 1;
    for (int j = end; j >= 0; --j)
        for (int i = end; i >= 0; --i) want(pixel_at(cell.x + i * half, cell.y + j * half));
    leaf_side_[pixel_at(cell.x, cell.y)] |= splitting;
    asking_ = Coming{cell, 0};
}

std::optional<Pixel> AdaptiveLattice::next(const DetailMap* detail) {
    for (;;) {
        while (!wanted_.empty()) {
            const Pixel pixel = wanted_.back();
            wanted_.pop_back();
            // Points at the border are several corners of the same cell.
            if (squares_.state(pixel) == BfSquares::State::unsampled) return pixel;
        }
        if (asking_) {
            // Answers come in the order of the requests; those that others asked for are among
            // them.
            asking_->complete_after = squares_.requested();
            coming_.push_back(*asking_);
            asking_.reset();
        }
        take_complete(detail);
        if (heap_.empty()) return std::nullopt;
        const Cell cell = heap_.top().cell;
        heap_.pop();
        if (waits(cell)) want_quarters(cell);
    }
}

void AdaptiveLattice::take_complete(const DetailMap* detail) {
    const auto take = [&](const Cell& cell) {
        leaf_side_[pixel_at(cell.x, cell.y)] = static_cast<std::uint8_t>(cell.side);
        weigh(cell, detail);
    };
    for (; !coming_.empty() && coming_.front().complete_after <= squares_.answered();
         coming_.pop_front()) {
        if (const auto& split = coming_.front().split) {
            for_each_quarter(*split, take);
            continue;
        }
        for (int y = 0; y < height_; y += first_side)
            for (int x = 0; x < width_; x += first_side)
                take({static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y), first_side});
    }
}

void AdaptiveLattice::weigh(const Cell& cell, const DetailMap* detail) {
    if (cell.side > 1) heap_.push({weight(cell, detail), cell});
}

void AdaptiveLattice::accept(Pixel pixel, const RungLight& light) {
    if (!squares_.has_colour(pixel)) return;
    encoded_[pixel] = encode_srgb(light.colour);
    if (!light.shaded) return;
    if (lights_of_.empty()) lights_of_.resize(squares_.pixels());
    if (lights_of_[pixel] == 0) {
        lights_.emplace_back();
        lights_of_[pixel] = static_cast<std::uint32_t>(lights_.size());
    }
    lights_[lights_of_[pixel] - 1] = {light.illumination, light.remainder};
}

/// Cells that are being split now are not in the heap; their quarters will be.
void AdaptiveLattice::accept_detail(const DetailMap& detail) {
    std::priority_queue<Weighed> heap;
    for (; !heap_.empty(); heap_.pop())
        if (const Cell& cell = heap_.top().cell; waits(cell))
            heap.push({weight(cell, &detail), cell});
    heap_ = std::move(heap);
}

/// What is known changed in the square around the pixel, which lies in one first cell.
void AdaptiveLattice::accept_doubt(Pixel pixel, const DetailMap& detail) {
    static_assert(first_side % BfSquares::side == 0);
    const auto width = static_cast<Pixel>(width_);
    const auto first = [](Pixel at) {
        return static_cast<std::uint16_t>(at / first_side * first_side);
    };
    for_each_leaf({first(pixel % width), first(pixel / width), first_side}, [&](const Cell& leaf) {
        if (waits(leaf)) weigh(leaf, &detail);
    });
}

/// The error that a cell may be expected to have, summed over its pixels.
float AdaptiveLattice::weight(const Cell& cell, const DetailMap* detail) const {
    const Corners c = corners(cell);
    const int right = std::min(cell.x + cell.side, width_),
              below = std::min(cell.y + cell.side, height_);
    const auto area = static_cast<float>((right - cell.x) * (below - cell.y));
    if (!detail) return (blank_contrast + contrast(c, nullptr)) * area;
    std::array<std::uint32_t, 4> items;
    for (std::size_t i = 0; i < c.size(); ++i) items[i] = detail->item(c[i]);
    int orphans = 0;
    for (int y = cell.y; y < below; ++y) {
        const Pixel row = pixel_at(0, y);
        for (int x = cell.x; x < right; ++x) {
            const std::uint32_t item = detail->item(row + static_cast<Pixel>(x));
            orphans += item != DetailMap::unknown && item != items[0] && item != items[1] &&
                       item != items[2] && item != items[3];
        }
    }
    return (blank_contrast + contrast(c, detail)) * area +
           orphan_contrast * static_cast<float>(orphans);
}

/// The most by which two corners differ, as displayed. Where the texture is known, only the light
/// is to be found out.
float AdaptiveLattice::contrast(const Corners& c, const DetailMap* detail) const {
    std::array<std::optional<glm::vec3>, 4> lights;
    if (detail && !lights_of_.empty())
        for (std::size_t i = 0; i < c.size(); ++i)
            if (lights_of_[c[i]] && detail->albedo_state(c[i]) == DetailMap::Albedo::known) {
                const Light& light = lights_[lights_of_[c[i]] - 1];
                lights[i] =
                    roughly_encoded(detail->albedo(c[0]) * light.illumination + light.remainder);
            }
    float most = 0;
    for (std::size_t i = 0; i < c.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const bool known = detail && detail->item(c[i]) != DetailMap::unknown &&
                               detail->item(c[j]) != DetailMap::unknown;
            const bool same = known && detail->item(c[i]) == detail->item(c[j]);
            const float d = same && lights[i] && lights[j]
                                ? colour_distance(*lights[i], *lights[j])
                                : jump(c[i], c[j]) * (known && !same ? jump_share * jump_share : 1);
            most = std::max(most, d);
        }
    return std::sqrt(most);
}

/// colour_distance() of two samples; 0 where one has failed.
float AdaptiveLattice::jump(Pixel p, Pixel q) const {
    const auto shown = [](const glm::vec3& v) { return glm::clamp(v, 0.f, 1.f); };
    if (!squares_.has_colour(p) || !squares_.has_colour(q)) return 0;
    return colour_distance(shown(encoded_[p]), shown(encoded_[q]));
}

void AdaptiveLattice::draw(Picture& picture, const DetailMap* detail,
                           std::span<const Pixel> anchors) const {
    for_each_leaf([&](const Cell& cell) {
        for (int y = cell.y; y < std::min(cell.y + cell.side, height_); ++y)
            for (int x = cell.x; x < std::min(cell.x + cell.side, width_); ++x)
                if (const Pixel pixel = pixel_at(x, y); squares_.has_colour(pixel))
                    picture.known[pixel] = 1;
                else
                    draw(cell, x, y, detail, anchors, picture);
    });
}

/// Corners without a sample, for it failed, are left out.
bool AdaptiveLattice::mix(std::span<const Part> parts, glm::vec3& encoded) const {
    glm::vec3 sum(0);
    float shares = 0;
    for (const Part& part : parts) {
        if (!(part.share > 0) || !squares_.has_colour(part.pixel)) continue;
        sum += part.share * encoded_[part.pixel];
        shares += part.share;
    }
    if (shares > 0) encoded = sum / shares;
    return shares > 0;
}

bool AdaptiveLattice::mix_light(std::span<const Part> parts, const glm::vec3& albedo,
                                glm::vec3& linear) const {
    if (lights_of_.empty()) return false;
    Light sum{glm::vec3(0), glm::vec3(0)};
    float shares = 0;
    for (const Part& part : parts) {
        const std::uint32_t number = lights_of_[part.pixel];
        if (!(part.share > 0) || number == 0) continue;
        sum.illumination += part.share * lights_[number - 1].illumination;
        sum.remainder += part.share * lights_[number - 1].remainder;
        shares += part.share;
    }
    if (shares > 0) linear = (albedo * sum.illumination + sum.remainder) / shares;
    return shares > 0;
}

namespace {

/// Where a pixel lies between two corners of a cell, 0 to 1.
float between(int at, int first, int side, int end) {
    const int last = std::min(first + side, end - 1);
    return last > first ? static_cast<float>(at - first) / static_cast<float>(last - first) : 0;
}

std::array<float, 4> bilinear(float u, float v) {
    return {(1 - u) * (1 - v), u * (1 - v), (1 - u) * v, u * v};
}

}  // namespace

/// A cell's corners, by how much a pixel in it, or beyond its end, takes from each.
AdaptiveLattice::Parts4 AdaptiveLattice::parts(const Cell& cell, int x, int y) const {
    const Corners c = corners(cell);
    const auto share =
        bilinear(between(x, cell.x, cell.side, width_), between(y, cell.y, cell.side, height_));
    return {Part{c[0], share[0]}, Part{c[1], share[1]}, Part{c[2], share[2]}, Part{c[3], share[3]}};
}

/// What stands for a pixel of an item: the corners on it; where none is, those of the larger cells
/// around, and then the item's anchor.
std::optional<AdaptiveLattice::Parts4> AdaptiveLattice::parts_on(
    std::uint32_t item, const Cell& cell, int x, int y, const DetailMap& detail,
    std::span<const Pixel> anchors) const {
    if (item == DetailMap::unknown) return std::nullopt;
    for (int side = cell.side; side <= first_side; side *= 2) {
        Parts4 result =
            parts({static_cast<std::uint16_t>(x / side * side),
                   static_cast<std::uint16_t>(y / side * side), static_cast<std::uint16_t>(side)},
                  x, y);
        bool any = false;
        for (Part& part : result) {
            const bool on = detail.item(part.pixel) == item && squares_.has_colour(part.pixel);
            // A corner beyond an edge may be the only one on the item, at no distance.
            part.share = on ? std::max(part.share, 1e-3f) : 0;
            any = any || on;
        }
        if (any) return result;
    }
    if (item >= anchors.size() || anchors[item] == no_anchor || !squares_.has_colour(anchors[item]))
        return std::nullopt;
    return Parts4{
        Part{anchors[item], 1}, {anchors[item], 0}, {anchors[item], 0}, {anchors[item], 0}};
}

/// Draws a pixel that is not known, if anything around it is.
void AdaptiveLattice::draw(const Cell& cell, int x, int y, const DetailMap* detail,
                           std::span<const Pixel> anchors, Picture& picture) const {
    const Pixel pixel = pixel_at(x, y);
    const auto on_item =
        detail ? parts_on(detail->item(pixel), cell, x, y, *detail, anchors) : std::nullopt;
    glm::vec3 colour;
    if (on_item && detail->albedo_state(pixel) == DetailMap::Albedo::known &&
        mix_light(*on_item, detail->albedo(pixel), colour)) {
        picture.pixels[pixel] = colour;
    } else if (mix(on_item ? *on_item : parts(cell, x, y), colour)) {
        picture.pixels[pixel] = decode_quickly(colour);
    } else {
        return;
    }
    picture.known[pixel] = 1;
}

}  // namespace povpreview
