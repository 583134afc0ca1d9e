// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/polygonal/face_crossings.h"

#include <glm/geometric.hpp>

#include "core/polygonal/sides.h"

namespace povpreview {
namespace {

/// The points where the border of face g passes through the plane of face f; false unless it
/// clearly does.
bool cut(const FlatFaces& faces, std::uint32_t f, std::uint32_t g, double tolerance,
         SpaceSegment& segment) {
    const auto corners = faces.corners(g);
    double low = 0, high = 0;
    int found = 0;
    double before = faces.height(f, faces.point(corners.back()));
    glm::dvec3 from = faces.point(corners.back());
    for (const std::uint32_t corner : corners) {
        const glm::dvec3& to = faces.point(corner);
        const double height = faces.height(f, to);
        low = std::min(low, height);
        high = std::max(high, height);
        if ((before < 0) != (height < 0) && found < 2)
            (found++ == 0 ? segment.a : segment.b) =
                from + (to - from) * (before / (before - height));
        before = height;
        from = to;
    }
    return found == 2 && low < -tolerance && high > tolerance;
}

/// Cuts a segment in the plane of a face down to what lies inside it.
bool clip_to_face(const FlatFaces& faces, std::uint32_t f, const SpaceSegment& segment,
                  Interval& part) {
    const auto corners = faces.corners(f);
    const glm::dvec3& normal = faces[f].normal;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const glm::dvec3& a = faces.point(corners[i]);
        const glm::dvec3& b = faces.point(corners[(i + 1) % corners.size()]);
        const glm::dvec3 inward = glm::cross(normal, b - a);
        if (!clip(part, glm::dot(inward, segment.a - a), glm::dot(inward, segment.b - a)))
            return false;
    }
    return true;
}

bool seen(const Face& face) { return face.visible || face.reflected; }

}  // namespace

std::vector<Crossing> find_crossings(const FlatFaces& faces, const FaceHierarchy& hierarchy,
                                     const glm::dvec4& eye, std::size_t most) {
    std::vector<Crossing> crossings;
    hierarchy.for_each_pair([&](std::uint32_t f, std::uint32_t g) {
        if (crossings.size() >= most || !seen(faces.face(f)) || !seen(faces.face(g))) return;
        const double tolerance = contact * sight_distance(eye, faces[f].on, faces.extent());
        SpaceSegment line, other;
        if (!cut(faces, g, f, tolerance, other) || !cut(faces, f, g, tolerance, line)) return;
        Interval part;
        if (!clip_to_face(faces, f, line, part)) return;
        crossings.push_back({{line.at(part.from), line.at(part.to)}, f, g});
    });
    return crossings;
}

}  // namespace povpreview
