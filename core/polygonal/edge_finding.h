// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "core/image_edge.h"
#include "core/polygonal/polygon_scene.h"

namespace povpreview {

struct EdgeFinding {
    int mirror_depth = 1;  ///< reflections of reflections followed; 0: no mirrors at all
    /// Boxes of faces looked at (FaceHierarchy::effort), some seconds' worth: where a hundred
    /// thousand faces lie behind each other, most time goes to edges that nobody sees.
    std::uint64_t most_effort = 400'000'000;
};

/// Is given pieces as they become known, and the effort so far; returns whether to go on.
using EdgesFound = std::function<bool(std::vector<ImageEdge>&& pieces, std::uint64_t effort)>;

/// Finds the discontinuity edges of a polygonal scene without tracing a ray (paper, section 3):
/// visible edges of faces, visible borders of shadows, and both as seen in flat mirrors.
///
/// First come the geometric edges, then the shadows light by light, brightest first, then mirror by
/// mirror, largest first. Returns whether all were found: false where `found` or the bound on the
/// effort has ended the search. Pieces are clipped to the image. They are exact up to rounding:
/// which parts are visible is decided by exact predicates on the scene's own points.
bool find_edges(const PolygonScene& scene, const EdgeFinding& options, const EdgesFound& found);

}  // namespace povpreview
