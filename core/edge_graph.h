// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "core/image_edge.h"

namespace povpreview {

/// Points of the image, bucketed: which of them lie near a place, or near a segment.
class PointGrid {
   public:
    explicit PointGrid(glm::ivec2 size);

    /// The nearest point closer than `radius` (at most a pixel), or a new one there.
    std::uint32_t snap(glm::dvec2 p, double radius);
    /// The points closer than `radius` to the segment a-b and beside its inside, from a to b.
    void beside(std::uint32_t a, std::uint32_t b, double radius,
                std::vector<std::uint32_t>& found) const;

    const std::vector<glm::dvec2>& points() const { return points_; }

   private:
    glm::ivec2 cell_of(glm::dvec2 p) const;
    std::uint32_t& head(int i, int j) { return heads_[static_cast<std::size_t>(j) * columns_ + i]; }
    std::uint32_t head(int i, int j) const {
        return heads_[static_cast<std::size_t>(j) * columns_ + i];
    }

    double cell_;  ///< side of a bucket, pixels
    int columns_, rows_;
    std::vector<std::uint32_t> heads_, next_;  ///< a list of points for each bucket
    std::vector<glm::dvec2> points_;
};

/// Pieces of edges as a graph in the plane: its nodes are the pieces' ends, no two of them closer
/// than a snap distance; its links run from node to node and never past a node closer than that,
/// and no two of them join the same nodes. Links may cross each other.
///
///     a ------------- b            a ---- c ---- d ---- b     Pieces on one line, in part on top
///            c -------------- d                               of each other, share their links.
struct EdgeGraph {
    struct Link {
        std::uint32_t a, b;  ///< a < b
        EdgeKind kind;
        std::uint16_t light;
        float importance;
    };
    std::vector<glm::dvec2> nodes;
    std::vector<Link> links;  ///< by a, then by b
};

/// Of heavy pieces and light ones, the heavy ones keep their place and the light ones move. Where
/// two of different kinds coincide, the kind declared first wins.
/// REQUIRES: pieces finite, inside the image, heaviest first; snap at most a pixel.
EdgeGraph build_edge_graph(const std::vector<ImageEdge>& pieces, glm::ivec2 size, double snap);

}  // namespace povpreview
