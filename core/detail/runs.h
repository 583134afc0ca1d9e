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

}  // namespace povpreview
