// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <bit>
#include <cassert>
#include <cstdint>
#include <vector>

#include "core/oracle.h"

namespace povpreview {

/// Number of a request in the order of submission, from 0.
using Sequence = std::uint64_t;

/// Requests in order, each to be answered at any time, to be taken out in order. A ring, so that no
/// request costs an allocation:
///
///     begin()          first gap                 end()
///       | answered ...   | waiting | answered | ... |
///
class SampleQueue {
   public:
    struct Slot {
        Sample sample;
        bool answered = false;
    };

    Sequence begin() const { return begin_; }
    Sequence end() const { return end_; }
    bool empty() const { return begin_ == end_; }

    void push(const Request& request, Parts parts) {
        if (end_ - begin_ == slots_.size()) grow();
        at(end_) = {.sample = {.position = request.position,
                               .kind = request.kind,
                               .rung = request.rung,
                               .parts = parts},
                    .answered = false};
        ++end_;
    }
    Slot& operator[](Sequence s) {
        assert(s >= begin_ && s < end_);
        return at(s);
    }
    /// Whether it has been answered; those taken out have.
    bool answered(Sequence s) const {
        assert(s < end_);
        return s < begin_ || slots_[s & (slots_.size() - 1)].answered;
    }
    /// The first one that has no answer, or end().
    Sequence first_gap() const {
        Sequence s = begin_;
        while (s < end_ && answered(s)) ++s;
        return s;
    }
    /// Appends the answered ones before the first gap to `samples`, and forgets them.
    void take(std::vector<Sample>& samples) {
        for (; begin_ < end_ && at(begin_).answered; ++begin_) samples.push_back(at(begin_).sample);
    }

   private:
    Slot& at(Sequence s) { return slots_[s & (slots_.size() - 1)]; }
    void grow() {
        std::vector<Slot> larger(2 * slots_.size());
        for (Sequence s = begin_; s < end_; ++s) larger[s & (larger.size() - 1)] = at(s);
        slots_ = std::move(larger);
    }

    std::vector<Slot> slots_ = std::vector<Slot>(1024);  ///< a power of two
    Sequence begin_ = 0, end_ = 0;
};

}  // namespace povpreview
