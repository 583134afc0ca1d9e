// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/detail/detail_map.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/colour.h"
#include "core/detail/runs.h"

namespace povpreview {

DetailMap::DetailMap(int width, int height)
    : width_(width),
      height_(height),
      items_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), unknown),
      states_(pixels(), Albedo::wanted),
      albedos_(pixels(), glm::vec3(0)),
      told_(pixels()) {}

Pixel DetailMap::pixel_at(glm::dvec2 position) const {
    const int x = std::clamp(static_cast<int>(std::floor(position.x)), 0, width_ - 1);
    const int y = std::clamp(static_cast<int>(std::floor(position.y)), 0, height_ - 1);
    return static_cast<Pixel>(y) * static_cast<Pixel>(width_) + static_cast<Pixel>(x);
}

void DetailMap::set_items(Pixel begin, Pixel end, std::uint32_t item) {
    known_ += items_.fill(begin, end, item, unknown);
    if (item == unknown) known_ -= end - begin;
}

void DetailMap::set_albedo(Pixel pixel, const glm::vec3& albedo) {
    set_state(pixel, Albedo::known);
    albedos_.set(pixel, albedo);
}

void DetailMap::set_state(Pixel pixel, Albedo state) {
    albedos_known_ += (state == Albedo::known) - (states_[pixel] == Albedo::known);
    states_.set(pixel, state);
}

void DetailMap::accept(const ItemBuffer& drawn, ItemNumbers& numbers) {
    assert(drawn.width == width_ && drawn.height == height_);
    const auto end_of_same = [](const auto& of, Pixel begin, Pixel end) {
        return static_cast<Pixel>(end_of_run(of.begin() + begin, of.begin() + end) - of.begin());
    };
    const Pixel all = static_cast<Pixel>(pixels());
    for (Pixel begin = 0, end = 0; begin < all; begin = end) {
        const std::uint32_t surface = drawn.surfaces[begin];
        const bool is_mirror = numbers.is_mirror(surface);
        end = end_of_same(drawn.surfaces, begin, all);
        end = end_of_same(drawn.kinds, begin, end);
        if (is_mirror) end = end_of_same(drawn.mirrored, begin, end);
        if (surface == ItemBuffer::unknown) continue;
        if (!is_mirror)
            set_items(begin, end, numbers.of(surface));
        else if (drawn.mirrored[begin] == ItemBuffer::unknown)
            set_items(begin, end, unknown);
        else
            set_items(begin, end, numbers.of(surface, drawn.mirrored[begin]));
        accept_look(drawn, begin, end);
    }
}

/// Of pixels of one kind.
void DetailMap::accept_look(const ItemBuffer& drawn, Pixel begin, Pixel end) {
    switch (drawn.kinds[begin]) {
        case Look::Kind::plain:
            albedos_known_ -= states_.fill(begin, end, Albedo::constant, Albedo::known);
            break;
        case Look::Kind::image:
        case Look::Kind::pattern:
            for (Pixel pixel = begin; pixel < end; ++pixel) set_albedo(pixel, drawn.albedos[pixel]);
            break;
        case Look::Kind::traced:
        case Look::Kind::mixed:  // samples will tell whether it is worth having
            break;
    }
}

void DetailMap::accept_told(const DetailMap& other, std::span<const std::uint32_t> numbers) {
    contradicted_ += other.contradicted_;
    for (Pixel pixel = 0; pixel < pixels(); ++pixel) {
        if (!other.told_[pixel]) continue;
        told_[pixel] = true;
        const std::uint32_t item = other.items_[pixel];
        if (item == unknown)
            set_item(pixel, unknown);
        else if (numbers[item] != ItemNumbers::several)
            set_item(pixel, numbers[item]);
        set_state(pixel, other.states_[pixel]);
        albedos_.set(pixel, other.albedos_[pixel]);
    }
}

void DetailMap::accept_albedo(Pixel pixel, const Sample& sample, ItemNumbers& numbers) {
    told_[pixel] = true;
    const bool usable = !sample.failed && finite(sample.albedo);
    // What a mirror shows such a ray does not tell if the mirror has an albedo of its own to tell.
    const std::uint32_t before = items_[pixel];
    if (!usable)
        set_item(pixel, unknown);
    else if (!numbers.is_mirror(sample.surface) ||
             sample.reflected_surface != Sample::no_reflection)
        set_item(pixel, numbers.of(sample.surface, sample.reflected_surface));
    else if (before != unknown && numbers.surface(before) != sample.surface)
        set_item(pixel, unknown);
    if (usable)
        set_albedo(pixel, sample.albedo);
    else
        set_state(pixel, Albedo::unreliable);
}

void DetailMap::distrust(Pixel pixel) {
    ++contradicted_;
    forget_square(pixel);
}

void DetailMap::forget_square(Pixel pixel) {
    const auto width = static_cast<Pixel>(width_), height = static_cast<Pixel>(height_);
    constexpr Pixel side = BfSquares::side;
    const Pixel left = pixel % width / side * side, top = pixel / width / side * side;
    for (Pixel y = top; y < std::min(top + side, height); ++y)
        for (Pixel x = left; x < std::min(left + side, width); ++x) {
            const Pixel p = y * width + x;
            if (told_[p]) continue;
            told_[p] = true;
            set_item(p, unknown);
            set_state(p, Albedo::unreliable);
        }
}

std::vector<DetailMap::Extent> DetailMap::extents(const ItemNumbers& numbers) const {
    std::vector<Extent> extents(numbers.size());
    std::vector<Pixel> longest(extents.size());
    const auto width = static_cast<Pixel>(width_);
    for (Pixel row = 0; row < pixels(); row += width)
        for (Pixel begin = row, end = row; begin < row + width; begin = end) {
            const std::uint32_t item = items_[begin];
            end = static_cast<Pixel>(items_.end_of_run(begin, row + width));
            if (item == unknown) continue;
            extents[item].pixels += end - begin;
            if (end - begin <= longest[item]) continue;
            longest[item] = end - begin;
            extents[item].middle = begin + (end - begin) / 2;
        }
    return extents;
}

}  // namespace povpreview
