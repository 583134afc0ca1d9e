// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>
#include <glm/vec4.hpp>
#include <vector>

#include "core/polygonal/face_hierarchy.h"
#include "core/polygonal/flat_faces.h"
#include "core/polygonal/shadow_volumes.h"

namespace povpreview {

/// Where two faces pass through each other: an edge of the picture that is no edge of a face.
struct Crossing {
    SpaceSegment segment;
    std::uint32_t f, g;
};

/// All crossings of faces that are seen or cast shadows. Faces that merely touch (see `contact`) do
/// not cross. `go_on` is asked before each pair of faces that may: there is no end to those of
/// grass.
std::vector<Crossing> find_crossings(const FlatFaces& faces, const FaceHierarchy& hierarchy,
                                     const std::function<bool(std::size_t found)>& go_on);

/// Where visible faces pass through a plane.
std::vector<SpaceSegment> find_cuts(const FlatFaces& faces, const NearPlane& plane);

}  // namespace povpreview
