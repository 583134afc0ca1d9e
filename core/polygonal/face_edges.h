// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "core/polygonal/flat_faces.h"
#include "core/polygonal/shadow_volumes.h"

namespace povpreview {

/// The edges of all faces, each once, with the faces that meet in it.
class FaceEdges {
   public:
    explicit FaceEdges(const FlatFaces& faces);

    struct Edge {
        std::uint32_t a, b;          ///< points, a < b
        std::uint32_t first, count;  ///< its faces
        /// How much of a step in colour to expect where surface goes on from one side of it to the
        /// other, 0 to 1; 0 inside a smooth surface and between coplanar faces of one material.
        float crease;

        /// Two faces meet in it as in the edge of a solid.
        bool regular() const { return count == 2; }
    };
    std::span<const Edge> edges() const { return edges_; }

    std::span<const std::uint32_t> faces(const Edge& edge) const {
        return std::span(users_).subspan(edge.first, edge.count);
    }
    SpaceSegment segment(const Edge& edge) const {
        return {faces_.point(edge.a), faces_.point(edge.b), edge.a, edge.b};
    }

    /// Whether all faces for which `counts` lie to one side of the edge as the viewpoint sees it,
    /// so that what is seen on its other side lies farther off. Exact.
    template <class Counts>
    bool silhouette(const Edge& edge, const ShadowVolumes& volumes, const Counts& counts) const;

    /// Whether any of the edge's faces counts.
    template <class Counts>
    bool any(const Edge& edge, const Counts& counts) const {
        const auto users = faces(edge);
        return std::any_of(users.begin(), users.end(),
                           [&](std::uint32_t face) { return counts(faces_.face(face)); });
    }

   private:
    float crease(const Edge& edge) const;
    float crease_between(std::uint32_t use, std::uint32_t other) const;

    const FlatFaces& faces_;
    std::vector<Edge> edges_;
    std::vector<std::uint32_t> users_;    // faces, those of an edge side by side
    std::vector<std::uint8_t> forwards_;  // beside them: the face's corners run from a to b
};

/// A face whose corners are seen counter-clockwise lies to the left of its edges, and one seen from
/// behind to their right.
template <class Counts>
bool FaceEdges::silhouette(const Edge& edge, const ShadowVolumes& volumes,
                           const Counts& counts) const {
    bool left = false, right = false;
    for (std::uint32_t use = edge.first; use < edge.first + edge.count; ++use) {
        const int facing = volumes.facing(users_[use]);
        if (facing == 0 || !counts(faces_.face(users_[use]))) continue;
        ((facing > 0) == (forwards_[use] != 0) ? left : right) = true;
    }
    return left != right;
}

}  // namespace povpreview
