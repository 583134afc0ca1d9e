// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>

#include "core/ids.h"
#include "core/image_edge.h"

namespace povpreview {

/// What a constraint stands for. Where two coincide the lesser one counts: a shadow that ends at a
/// surface's border is hidden by it.
struct ConstraintLabel {
    EdgeKind kind = EdgeKind::traced;
    std::uint16_t light = 0;  ///< shadows and their reflections: the number of the light
    auto operator<=>(const ConstraintLabel&) const = default;
};

/// The labels of all constrained edges.
class ConstraintLabels {
   public:
    /// Adds an edge; where it is labelled already, the lesser label counts.
    void add(VertexId a, VertexId b, ConstraintLabel label) {
        const auto [place, fresh] = labels_.emplace(key(a, b), label);
        if (!fresh) {
            if (place->second <= label) return;
            --count(place->second.kind);
            place->second = label;
        }
        ++count(label.kind);
    }
    /// Removes an edge; nothing where it is not there.
    std::optional<ConstraintLabel> take(VertexId a, VertexId b) {
        const auto place = labels_.find(key(a, b));
        if (place == labels_.end()) return std::nullopt;
        const ConstraintLabel label = place->second;
        labels_.erase(place);
        --count(label.kind);
        return label;
    }
    std::optional<ConstraintLabel> find(VertexId a, VertexId b) const {
        const auto place = labels_.find(key(a, b));
        if (place == labels_.end()) return std::nullopt;
        return place->second;
    }
    std::size_t size() const { return labels_.size(); }
    const std::array<std::size_t, edge_kinds>& counts() const { return counts_; }

   private:
    static std::uint64_t key(VertexId a, VertexId b) {
        const auto [low, high] = std::minmax(a.value, b.value);
        return std::uint64_t{high} << 32 | low;
    }
    /// std::hash of a number is the number itself; this spreads those of neighbours.
    struct Spread {
        std::size_t operator()(std::uint64_t k) const {
            return (k ^ k >> 32) * 0x9e3779b97f4a7c15u >> 16;
        }
    };
    std::size_t& count(EdgeKind kind) { return counts_[static_cast<std::size_t>(kind)]; }

    std::unordered_map<std::uint64_t, ConstraintLabel, Spread> labels_;
    std::array<std::size_t, edge_kinds> counts_{};
};

}  // namespace povpreview
