// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "backend/oracle/object_faces.h"

namespace pov {
class BicubicPatch;
class HField;
class Mesh;
class SmoothTriangle;
class Triangle;
}  // namespace pov

/// The faces of objects made of triangles; each returns null, or why it cannot.
namespace povpreview::tracer {

const char* add_faces(const pov::Triangle& triangle, const FaceLimits&, ObjectFaces& faces);
const char* add_faces(const pov::Mesh& mesh, const FaceLimits& limits, ObjectFaces& faces);
/// What is above the water, cut at its level.
const char* add_faces(const pov::HField& field, const FaceLimits& limits, ObjectFaces& faces);
/// The triangles that POV-Ray tests rays against; it subdivides the patch in the same way.
const char* add_faces(const pov::BicubicPatch& patch, const FaceLimits& limits, ObjectFaces& faces);

}  // namespace povpreview::tracer
