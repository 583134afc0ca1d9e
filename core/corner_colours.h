// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "core/mesh.h"

namespace povpreview {

/// The colour of every corner of a mesh. A side of a vertex that knows none takes a mean of its
/// neighbours on this side of the constraints, near ones before far ones; where a region between
/// constraints knows none at all, its corners take what lies around it, as if the constraints were
/// not there.
class CornerColours {
   public:
    explicit CornerColours(const Mesh& mesh);

    /// Linear colour of the corner at `at` in the face to the left of at-to.
    glm::vec3 at(VertexId at, VertexId to) const;

   private:
    struct Unknown {
        VertexId vertex;
        std::uint32_t place;         ///< in colours_
        std::uint32_t first, count;  ///< in neighbours_
    };
    struct Neighbour {
        VertexId vertex;
        std::uint32_t place;
        float weight;  ///< one over its distance
    };
    void gather_known();
    void gather_neighbours();
    bool spread(bool across);
    bool mean(const Unknown& unknown, bool across, glm::vec3& colour) const;

    const Mesh& mesh_;
    std::vector<std::uint32_t> first_;  // by vertex: the place of its first side in colours_
    std::vector<glm::vec3> colours_;
    std::vector<bool> known_;
    std::vector<Unknown> unknown_;
    std::vector<Neighbour> neighbours_;
};

}  // namespace povpreview
