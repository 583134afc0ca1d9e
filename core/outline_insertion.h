// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "core/mesh.h"
#include "core/outline_tracer.h"

namespace povpreview {

/// A point of an outline closer than this, in pixels, to a vertex or an edge that is a constraint
/// already is taken to lie on it: two outlines closer than a pixel's width have no pixel centre
/// between them, and the sliver would only take samples.
inline constexpr double outline_snap = .75;
/// A point of an outline closer than this to the image's border, in pixels, is put on it: half a
/// pixel inside lie the outermost pixel centres.
inline constexpr double border_snap = .5;
/// A vertex off the constraints that is closer to one than this, in pixels, might lie on its wrong
/// side: twice the error of a traced outline between its vertices (position error and flatness).
inline constexpr double constraint_clearance = .7;

/// Makes a traced outline a chain of constraints. Vertices that come too near lose their place in
/// the mesh; each is given to `removed` first. Returns the vertices around which edges changed, in
/// order and each once.
std::vector<VertexId> insert_outline(Mesh& mesh, glm::ivec2 image_size, const Outline& outline,
                                     const std::function<void(VertexId)>& removed);

/// Whether a constraint beside the face that holds the position leaves no room for a vertex there.
bool too_near_constraint(const Triangulation& triangulation, glm::dvec2 position, VertexId near);

}  // namespace povpreview
