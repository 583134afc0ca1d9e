// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>
#include <glm/vec2.hpp>
#include <vector>

#include "core/image_edge.h"
#include "display/image.h"
#include "tests/bench/edge_positions/near.h"

/// How well constraints lie where a picture rendered several times as fine has its edges.
namespace povpreview {

/// A jump between two neighbouring pixels of the fine picture is strong from this on: the square
/// root of the paper's colour distance, on encoded colour (1 between black and white).
///
/// A discontinuity of a picture without anti-aliasing lies between two pixels, whatever its size;
/// shading that comes up to this would have to run from black to white within 20 fine pixels, 5
/// pixels of the picture, as it does nowhere on flat or smoothly curved things, nor in highlights
/// of them that are worth the name.
inline constexpr double strong_jump = .05;

/// How far, in pixels of the picture, a jump may lie from its constraint and the other way round.
inline constexpr double tolerance = .5;

/// Where neighbours in `fine` (encoded) differ strongly: middles between them, in pixels of the
/// picture that is `scale` times as coarse.
std::vector<glm::dvec2> strong_jumps(const Image& fine, int scale);

/// Share of jumps that have a constraint.
struct JumpsFound {
    std::size_t jumps = 0, found = 0;
    std::vector<glm::dvec2> missed;
    double share() const { return jumps ? double(found) / double(jumps) : 1; }
};
/// Of those jumps that `counts` (may be empty: all).
JumpsFound find_jumps(const std::vector<glm::dvec2>& jumps, const NearSegments& constraints,
                      const std::function<bool(glm::dvec2)>& counts = {});

/// Where constraints lie, pixels of length.
struct ConstraintsPlaced {
    double on = 0;      ///< within the tolerance of a strong jump
    double even = 0;    ///< no contrast across: the colours a pixel away on both sides are alike,
                        ///< or change without any strong jump
    double beside = 0;  ///< the strong jump across lies farther away, on another constraint
    double off = 0;     ///< the strong jump across lies farther away, and on no constraint
    std::vector<glm::dvec2> misplaced;  ///< middles of the steps that are `off`
    double length() const { return on + even + beside + off; }
    /// Of the length, what lies on a jump or makes no contrast of its own. What is beside another
    /// constraint's jump is right, too: there is no contrast within the tolerance of it.
    double share() const { return length() > 0 ? 1 - off / length() : 1; }
};
/// Of `chains`, against the jumps of `fine`; `all` are the constraints of every kind.
ConstraintsPlaced place_constraints(const std::vector<EdgeChain>& chains, const NearSegments& all,
                                    const std::vector<glm::dvec2>& jumps, const Image& fine,
                                    int scale);

}  // namespace povpreview
