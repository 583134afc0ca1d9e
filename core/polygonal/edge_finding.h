// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "core/image_edge.h"
#include "core/polygonal/polygon_scene.h"

namespace povpreview {

struct EdgeFinding {
    int mirror_depth = 1;  ///< reflections of reflections followed; 0: no mirrors at all
};

/// Finds the discontinuity edges of a polygonal scene without tracing a ray (paper, section 3):
/// visible edges of faces, visible borders of shadows, and both as seen in flat mirrors.
///
/// `found` is given pieces as they become known: first the geometric edges, then the shadows light
/// by light, brightest first, then mirror by mirror, largest first; it returns whether to go on.
/// Pieces are clipped to the image. They are exact up to rounding: which parts are visible is
/// decided by exact predicates on the scene's own points.
void find_edges(const PolygonScene& scene, const EdgeFinding& options,
                const std::function<bool(std::vector<ImageEdge>&& pieces)>& found);

}  // namespace povpreview
