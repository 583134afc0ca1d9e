// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "core/mesh.h"

namespace povpreview {

/// How near is near, in pixels, for a chain of constraints.
struct ChainTolerances {
    /// A point closer than this to a vertex or an edge that is a constraint already is taken to lie
    /// on it: a sliver between the two would only take samples.
    double snap;
    /// A point closer than this to the image's border is put on it.
    double border;
    /// A vertex off the constraints that is closer to one than this might lie on its wrong side.
    double clearance;
};

/// Traced outlines: two closer than a pixel's width have no pixel centre between them. Half a pixel
/// inside the border lie the outermost pixel centres. Clearance is twice the outline's error
/// between its vertices (position error and flatness).
inline constexpr ChainTolerances traced_chain{.75, .5, .7};
/// Chains of edges known exactly (edge_chains.h): snap is more than chain_flatness, by which the
/// chain may have moved away from the end of another that touches it.
inline constexpr ChainTolerances exact_chain{.3, .25, .15};

/// What goes for a constraint of a kind.
constexpr const ChainTolerances& tolerances(EdgeKind kind) {
    return kind == EdgeKind::traced ? traced_chain : exact_chain;
}

/// Puts chains of constraints into a mesh.
///
///           w                   The faces beside each new constraint u-v tell what is too near to
///        . ' ' .                it: a vertex w off the constraints loses its place in the mesh; if
///     u =========== v           w is on constraints, u-w-v becomes the constraint instead of u-v.
///
/// Work on the mesh's sides is put off until `finish()`.
class ChainInsertion {
   public:
    /// Vertices that lose their place in the mesh are given to `removed` first.
    ChainInsertion(Mesh& mesh, glm::ivec2 image_size, std::function<void(VertexId)> removed);

    /// Makes a polyline a chain of constraints; closed where its last vertex equals its first.
    /// REQUIRES: its vertices lie inside the image or on its border.
    void insert(std::span<const glm::dvec2> chain, ConstraintLabel label);

    /// The live vertices around which edges changed, in order and each once.
    std::vector<VertexId> finish();

   private:
    void note_touched();
    bool plain(VertexId v) const;
    VertexId near() const;
    VertexId place(glm::dvec2 p);
    VertexId fixed_vertex(const std::array<VertexId, 6>& around, glm::dvec2 p) const;
    std::pair<VertexId, VertexId> constraint_near(const std::array<VertexId, 6>& around,
                                                  glm::dvec2 p) const;
    std::array<VertexId, 6> around(glm::dvec2 p) const;
    void drop(VertexId v);
    void clear_around(glm::dvec2 p);
    void clear_fan(VertexId v, glm::dvec2 a, glm::dvec2 b);
    void connect(VertexId from, VertexId to, ConstraintLabel label);
    void clear_sides();
    bool clear_side(VertexId u, VertexId v, bool left);

    Mesh& mesh_;
    const Triangulation& t_;
    glm::ivec2 size_;
    std::function<void(VertexId)> removed_;
    ChainTolerances tolerances_ = exact_chain;
    VertexId previous_{};  // the chain's last vertex so far, which may not be on a constraint yet
    VertexId near_{0};
    std::vector<std::pair<VertexId, VertexId>> fresh_;  // constraints whose sides are to be cleared
    std::vector<VertexId> touched_;
    std::vector<bool> is_touched_;
    std::vector<Triangulation::Spoke> fan_;
};

/// Whether a constraint beside the face that holds the position leaves no room for a vertex there.
bool too_near_constraint(const Triangulation& triangulation, glm::dvec2 position, VertexId near);

}  // namespace povpreview
