// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/ids.h"

namespace povpreview {

/// The edges of the triangulation, heaviest first (paper, section 2).
///
/// Entries are never taken back: when an edge vanishes its entry stays, and when its weight changes
/// there may be two. Whoever pops an entry asks the mesh whether it still holds. Ties are broken by
/// the vertices' numbers, so the order of entries depends on nothing else.
class RefinementHeap {
   public:
    struct Entry {
        float weight;
        VertexId a, b;  ///< a < b
    };

    void push(VertexId a, VertexId b, float weight);
    /// Removes and returns the heaviest entry.
    std::optional<Entry> pop();

    bool empty() const { return entries_.empty(); }
    std::span<const Entry> entries() const { return entries_; }
    void clear() { entries_ = {}; }

   private:
    std::vector<Entry> entries_;
};

}  // namespace povpreview
