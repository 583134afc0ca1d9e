// SPDX-License-Identifier: AGPL-3.0-or-later
#include "adapter/crash_search.h"

#include <algorithm>
#include <cassert>

namespace povpreview {

std::optional<Sequence> CrashSearch::died(Sequence first_gap, Sequence sent_end,
                                          std::size_t outstanding) {
    assert(outstanding > 0 && first_gap < sent_end);
    if (searching()) {
        if (outstanding == 1) return first_gap;
        single_end_ = chunk_end_;
        return std::nullopt;
    }
    if (first_gap >= watch_end_) {
        deaths_ = 0;
        watch_end_ = sent_end;
    }
    if (++deaths_ >= patience) {
        search_end_ = sent_end;
        single_end_ = 0;
    }
    return std::nullopt;
}

Sequence CrashSearch::next(Sequence begin, Sequence end) {
    if (begin >= search_end_) {
        *this = CrashSearch();
        return begin;
    }
    chunk_end_ = std::min({begin + (begin < single_end_ ? 1 : chunk), search_end_, end});
    return chunk_end_;
}

}  // namespace povpreview
