// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <vector>

namespace povpreview {

/// Part of a segment, from its point at parameter `from` to that at `to`, 0 <= from < to <= 1.
struct Interval {
    double from = 0, to = 1;
};

/// Where two linear functions of the parameter, given by their values at 0 and 1, are positive:
/// cuts the interval down to that; false where nothing is left (Cyrus and Beck's clipping, one
/// step).
inline bool clip(Interval& interval, double at0, double at1) {
    if (at0 <= 0) {
        if (at1 <= 0) return false;
        interval.from = std::max(interval.from, at0 / (at0 - at1));
    } else if (at1 <= 0) {
        interval.to = std::min(interval.to, at0 / (at0 - at1));
    }
    return interval.from < interval.to;
}

/// What is left of a segment when parts are taken off it: intervals in order, apart from each
/// other.
class IntervalSet {
   public:
    /// Rests shorter than this are rounding errors, such as the seam between two faces that hide
    /// what is behind both.
    static constexpr double shortest = 1e-9;

    void assign(Interval whole) { left_.assign(1, whole); }
    bool empty() const { return left_.empty(); }
    const std::vector<Interval>& intervals() const { return left_; }

    void subtract(Interval part) {
        for (std::size_t i = 0; i < left_.size();) {
            const Interval old = left_[i];
            if (part.to <= old.from || part.from >= old.to) {
                ++i;
                continue;
            }
            const bool head = part.from - old.from > shortest, tail = old.to - part.to > shortest;
            if (head && tail) {
                left_[i].to = part.from;
                left_.insert(left_.begin() + static_cast<std::ptrdiff_t>(i) + 1, {part.to, old.to});
                i += 2;
            } else if (head) {
                left_[i++].to = part.from;
            } else if (tail) {
                left_[i++].from = part.to;
            } else {
                left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(i));
            }
        }
    }

   private:
    std::vector<Interval> left_;
};

}  // namespace povpreview
