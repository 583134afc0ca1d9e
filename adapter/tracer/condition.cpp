// SPDX-License-Identifier: AGPL-3.0-or-later
#include "backend/oracle/condition.h"

#include <algorithm>

namespace povpreview::tracer {

Condition Condition::inside(std::uint32_t solid) {
    Condition result(Extent::somewhere);
    result.steps_ = {static_cast<std::int32_t>(solid)};
    result.depth_ = 1;
    return result;
}

/// The deeper one first: the other then needs but one place more.
Condition Condition::joined(const Condition& a, const Condition& b, Step step) {
    const Condition &first = a.depth_ >= b.depth_ ? a : b, &second = a.depth_ >= b.depth_ ? b : a;
    Condition result = first;
    // What is too long already need not grow any more: it will not be used.
    if (!first.too_long())
        result.steps_.insert(result.steps_.end(), second.steps_.begin(), second.steps_.end());
    result.steps_.push_back(step);
    result.depth_ = std::max(first.depth_, second.depth_ + 1);
    return result;
}

Condition operator!(const Condition& a) {
    if (a.extent_ == Condition::Extent::everywhere) return Condition::nowhere();
    if (a.extent_ == Condition::Extent::nowhere) return Condition::everywhere();
    Condition result = a;
    if (result.steps_.back() == Condition::step_not)
        result.steps_.pop_back();
    else
        result.steps_.push_back(Condition::step_not);
    return result;
}

Condition operator&(const Condition& a, const Condition& b) {
    using Extent = Condition::Extent;
    if (a.extent_ == Extent::nowhere || b.extent_ == Extent::everywhere) return a;
    if (b.extent_ == Extent::nowhere || a.extent_ == Extent::everywhere) return b;
    return Condition::joined(a, b, Condition::step_and);
}

Condition operator|(const Condition& a, const Condition& b) {
    using Extent = Condition::Extent;
    if (a.extent_ == Extent::everywhere || b.extent_ == Extent::nowhere) return a;
    if (b.extent_ == Extent::everywhere || a.extent_ == Extent::nowhere) return b;
    return Condition::joined(a, b, Condition::step_or);
}

}  // namespace povpreview::tracer
