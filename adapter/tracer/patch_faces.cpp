// SPDX-License-Identifier: AGPL-3.0-or-later
#include "backend/oracle/patch_faces.h"

#include <cstring>

// The order of POV-Ray's headers matters: frame.h first, povdebug.h last.
// clang-format off
#include "backend/frame.h"
#include "backend/scene/objects.h"
#include "backend/shape/bezier.h"
#include "backend/shape/hfield.h"
#include "backend/shape/mesh.h"
#include "backend/shape/triangle.h"
// clang-format on

#include "backend/oracle/transform.h"
#include "base/povdebug.h"

namespace povpreview::tracer {

namespace {

Point point(const pov::VECTOR v) { return {v[0], v[1], v[2]}; }
Point point(const pov::SNGL_VECT v) { return {v[0], v[1], v[2]}; }

/// Zeros where a mesh has none.
std::array<float, 2> own_coordinates(const pov::MESH_DATA& data, long corner) {
    if (corner < 0 || corner >= data.Number_Of_UVCoords) return {};
    return {static_cast<float>(data.UVCoords[corner][0]),
            static_cast<float>(data.UVCoords[corner][1])};
}

constexpr const char* too_many_faces = "too many faces";

}  // namespace

const char* add_faces(const pov::Triangle& triangle, const FaceLimits&, ObjectFaces& faces) {
    if (Test_Flag(&triangle, DEGENERATE_FLAG)) return nullptr;
    faces.add_polygon({point(triangle.P1), point(triangle.P2), point(triangle.P3)}).smooth =
        dynamic_cast<const pov::SmoothTriangle*>(&triangle) != nullptr;
    return nullptr;
}

const char* add_faces(const pov::Mesh& mesh, const FaceLimits& limits, ObjectFaces& faces) {
    const pov::MESH_DATA& data = *mesh.Data;
    const auto count = static_cast<std::size_t>(data.Number_Of_Triangles);
    if (count > limits.max_faces) return too_many_faces;
    faces.points.reserve(static_cast<std::size_t>(data.Number_Of_Vertices));
    faces.corners.reserve(3 * count);
    faces.rings.reserve(count);
    faces.faces.reserve(count);
    const bool with_uvs = Test_Flag(&mesh, UV_FLAG) && data.UVCoords != nullptr;
    for (long i = 0; i < data.Number_Of_Vertices; ++i)
        faces.points.push_back(to_world(mesh.Trans, point(data.Vertices[i])));
    for (std::size_t i = 0; i < count; ++i) {
        const pov::MESH_TRIANGLE& triangle = data.Triangles[i];
        ObjectFaces::Face face;
        face.first_ring = static_cast<std::uint32_t>(faces.rings.size());
        face.smooth = triangle.Smooth;
        face.number = face_number(triangle);
        if (triangle.ThreeTex || triangle.Texture >= 0) face.triangle = &triangle;
        faces.faces.push_back(face);
        faces.rings.push_back({static_cast<std::uint32_t>(faces.corners.size()), 3});
        for (const long corner : {triangle.P1, triangle.P2, triangle.P3})
            faces.corners.push_back(static_cast<std::uint32_t>(corner));
        if (!with_uvs) continue;
        for (const long corner : {triangle.UV1, triangle.UV2, triangle.UV3})
            faces.uvs.push_back(own_coordinates(data, corner));
    }
    return nullptr;
}

namespace {

/// The two triangles of each cell of a height field, as POV-Ray cuts it:
///
///     z + 1  c --- d
///            | \ 2 |
///            | 1 \ |
///     z      a --- b
///            x    x + 1
class HeightFieldFaces {
   public:
    HeightFieldFaces(const pov::HField& field, ObjectFaces& faces)
        : field_(field),
          faces_(faces),
          width_(field.Data->max_x + 2),
          depth_(field.Data->max_z + 2),
          water_(field.bounding_corner1[1]) {}

    void add() {
        for (int z = 0; z < depth_; ++z)
            for (int x = 0; x < width_; ++x)
                faces_.points.push_back(to_world(field_.Trans, local(x, z)));
        for (int z = 0; z + 1 < depth_; ++z)
            for (int x = 0; x + 1 < width_; ++x) {
                add_triangle({index(x, z), index(x + 1, z), index(x, z + 1)});
                add_triangle({index(x + 1, z + 1), index(x, z + 1), index(x + 1, z)});
            }
    }

