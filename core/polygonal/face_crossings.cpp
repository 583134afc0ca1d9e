// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/polygonal/face_crossings.h"

#include <glm/geometric.hpp>

namespace povpreview {
namespace {

/// The points where the border of a face passes through a plane, given by heights over it; false
/// unless the face clearly reaches to both sides.
template <class Height>
bool cut(const FlatFaces& faces, std::uint32_t face, const Height& height_of,
         SpaceSegment& segment) {
    const auto corners = faces.corners(face);
    double low = 0, high = 0;
    int found = 0;
    glm::dvec3 from = faces.point(corners.back());
    double before = height_of(from);
    for (const std::uint32_t corner : corners) {
        const glm::dvec3& to = faces.point(corner);
        const double height = height_of(to);
        low = std::min(low, height);
        high = std::max(high, height);
        if ((before < 0) != (height < 0) && found < 2)
            (found++ == 0 ? segment.a : segment.b) =
                from + (to - from) * (before / (before - height));
        before = height;
        from = to;
    }
    // There, and not at a corner that may be far off.
    const double tolerance = contact * faces.scale(segment.at(.5));
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

bool seen(const Face& face) { return face.visible || face.reflected || face.casts_shadow; }

}  // namespace

std::vector<Crossing> find_crossings(const FlatFaces& faces, const FaceHierarchy& hierarchy,
                                     const std::function<bool(std::size_t found)>& go_on) {
    std::vector<Crossing> crossings;
    const auto over = [&](std::uint32_t face) {
        return [&faces, face](const glm::dvec3& p) { return faces.height(face, p); };
    };
    hierarchy.for_each_pair([&](std::uint32_t f, std::uint32_t g) {
        if (!go_on(crossings.size())) return false;
        if (!seen(faces.face(f)) || !seen(faces.face(g))) return true;
        SpaceSegment line{}, other{};
        if (!cut(faces, f, over(g), other) || !cut(faces, g, over(f), line)) return true;
        Interval part;
        if (!clip_to_face(faces, f, line, part)) return true;
        crossings.push_back({{line.at(part.from), line.at(part.to)}, f, g});
        return true;
    });
    return crossings;
}

std::vector<SpaceSegment> find_cuts(const FlatFaces& faces, const NearPlane& plane) {
    std::vector<SpaceSegment> cuts;
    const auto height = [&](const glm::dvec3& p) { return plane.height(p); };
    for (std::uint32_t face = 0; face < faces.size(); ++face) {
        SpaceSegment line{};
        if (faces.face(face).visible && cut(faces, face, height, line)) cuts.push_back(line);
    }
    return cuts;
}

}  // namespace povpreview
