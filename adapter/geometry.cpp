// SPDX-License-Identifier: AGPL-3.0-or-later
#include "adapter/geometry.h"

#include "adapter/convex_pieces.h"
#include "adapter/straight_camera.h"

namespace povpreview {
namespace {

std::uint32_t size32(std::size_t size) { return static_cast<std::uint32_t>(size); }

void add_face(PolygonScene& scene, const Face& like, std::span<const std::uint32_t> corners) {
    Face face = like;
    face.first = size32(scene.corners.size());
    face.count = size32(corners.size());
    scene.corners.insert(scene.corners.end(), corners.begin(), corners.end());
    scene.faces.push_back(face);
}

/// POV-Ray's parallel lights shine in the direction from their position to `points_at`; area lights
/// are taken by their centre.
std::vector<PointLight> point_lights(const SceneDescription& scene) {
    std::vector<PointLight> lights;
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const LightDescription& light = scene.lights[i];
        if (light.shadowless || light.in_group) continue;
        lights.push_back({.position = light.parallel
                                          ? glm::dvec4(light.position - light.points_at, 0)
                                          : glm::dvec4(light.position, 1),
                          .brightness = (light.colour.r + light.colour.g + light.colour.b) / 3,
                          .number = size32(i)});
    }
    return lights;
}

}  // namespace

void Geometry::append(const Geometry& other) {
    const std::uint32_t first_point = size32(points.size()), first_corner = size32(corners.size()),
                        first_ring = size32(rings.size());
    points.insert(points.end(), other.points.begin(), other.points.end());
    for (const std::uint32_t corner : other.corners) corners.push_back(first_point + corner);
    for (const Ring& ring : other.rings) rings.push_back({first_corner + ring.first, ring.count});
    for (Polygon polygon : other.polygons) {
        polygon.first_ring += first_ring;
        polygons.push_back(polygon);
    }
    left_out.insert(left_out.end(), other.left_out.begin(), other.left_out.end());
}

std::optional<PolygonScene> polygon_scene(const Geometry& geometry, const SceneDescription& scene) {
    if (!why_not_straight(scene.camera).empty()) return std::nullopt;
    PolygonScene result;
    result.width = scene.width;
    result.height = scene.height;
    result.camera = straight_camera(scene.camera, scene.width, scene.height);
    result.lights = point_lights(scene);
    result.points = geometry.points;
    result.faces.reserve(geometry.polygons.size());
    result.corners.reserve(geometry.corners.size());
    const auto corners_of = [&geometry](const Geometry::Ring& ring) {
        return std::span(geometry.corners).subspan(ring.first, ring.count);
    };
    for (const Geometry::Polygon& polygon : geometry.polygons) {
        const auto rings = std::span(geometry.rings).subspan(polygon.first_ring, polygon.rings);
        if (rings.size() == 1 && (polygon.convex || rings[0].count <= 3)) {
            add_face(result, polygon.face, corners_of(rings[0]));
            continue;
        }
        std::vector<IndexRing> loops;
        for (const Geometry::Ring& ring : rings)
            if (const auto corners = corners_of(ring); corners.size() >= 3)
                loops.emplace_back(corners.begin(), corners.end());
        for (const IndexRing& piece : convex_pieces(loops, result.points))
            add_face(result, polygon.face, piece);
    }
    return result;
}

}  // namespace povpreview
