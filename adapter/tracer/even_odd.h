// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

namespace povpreview::tracer {

struct Point2 {
    double u = 0, v = 0;
};
inline bool operator==(const Point2& a, const Point2& b) { return a.u == b.u && a.v == b.v; }

/// Closed; the last corner is joined to the first.
using Ring = std::vector<Point2>;

/// Cuts the inside of rings, by POV-Ray's even-odd rule, into convex pieces: between the levels of
/// all corners and crossings the sides do not meet, and every other gap is inside.
///
///     +-----+             +-----+        level
///     |     +-----+       |     +-----+  level
///     |  +--|--+  |  ->   |  +--+--+  |  level, where the hole begins
///     |  |  |  |  |       |  |  |  |  |
///     +--+--+--+--+       +--+  +--+--+  level
///
/// Makes no difference between rings that are simple, nested, or cross themselves or each other.
std::vector<Ring> trapezoids(const std::vector<Ring>& rings);

}  // namespace povpreview::tracer
