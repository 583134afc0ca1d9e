// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <unordered_map>
#include <vector>

#include "core/bf_squares.h"
#include "core/detail/item_buffer.h"
#include "core/detail/shared_pixels.h"
#include "core/oracle.h"

namespace povpreview {

/// Numbers from 0 on, in the order in which they are met, surfaces, and of mirrors each surface
/// that is seen in them: an item is such a number.
class ItemNumbers {
   public:
    /// Surfaces whose items are told apart by what they reflect, ascending. Numbers that a surface
    /// had before are no more given for it.
    void set_mirrors(std::vector<std::uint32_t> mirrors) { mirrors_ = std::move(mirrors); }
    bool is_mirror(std::uint32_t surface) const {
        return std::binary_search(mirrors_.begin(), mirrors_.end(), surface);
    }
    /// `reflected` tells only of mirrors; as Sample::reflected_surface.
    std::uint32_t of(std::uint32_t surface, std::uint32_t reflected = Sample::no_reflection) {
        const std::uint64_t seen = is_mirror(surface) ? reflected : Sample::no_reflection;
        return number(seen << 32 | surface);
    }
    std::size_t size() const { return seen_.size(); }
    std::uint32_t surface(std::uint32_t item) const {
        return static_cast<std::uint32_t>(seen_[item]);
    }
    /// Adds what `others` number and these do not; what each of them is here, `several` for a
    /// surface that is a mirror here and was none there.
    std::vector<std::uint32_t> add(const ItemNumbers& others) {
        std::vector<std::uint32_t> here;
        for (const std::uint64_t seen : others.seen_) {
            const bool parted =
                seen >> 32 == Sample::no_reflection && is_mirror(static_cast<std::uint32_t>(seen));
            here.push_back(parted ? several : number(seen));
        }
        return here;
    }
    static constexpr std::uint32_t several = 0xffffffff;

   private:
    std::uint32_t number(std::uint64_t seen) {
        const auto next = static_cast<std::uint32_t>(seen_.size());
        const auto [found, is_new] = numbers_.try_emplace(seen, next);
        if (is_new) seen_.push_back(seen);
        return found->second;
    }

    std::unordered_map<std::uint64_t, std::uint32_t> numbers_;
    std::vector<std::uint64_t> seen_;  // by item: what is reflected << 32 | surface
    std::vector<std::uint32_t> mirrors_;
};

/// What is known of each pixel without a full sample of it: the surface that is seen there, and
/// that surface's albedo where it varies (paper, section 2). It comes from an item buffer, from
/// albedo rays, or from both; where a ray says otherwise, the ray is right.
class DetailMap {
   public:
    static constexpr std::uint32_t unknown = 0xffffffff;  ///< item: only tracing can tell

    enum class Albedo : std::uint8_t {
        constant,  ///< one colour all over the surface: nothing to be told apart from light
        known,
        wanted,     ///< an albedo ray would tell
        unreliable  ///< not to be asked for
    };

    /// Nothing is known.
    DetailMap(int width, int height);

    /// Takes what was drawn, before rays tell anything. Sizes must agree, and mirrors.
    void accept(const ItemBuffer& drawn, ItemNumbers& numbers);
    /// Takes what rays have told another map of the same size, whose items have these numbers here,
    /// see ItemNumbers::add(); where they met a mirror that was not known as one, it shows what was
    /// drawn.
    void accept_told(const DetailMap& other, std::span<const std::uint32_t> numbers);
    /// Takes an albedo ray through a pixel's centre.
    void accept_albedo(Pixel pixel, const Sample& sample, ItemNumbers& numbers);
    /// Whether something else is known of a pixel than the item that a full sample of it met.
    bool contradicts(Pixel pixel, std::uint32_t item) const {
        return items_[pixel] != unknown && items_[pixel] != item;
    }
    /// Makes the pixel's square unreliable: nothing is known there any more.
    void distrust(Pixel pixel);

    Pixel pixel_at(glm::dvec2 position) const;  ///< clamped to the image
    std::uint32_t item(Pixel pixel) const { return items_[pixel]; }
    Albedo albedo_state(Pixel pixel) const { return states_[pixel]; }
    /// Whether an albedo ray would tell anything new.
    bool wants_albedo(Pixel pixel) const { return states_[pixel] == Albedo::wanted; }
    /// Linear; where it is known.
    const glm::vec3& albedo(Pixel pixel) const { return albedos_[pixel]; }

    std::size_t known() const { return known_; }                ///< pixels whose surface is known
    std::size_t albedos() const { return albedos_known_; }      ///< pixels whose albedo is known
    std::size_t contradicted() const { return contradicted_; }  ///< samples that contradicted

    /// A pixel well inside of what is seen of each item, and how many pixels that is.
    struct Extent {
        Pixel middle = 0;  ///< of the item's longest run of pixels in a row
        std::uint32_t pixels = 0;
    };
    std::vector<Extent> extents(const ItemNumbers& numbers) const;

   private:
    std::size_t pixels() const {
        return static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
    }
    void forget_square(Pixel pixel);
    void accept_look(const ItemBuffer& drawn, Pixel begin, Pixel end);
    void set_items(Pixel begin, Pixel end, std::uint32_t item);
    void set_item(Pixel pixel, std::uint32_t item) { set_items(pixel, pixel + 1, item); }
    void set_albedo(Pixel pixel, const glm::vec3& albedo);
    void set_state(Pixel pixel, Albedo state);

    int width_, height_;
    SharedPixels<std::uint32_t> items_;
    SharedPixels<Albedo> states_;
    SharedPixels<glm::vec3> albedos_;
    std::vector<bool> told_;  // by a ray
    std::size_t known_ = 0, albedos_known_ = 0, contradicted_ = 0;
};

}  // namespace povpreview
