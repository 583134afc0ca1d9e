// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

namespace povpreview::tracer {

/// Intersection::i1 of a hit on a prism, as in POV-Ray's shape/prism.cpp; on a side, i2 is the
/// number of the segment.
constexpr int base_hit = 1, cap_hit = 2, spline_hit = 3;

}  // namespace povpreview::tracer
