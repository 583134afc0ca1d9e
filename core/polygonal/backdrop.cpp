// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/polygonal/backdrop.h"

#include <algorithm>

namespace povpreview {

double nearness(const Backdrop& b, double t) {
    const double share = (t - b.part.from) / (b.part.to - b.part.from);
    return b.nearness_from + share * (b.nearness_to - b.nearness_from);
}

namespace {

void push(std::vector<Backdrop>& parts, const Backdrop& b, double from, double to) {
    if (to - from <= IntervalSet::shortest) return;
    if (!parts.empty() && parts.back().face == b.face && parts.back().part.to == from) {
        parts.back().part.to = to;
        parts.back().nearness_to = nearness(b, to);
        return;
    }
    parts.push_back({{from, to}, nearness(b, from), nearness(b, to), b.face});
}

/// Of two backdrops, calls keep(nearer one, from, to) for the parts of an interval.
template <class Keep>
void compare(const Backdrop& a, const Backdrop& b, double from, double to, const Keep& keep) {
    const double at_from = nearness(a, from) - nearness(b, from);
    const double at_to = nearness(a, to) - nearness(b, to);
    if (at_from >= 0 && at_to >= 0) return keep(a, from, to);
    if (at_from <= 0 && at_to <= 0) return keep(b, from, to);
    const double crossing = from + (to - from) * at_from / (at_from - at_to);
    keep(at_from > 0 ? a : b, from, crossing);
    keep(at_from > 0 ? b : a, crossing, to);
}

}  // namespace

void put_in_front(Backdrop backdrop, std::vector<Backdrop>& nearest) {
    double from = backdrop.part.from;  // where the rest of it begins
    const double end = backdrop.part.to;
    // They are in order, so those that it meets stand side by side.
    const auto first = std::partition_point(nearest.begin(), nearest.end(),
                                            [&](const Backdrop& b) { return b.part.to <= from; });
    const auto last = std::partition_point(first, nearest.end(),
                                           [&](const Backdrop& b) { return b.part.from < end; });
    std::vector<Backdrop> merged;
    for (auto old = first; old != last; ++old) {
        const double low = std::max(from, old->part.from), high = std::min(end, old->part.to);
        push(merged, backdrop, from, low);
        push(merged, *old, old->part.from, low);
        compare(backdrop, *old, low, high,
                [&](const Backdrop& nearer, double a, double b) { push(merged, nearer, a, b); });
        push(merged, *old, high, old->part.to);
        from = high;
    }
    push(merged, backdrop, from, end);
    const auto kept = std::min(last - first, std::ptrdiff_t(merged.size()));
    std::copy_n(merged.begin(), kept, first);
    if (kept < last - first)
        nearest.erase(first + kept, last);
    else
        nearest.insert(last, merged.begin() + kept, merged.end());
}

bool covered(std::span<const Backdrop> nearest) {
    double end = 0;
    for (const Backdrop& backdrop : nearest) {
        if (backdrop.part.from - end > IntervalSet::shortest) return false;
        end = backdrop.part.to;
    }
    return 1 - end <= IntervalSet::shortest;
}

void parts_in_front(Backdrop backdrop, std::span<const Backdrop> nearest,
                    std::vector<Backdrop>& parts) {
    double from = backdrop.part.from;
    const double end = backdrop.part.to;
    for (const Backdrop& other : nearest) {
        const double low = std::max(from, other.part.from), high = std::min(end, other.part.to);
        if (low >= high) continue;
        push(parts, backdrop, from, low);
        compare(backdrop, other, low, high, [&](const Backdrop& nearer, double a, double b) {
            if (&nearer == &backdrop) push(parts, backdrop, a, b);
        });
        from = high;
    }
    if (from < end) push(parts, backdrop, from, end);
}

}  // namespace povpreview
