// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <limits>

namespace povpreview {

/// A number that counts things of one kind only: a vertex's number is no sample's number.
template <class Kind>
struct Id {
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
    std::uint32_t value = none;

    constexpr bool valid() const { return value != none; }
    constexpr auto operator<=>(const Id&) const = default;
};

/// A vertex of the triangulation; counts up from 0 in order of insertion and is never used again.
using VertexId = Id<struct VertexKind>;
/// A sample that a vertex carries; a vertex on a constraint carries one for each of its sectors.
using SampleId = Id<struct SampleKind>;

}  // namespace povpreview

template <class Kind>
struct std::hash<povpreview::Id<Kind>> {
    std::size_t operator()(povpreview::Id<Kind> id) const noexcept { return id.value; }
};
