// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "core/image_edge.h"
#include "tests/core/polygonal/brute_force.h"

namespace povpreview {

/// How the picture differs between two near positions of the image.
struct Change {
    EdgeKind kind = EdgeKind::geometric;
    std::uint64_t path = 0;    ///< kind reflection: by which mirrors
    std::uint32_t lights = 0;  ///< kind shadow: bit i for light i of the scene's list
    /// A matter of taste whether this is an edge: faces in one plane that differ in name alone,
    /// shadows of transparent faces, where smooth shading turns away from the light.
    bool optional = false;
};

/// The first difference, front to back, that is no matter of taste; else one that is; else none.
std::optional<Change> change_between(const BruteForce& brute, const Sight& a, const Sight& b);

/// A position between `a` and `b` (pixels) where the sight changes, to within 1e-9 pixel: `a` and
/// `b` are moved there, one to each side. REQUIRES: their sights differ in faces or lights.
void close_in(const BruteForce& brute, glm::dvec2& a, glm::dvec2& b);

/// The same faces, reflections and lights.
bool same_sight(const Sight& a, const Sight& b);

}  // namespace povpreview
