// SPDX-License-Identifier: AGPL-3.0-or-later
#include "backend/oracle/object_faces.h"

// The order of POV-Ray's headers matters: frame.h first, povdebug.h last.
// clang-format off
#include "backend/frame.h"
#include "backend/scene/objects.h"
#include "backend/shape/bezier.h"
#include "backend/shape/boxes.h"
#include "backend/shape/discs.h"
#include "backend/shape/hfield.h"
#include "backend/shape/mesh.h"
#include "backend/shape/planes.h"
#include "backend/shape/polygon.h"
#include "backend/shape/prism.h"
#include "backend/shape/triangle.h"
// clang-format on

#include "backend/oracle/flat_faces.h"
#include "backend/oracle/patch_faces.h"
#include "base/povdebug.h"

namespace povpreview::tracer {

ObjectFaces::Face& ObjectFaces::add_face(FaceNumber number) {
    Face face;
    face.first_ring = static_cast<std::uint32_t>(rings.size());
    face.rings = 0;
    face.number = number;
    faces.push_back(face);
    return faces.back();
}

void ObjectFaces::add_ring(const std::vector<std::uint32_t>& indices) {
    rings.push_back(
        {static_cast<std::uint32_t>(corners.size()), static_cast<std::uint32_t>(indices.size())});
    corners.insert(corners.end(), indices.begin(), indices.end());
    ++faces.back().rings;
}

ObjectFaces::Face& ObjectFaces::add_polygon(const ConvexPolygon& polygon, FaceNumber number) {
    std::vector<std::uint32_t> indices;
    for (const Point& corner : polygon) {
        indices.push_back(static_cast<std::uint32_t>(points.size()));
        points.push_back(corner);
    }
    add_face(number);
    add_ring(indices);
    return faces.back();
}

std::vector<ConvexPolygon> ObjectFaces::rings_of(const Face& face) const {
    std::vector<ConvexPolygon> result;
    for (std::uint32_t r = face.first_ring; r < face.first_ring + face.rings; ++r) {
        result.emplace_back();
        for (std::uint32_t i = rings[r].first; i < rings[r].first + rings[r].count; ++i)
            result.back().push_back(points[corners[i]]);
    }
    return result;
}

namespace {

template <typename Class>
const Class* as(const pov::ObjectBase& object) {
    return dynamic_cast<const Class*>(&object);
}

template <typename... Classes>
bool is_any_of(const pov::ObjectBase& object) {
    return ((as<Classes>(object) != nullptr) || ...);
}

/// Calls add_faces for the first of the classes that the object is.
template <typename Class, typename... Others>
const char* add_as(const pov::ObjectBase& object, const FaceLimits& limits, ObjectFaces& faces) {
    if (const auto* known = as<Class>(object)) return add_faces(*known, limits, faces);
    if constexpr (sizeof...(Others) > 0)
        return add_as<Others...>(object, limits, faces);
    else
        return "curved";
}

}  // namespace

const char* faces_of(const pov::ObjectBase& object, const FaceLimits& limits, ObjectFaces& faces) {
    return add_as<pov::Triangle, pov::Mesh, pov::Box, pov::Plane, pov::Prism, pov::Polygon,
                  pov::Disc, pov::HField, pov::BicubicPatch>(object, limits, faces);
}

bool has_cells(const pov::ObjectBase& object) {
    if (const auto* mesh = as<pov::Mesh>(object)) return !mesh->has_inside_vector;
    return is_any_of<pov::Triangle, pov::Box, pov::Plane, pov::Prism, pov::Polygon, pov::Disc,
                     pov::BicubicPatch>(object);
}

std::vector<ConvexCell> cells_of(const pov::ObjectBase& object, const ObjectFaces& faces) {
    std::vector<ConvexCell> cells;
    if (const auto* prism = as<pov::Prism>(object)) cells = cells_of(*prism);
    if (const auto* disc = as<pov::Disc>(object)) cells = cells_of(*disc);
    if (const auto* plane = as<pov::Plane>(object)) cells = cells_of(*plane);
    if (as<pov::Box>(object) != nullptr) {
        std::vector<ConvexPolygon> sides;
        for (const ObjectFaces::Face& face : faces.faces)
            sides.push_back(faces.rings_of(face).front());
        cells.push_back(cell_within(sides));
    }
    cells.erase(std::remove_if(cells.begin(), cells.end(),
                               [](const ConvexCell& cell) { return cell.planes.empty(); }),
                cells.end());
    return cells;
}

}  // namespace povpreview::tracer
