// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "core/image_edge.h"

namespace povpreview {

/// Ends of pieces closer than this, in pixels, become one point: what is finer than a quarter of a
/// pixel is not seen in a picture of whole pixels, and each vertex of the mesh costs samples.
inline constexpr double chain_snap = .25;
/// How far, in pixels, a chain may cut a corner of the pieces that it stands for; for the same
/// reason.
inline constexpr double chain_flatness = .25;

/// Makes of pieces of edges, many and fragmented, few long chains, heaviest first.
///
/// Pieces are clipped to the image; those with a coordinate that is no number, or along the image's
/// border, are dropped. Ends that lie close together become one; pieces on top of each other are
/// merged; pieces of equal kind and light are joined where two meet, or where of more the two run
/// straight on; then the chains are simplified. No piece is farther than chain_snap twice (once for
/// its ends, once for others' ends beside it) and chain_flatness from a chain; a piece along the
/// heaviest of straight lines keeps to it exactly. Chains may cross and touch each other.
///
/// Pieces are taken heaviest first (importance x length), and no more of them than one pixel of
/// length for each pixel of the image: where edges are denser, interpolation is of no use.
/// Depends on the pieces alone, hardly ever on their order (only where two weigh the very same).
std::vector<EdgeChain> chain_edges(std::vector<ImageEdge> pieces, glm::ivec2 size);

}  // namespace povpreview
