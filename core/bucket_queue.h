// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace povpreview {

/// Gives what weighs most first, to within an eighth of a power of two; of what weighs the same by
/// that, the oldest first. Either end takes next to no time however much is in it, unlike with a
/// heap.
template <class T>
class BucketQueue {
   public:
    bool empty() const { return size_ == 0; }
    std::size_t size() const { return size_; }

    /// REQUIRES: the weight is not negative, and a number.
    void push(float weight, const T& thing) {
        const std::size_t number = bucket_of(weight);
        buckets_[number].things.push_back(thing);
        top_ = std::max(top_, number);
        ++size_;
    }
    /// REQUIRES: it is not empty.
    T pop() {
        while (buckets_[top_].things.empty()) --top_;
        Bucket& bucket = buckets_[top_];
        const T thing = bucket.things[bucket.taken++];
        if (bucket.taken == bucket.things.size()) bucket = {};
        --size_;
        return thing;
    }

   private:
    struct Bucket {
        std::vector<T> things;
        std::size_t taken = 0;  // of them, from the first on
    };
    /// From 2^-24 on; the exponent and the first three bits of the mantissa count the rest.
    static constexpr std::uint32_t per_octave = 8, first = (127 - 24) * per_octave, buckets = 384;

    static std::size_t bucket_of(float weight) {
        const std::uint32_t number = std::bit_cast<std::uint32_t>(weight) >> 20;
        return std::clamp(number, first, first + buckets - 1) - first;
    }

    std::array<Bucket, buckets> buckets_;
    std::size_t top_ = 0, size_ = 0;
};

}  // namespace povpreview
