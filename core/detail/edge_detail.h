// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <span>

#include "core/detail/detail_map.h"

namespace povpreview {

struct VertexSample;

/// What the DetailMap leaves of the distance of two samples' colours (colour_distance()): pixels
/// between two items take each the colour of its own, and pixels of known albedo the light alone.
float detailed_distance(const DetailMap& detail, const VertexSample& p, const VertexSample& q,
                        float colours);

/// The distance of two samples' light on an albedo between theirs.
float light_distance(const VertexSample& p, const VertexSample& q);

/// A pixel on the line p-q in the middle of the longest stretch whose item is known and none of
/// `ends`; nothing where there is no stretch that is worth a sample.
std::optional<Pixel> stray_pixel(const DetailMap& detail, glm::dvec2 p, glm::dvec2 q,
                                 std::span<const std::uint32_t> ends);

}  // namespace povpreview
