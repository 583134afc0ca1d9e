// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

// The order of POV-Ray's headers matters: frame.h first, povdebug.h last.
// clang-format off
#include "backend/frame.h"
// clang-format on

#include "backend/oracle/convex.h"
#include "backend/oracle/surface_index.h"

namespace povpreview::tracer {

/// The flat faces of one object, in world space; faces share their points.
struct ObjectFaces {
    struct Face {
        std::uint32_t first_ring = 0, rings = 1;
        bool convex = true;   ///< known to be one convex ring; else its inside is even-odd
        bool smooth = false;  ///< shaded with interpolated normals
        FaceNumber number;
        const pov::Mesh_Triangle_Struct* triangle = nullptr;  ///< has textures of its own
    };
    struct Ring {
        std::uint32_t first = 0, count = 0;  ///< in `corners`
    };
    std::vector<Point> points;
    std::vector<std::uint32_t> corners;     ///< indices into `points`
    std::vector<std::array<float, 2>> uvs;  ///< none, or one a corner
    std::vector<Ring> rings;
    std::vector<Face> faces;

    /// Begins a face of no rings yet.
    Face& add_face(FaceNumber number = {});
    /// Gives the last face another ring.
    void add_ring(const std::vector<std::uint32_t>& indices);
    /// Adds points and a convex face of them.
    Face& add_polygon(const ConvexPolygon& polygon, FaceNumber number = {});
    std::vector<ConvexPolygon> rings_of(const Face& face) const;
};

/// What the faces of an object depend on beside it.
struct FaceLimits {
    std::size_t max_faces = 0;
    /// Where an infinite plane is made a square, and half the side of that. POV-Ray sees nothing
    /// farther than MAX_DISTANCE, so a square of that size around the eye is the plane.
    Point middle;
    double reach = 0;
};

/// Fills `faces` with what the object alone looks like, without what clips it. Returns null, or why
/// it cannot: "curved", "too many faces" ...
const char* faces_of(const pov::ObjectBase& object, const FaceLimits& limits, ObjectFaces& faces);

/// The inside of an object as convex cells, POV-Ray's flag for its inverse apart. REQUIRES:
/// faces_of() gave the faces.
std::vector<ConvexCell> cells_of(const pov::ObjectBase& object, const ObjectFaces& faces);

/// Whether `cells_of` can tell; patches have no inside and so are told.
bool has_cells(const pov::ObjectBase& object);

}  // namespace povpreview::tracer
