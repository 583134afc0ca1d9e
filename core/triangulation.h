// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <glm/vec2.hpp>
#include <memory>
#include <span>
#include <vector>

#include "core/constraint_labels.h"
#include "core/ids.h"

namespace povpreview {

/// A constrained Delaunay triangulation of a rectangle: no vertex lies inside the circle around a
/// face that it can see past the constrained edges. Geometry alone; it knows no colours.
///
/// Predicates are exact. Constructed points (crossings of constraints, the middle of an edge) are
/// rounded and hence not quite on their lines, so constraints are always tied to them anew.
class Triangulation {
   public:
    /// The rectangle in two triangles, cut by a diagonal. Its corners are the vertices 0 to 3:
    /// (low, low), (high, low), (high, high), (low, high).
    /// REQUIRES: low < high in both coordinates.
    Triangulation(glm::dvec2 low, glm::dvec2 high);
    ~Triangulation();
    Triangulation(Triangulation&&) noexcept;
    Triangulation& operator=(Triangulation&&) noexcept;

    struct Insertion {
        VertexId vertex;  ///< the new vertex, or the one that lies at the very position
        bool fresh;
    };

    // Each of the operations below sets `touched()`.

    /// Inserts a vertex; takes a time that grows with the distance from `near`, a live vertex.
    /// On a constrained edge it splits that edge.
    /// REQUIRES: position inside the rectangle or on its border.
    Insertion insert(glm::dvec2 position, VertexId near);

    /// Makes the segment from a to b a constraint: a chain of constrained edges, through vertices
    /// that lie on it and through new ones where it crosses other constraints, which are split.
    /// Sets `path()`.
    void constrain(VertexId a, VertexId b, ConstraintLabel label = {});

    /// Replaces the constrained edge a-b by a-p and p-b, wherever p lies by rounding. They keep its
    /// label.
    ///
    ///        c                 c
    ///       / \               /|\           p is hardly ever exactly on a-b: so a-b is freed,
    ///      /   \     -->     / | \          p inserted as any vertex, and a-p, p-b constrained.
    ///     a=====b           a==p==b
    ///
    /// Returns an old vertex where one lies at p already.
    /// REQUIRES: a-b is a constrained edge.
    Insertion split(VertexId a, VertexId b, glm::dvec2 p);

    /// Removes a vertex, which is neither on a constraint nor on the border.
    void remove(VertexId vertex);

    /// The live vertices around which the last operation changed something: every edge that is new,
    /// or newly constrained, or split has an end among them.
    std::span<const VertexId> touched() const;
    /// The vertices of the chain that the last `constrain(a, b)` made, from a to b.
    std::span<const VertexId> path() const;

    glm::dvec2 position(VertexId vertex) const;
    bool alive(VertexId vertex) const;
    bool on_constraint(VertexId vertex) const;
    bool on_border(VertexId vertex) const;
    /// Vertices ever inserted: ids are below this number.
    std::size_t vertex_ids() const;
    std::size_t vertices() const;
    std::size_t faces() const;
    std::size_t constraints() const;  ///< constrained edges
    const ConstraintLabels& labels() const;

    /// One edge out of a vertex, to its neighbour.
    struct Spoke {
        VertexId to;
        bool constrained;
        bool face;  ///< a face follows it counter-clockwise; false only on the border
    };
    /// The edges out of a vertex, counter-clockwise. At a vertex on the border they begin after the
    /// outside, so only the last one has no face.
    void fan(VertexId vertex, std::vector<Spoke>& spokes) const;

    /// What lies beside an edge.
    struct Edge {
        bool constrained;
        VertexId left, right;  ///< the third vertices of its faces; invalid outside the rectangle
    };
    bool find_edge(VertexId a, VertexId b, Edge& edge) const;

    /// The face that contains a position (one of them where it lies on an edge).
    std::array<VertexId, 3> locate(glm::dvec2 position, VertexId near) const;

    /// Calls f(a, b, c) for every face, counter-clockwise.
    void for_each_face(const std::function<void(VertexId, VertexId, VertexId)>& f) const;
    /// Calls f(a, b, constrained) once for every edge.
    void for_each_edge(const std::function<void(VertexId, VertexId, bool)>& f) const;

    /// CGAL's own check of links and of the constrained Delaunay property.
    bool sound() const;

   private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace povpreview