   private:
    Point local(int x, int z) const {
        return {static_cast<double>(x), static_cast<double>(field_.Data->Map[z][x]),
                static_cast<double>(z)};
    }
    Point local(std::uint32_t i) const {
        return local(static_cast<int>(i) % width_, static_cast<int>(i) / width_);
    }
    std::uint32_t index(int x, int z) const { return static_cast<std::uint32_t>(z * width_ + x); }

    void add_triangle(const std::vector<std::uint32_t>& corners) {
        int above = 0;
        for (const std::uint32_t corner : corners) above += local(corner).y >= water_;
        if (above == 3) {
            faces_.add_face();
            faces_.add_ring(corners);
        } else if (above > 0) {
            ConvexPolygon dry =
                cut({local(corners[0]), local(corners[1]), local(corners[2])}, {{0, 1, 0}, water_})
                    .in_front;
            for (Point& p : dry) p = to_world(field_.Trans, p);
            if (dry.size() >= 3) faces_.add_polygon(dry);
        }
        if (above > 0) faces_.faces.back().smooth = Test_Flag(&field_, SMOOTHED_FLAG) != 0;
    }

    const pov::HField& field_;
    ObjectFaces& faces_;
    const int width_, depth_;
    const double water_;
};

}  // namespace

const char* add_faces(const pov::HField& field, const FaceLimits& limits, ObjectFaces& faces) {
    const double cells = (field.Data->max_x + 1.0) * (field.Data->max_z + 1.0);
    if (2 * cells > static_cast<double>(limits.max_faces)) return too_many_faces;
    HeightFieldFaces(field, faces).add();
    return nullptr;
}

namespace {

/// POV-Ray's own subdivision of a bicubic patch, with its own tests and arithmetic.
class Subdivision : public pov::BicubicPatch {
   public:
    using Control = pov::VECTOR[4][4];

    Subdivision(const pov::BicubicPatch& patch, std::size_t max_faces, ObjectFaces& faces)
        : patch_(patch), max_faces_(max_faces), faces_(faces) {}

    bool add() {
        descend(&patch_.Control_Points, 0);
        return faces_.faces.size() <= max_faces_;
    }

   private:
    void descend(const Control* control, int depth) {
        if (faces_.faces.size() > max_faces_) return;
        const double flatness = determine_subpatch_flatness(control);
        const bool flat = flatness >= 0 && flatness < patch_.Flatness_Value,
                   split_u = depth < patch_.U_Steps, split_v = depth < patch_.V_Steps;
        Control parts[4];
        if (flat || (!split_u && !split_v)) {
            add_leaf(*control);
        } else if (split_u && split_v) {
            bezier_split_left_right(control, &parts[0], &parts[2]);
            bezier_split_up_down(&parts[0], &parts[0], &parts[1]);
            bezier_split_up_down(&parts[2], &parts[2], &parts[3]);
            for (const Control& part : parts) descend(&part, depth + 1);
        } else {
            if (split_u)
                bezier_split_left_right(control, &parts[0], &parts[1]);
            else
                bezier_split_up_down(control, &parts[0], &parts[1]);
            descend(&parts[0], depth + 1);
            descend(&parts[1], depth + 1);
        }
    }

    void add_leaf(const Control& c) {
        const Point a = point(c[0][0]), b = point(c[0][3]), d = point(c[3][3]), e = point(c[3][0]);
        faces_.add_polygon({a, b, d}).smooth = true;
        faces_.add_polygon({a, d, e}).smooth = true;
    }

    const pov::BicubicPatch& patch_;
    const std::size_t max_faces_;
    ObjectFaces& faces_;
};

}  // namespace

const char* add_faces(const pov::BicubicPatch& patch, const FaceLimits& limits,
                      ObjectFaces& faces) {
    return Subdivision(patch, limits.max_faces, faces).add() ? nullptr : too_many_faces;
}

}  // namespace povpreview::tracer
