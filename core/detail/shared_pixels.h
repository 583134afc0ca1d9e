// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <boost/smart_ptr/intrusive_ptr.hpp>
#include <boost/smart_ptr/intrusive_ref_counter.hpp>
#include <cstddef>
#include <span>
#include <vector>

namespace povpreview {

/// A value for each pixel. Copies share, block by block, what neither has changed since: a picture
/// keeps what was known when it was made for next to nothing. Each copy is for one thread at a
/// time; threads may have copies of the same.
template <class T>
class SharedPixels {
   public:
    SharedPixels(std::size_t pixels, const T& value)
        : blocks_((pixels + per_block - 1) / per_block, new Block(value)) {}

    const T& operator[](std::size_t pixel) const {
        return blocks_[pixel / per_block]->values[pixel % per_block];
    }
    void set(std::size_t pixel, const T& value) {
        boost::intrusive_ptr<Block>& block = blocks_[pixel / per_block];
        if (block->values[pixel % per_block] == value) return;
        if (block->use_count() > 1) block = new Block(*block);
        block->values[pixel % per_block] = value;
    }

    /// The first pixel from `begin` on with another value, or `end`. REQUIRES: begin < end.
    std::size_t end_of_run(std::size_t begin, std::size_t end) const {
        const T value = (*this)[begin];
        for (std::size_t pixel = begin; pixel < end;) {
            const std::size_t first = pixel % per_block,
                              count = std::min(per_block - first, end - pixel);
            const std::span part =
                std::span(blocks_[pixel / per_block]->values).subspan(first, count);
            const auto other = std::ranges::find_if(part, [&](const T& v) { return v != value; });
            pixel += static_cast<std::size_t>(other - part.begin());
            if (other != part.end()) return pixel;
        }
        return end;
    }

    /// Sets those from `begin` to before `end`. Returns how many of them had the value
    /// `counted`.
    std::size_t fill(std::size_t begin, std::size_t end, const T& value, const T& counted) {
        std::size_t count = 0;
        while (begin < end) {
            boost::intrusive_ptr<Block>& block = blocks_[begin / per_block];
            const std::size_t first = begin % per_block,
                              last = std::min(per_block, first + (end - begin));
            const auto part = [&] { return std::span(block->values).subspan(first, last - first); };
            count += static_cast<std::size_t>(std::ranges::count(part(), counted));
            begin += last - first;
            if (std::ranges::all_of(part(), [&](const T& v) { return v == value; })) continue;
            if (block->use_count() > 1) block = new Block(*block);
            std::ranges::fill(part(), value);
        }
        return count;
    }

   private:
    static constexpr std::size_t per_block = 4096;
    struct Block : boost::intrusive_ref_counter<Block> {
        explicit Block(const T& value) { values.fill(value); }
        std::array<T, per_block> values;
    };

    std::vector<boost::intrusive_ptr<Block>> blocks_;
};

}  // namespace povpreview
