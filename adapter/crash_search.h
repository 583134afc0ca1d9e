// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>

#include "adapter/sample_queue.h"

namespace povpreview {

/// Finds a sample that kills the tracer, by what is still unanswered whenever it dies.
///
/// A tracer may die for many reasons, so at first everything unanswered is simply sent again. Once
/// it has died `patience` times without getting past the same requests, these are suspects, and are
/// sent a chunk at a time; if a chunk kills, its samples are sent one at a time. As a death costs
/// parsing the scene anew and a chunk only a round trip, this beats bisection.
///
///     | innocent | innocent | x . . . . | not yet searched | not suspected
///                             ^ next()    ^ chunk_end_       ^ search_end_
///
class CrashSearch {
   public:
    static constexpr int patience = 3;
    static constexpr Sequence chunk = 64;

    /// To be told of every death while `outstanding` > 0 requests were sent and not answered, the
    /// first of them `first_gap`, all before `sent_end`. Returns the killer once it is certain.
    std::optional<Sequence> died(Sequence first_gap, Sequence sent_end, std::size_t outstanding);

    /// Whether requests must be sent as next() says, each range only when no answer is outstanding.
    bool searching() const { return search_end_ > 0; }
    /// The end of the range from `begin` to be sent next. Behind the suspects the search is over,
    /// and the range empty.
    Sequence next(Sequence begin, Sequence end);

   private:
    int deaths_ = 0;           ///< without getting past watch_end_
    Sequence watch_end_ = 0;   ///< what was sent at the first of these deaths ends here
    Sequence search_end_ = 0;  ///< suspects end here; 0: no search
    Sequence chunk_end_ = 0;   ///< of the range sent last
    Sequence single_end_ = 0;  ///< up to here one at a time
};

}  // namespace povpreview
