// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "backend/oracle/convex.h"

/// Constructive solid geometry of polyhedra, resolved to faces as POV-Ray shows them.
namespace povpreview::tracer {

/// A convex piece of the surface of a leaf; `face` is the leaf's own number for what it belongs to.
struct SolidFace {
    ConvexPolygon corners;
    std::uint32_t face = 0;
};

/// What is inside is the union of convex cells, or all but that. A leaf without cells has no inside
/// (POV-Ray's patches: triangles, polygons ...), even if inverted.
struct Leaf {
    std::vector<ConvexCell> cells;
    bool inverted = false;
    std::vector<SolidFace> faces;
};

/// An object made of others. POV-Ray keeps a difference as an intersection with inverted objects.
///
/// A point is inside what the kind says; and only if it is inside all of `clips`, which also take
/// away from the surface. The surface is not the boundary of the inside: an intersection shows
/// those parts of its parts' surfaces that lie inside all the others; a union shows all of them,
/// also inside one another; a merge those that lie outside the others (csg.cpp).
struct Solid {
    enum class Kind { leaf, unite, merge, intersect };
    Kind kind = Kind::leaf;
    std::vector<Solid> parts;  ///< of any other kind
    std::vector<Solid> clips;
    Leaf leaf;
    std::uint32_t number = 0;  ///< of a leaf, for its user
};

/// A face of a leaf or a piece of one, as it remains.
struct SolidPiece {
    std::uint32_t leaf = 0;  ///< Solid::number
    std::uint32_t face = 0;  ///< SolidFace::face
    bool whole = false;      ///< nothing was taken away from any SolidFace of that number
    ConvexPolygon corners;
};

/// The surface of `root`, each face cut where the inside of another object begins. Where faces of
/// two leaves coincide, what is shown is the surface of the regularised solid, once: there POV-Ray
/// itself shows one or the other, or neither, by rounding.
///
/// Returns false, and what it has so far, as soon as there are more than `max_pieces`.
bool resolve(const Solid& root, std::size_t max_pieces, std::vector<SolidPiece>& pieces);

/// Whether a point, on no surface, is inside.
bool is_inside(const Solid& solid, const Point& point);

}  // namespace povpreview::tracer
