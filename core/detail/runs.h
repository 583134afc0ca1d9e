// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <algorithm>

namespace povpreview {

/// Neighbouring pixels mostly show the same, and what is the same is dealt with in one go: the
/// first element after `begin` that differs from it, or `end`. REQUIRES: begin != end.
template <class Iterator>
Iterator end_of_run(Iterator begin, Iterator end) {
    return std::find_if(begin + 1, end, [&](const auto& value) { return value != *begin; });
}

/// Calls visit(first, last) for each run in turn, of the elements from `first` to before `last`.
template <class Iterator, class Visit>
void visit_runs(Iterator begin, Iterator end, const Visit& visit) {
    for (Iterator next = begin; begin != end; begin = next) {
        next = end_of_run(begin, end);
        visit(begin, next);
    }
}

}  // namespace povpreview
