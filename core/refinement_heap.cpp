// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/refinement_heap.h"

#include <algorithm>
#include <tuple>

namespace povpreview {

namespace {
bool lighter(const RefinementHeap::Entry& p, const RefinementHeap::Entry& q) {
    if (p.weight != q.weight) return p.weight < q.weight;
    return std::tie(q.a, q.b) < std::tie(p.a, p.b);
}
}  // namespace

void RefinementHeap::push(VertexId a, VertexId b, float weight) {
    if (b < a) std::swap(a, b);
    entries_.push_back({weight, a, b});
    std::push_heap(entries_.begin(), entries_.end(), lighter);
}

std::optional<RefinementHeap::Entry> RefinementHeap::pop() {
    if (entries_.empty()) return std::nullopt;
    std::pop_heap(entries_.begin(), entries_.end(), lighter);
    const Entry entry = entries_.back();
    entries_.pop_back();
    return entry;
}

}  // namespace povpreview
