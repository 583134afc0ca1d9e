// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "backend/oracle/object_faces.h"

namespace pov {
class Box;
class Disc;
class Plane;
class Polygon;
class Prism;
}  // namespace pov

/// The faces of objects with flat sides; each returns null, or why it cannot.
namespace povpreview::tracer {

const char* add_faces(const pov::Box& box, const FaceLimits&, ObjectFaces& faces);
const char* add_faces(const pov::Polygon& polygon, const FaceLimits&, ObjectFaces& faces);
/// Linear splines only.
const char* add_faces(const pov::Prism& prism, const FaceLimits& limits, ObjectFaces& faces);
/// A regular polygon or a ring of quadrilaterals, half inside and half outside of the circle.
const char* add_faces(const pov::Disc& disc, const FaceLimits&, ObjectFaces& faces);
const char* add_faces(const pov::Plane& plane, const FaceLimits& limits, ObjectFaces& faces);

std::vector<ConvexCell> cells_of(const pov::Prism& prism);
/// Half of space: POV-Ray takes a disc as the border of it.
std::vector<ConvexCell> cells_of(const pov::Disc& disc);
std::vector<ConvexCell> cells_of(const pov::Plane& plane);

}  // namespace povpreview::tracer
