// SPDX-License-Identifier: AGPL-3.0-or-later
#include "adapter/geometry.h"

#include "adapter/convex_pieces.h"
#include "adapter/straight_camera.h"

namespace povpreview {
namespace {

std::uint32_t size32(std::size_t size) { return static_cast<std::uint32_t>(size); }

/// The polygons of a scene as convex faces.
class FaceCutter {
   public:
    explicit FaceCutter(const Geometry& geometry) : geometry_(geometry) {
        scene.points = geometry.points;
        scene.faces.reserve(geometry.polygons.size());
        scene.corners.reserve(geometry.corners.size());
        if (!geometry.corner_uvs.empty()) corner_uvs.reserve(geometry.corners.size());
    }

    void cut();

    PolygonScene scene;                 ///< but for camera and lights
    std::vector<glm::vec2> corner_uvs;  ///< beside its corners; or none

   private:
    std::span<const std::uint32_t> corners_of(const Geometry::Ring& ring) const {
        return std::span(geometry_.corners).subspan(ring.first, ring.count);
    }
    void add_face(const Face& like, std::span<const std::uint32_t> corners);

    const Geometry& geometry_;
};

void FaceCutter::add_face(const Face& like, std::span<const std::uint32_t> corners) {
    Face face = like;
    face.first = size32(scene.corners.size());
    face.count = size32(corners.size());
    scene.corners.insert(scene.corners.end(), corners.begin(), corners.end());
    scene.faces.push_back(face);
}

void FaceCutter::cut() {
    for (const Geometry::Polygon& polygon : geometry_.polygons) {
        const auto rings = std::span(geometry_.rings).subspan(polygon.first_ring, polygon.rings);
        if (rings.size() == 1 && (polygon.convex || rings[0].count <= 3)) {
            add_face(polygon.face, corners_of(rings[0]));
            if (!geometry_.corner_uvs.empty()) {
                const auto first = geometry_.corner_uvs.begin() + rings[0].first;
                corner_uvs.insert(corner_uvs.end(), first, first + rings[0].count);
            }
            continue;
        }
        std::vector<IndexRing> loops;
        for (const Geometry::Ring& ring : rings)
            if (const auto corners = corners_of(ring); corners.size() >= 3)
                loops.emplace_back(corners.begin(), corners.end());
        for (const IndexRing& piece : convex_pieces(loops, scene.points))
            add_face(polygon.face, piece);
        // Only triangles of meshes have coordinates of their own, and they are not cut.
        if (!geometry_.corner_uvs.empty()) corner_uvs.resize(scene.corners.size());
    }
}

/// POV-Ray's parallel lights shine in the direction from their position to `points_at`. Area lights
/// are left out: their shadows fade, and an edge in the middle of that would be a step that is
/// none.
std::vector<PointLight> point_lights(const SceneDescription& scene) {
    std::vector<PointLight> lights;
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const LightDescription& light = scene.lights[i];
        if (light.shadowless || light.in_group || light.kind == LightKind::area) continue;
        lights.push_back({.position = light.parallel
                                          ? glm::dvec4(light.position - light.points_at, 0)
                                          : glm::dvec4(light.position, 1),
                          .brightness = (light.colour.r + light.colour.g + light.colour.b) / 3,
                          .number = size32(i)});
    }
    return lights;
}

/// A scene of the polygons alone.
std::optional<DrawableScene> drawable_polygons(const Geometry& geometry,
                                               const SceneDescription& scene) {
    if (!why_not_straight(scene.camera).empty()) return std::nullopt;
    FaceCutter cutter(geometry);
    cutter.cut();
    DrawableScene result;
    result.polygons = std::move(cutter.scene);
    result.corner_uvs = std::move(cutter.corner_uvs);
    result.polygons.width = scene.width;
    result.polygons.height = scene.height;
    result.polygons.camera = straight_camera(scene.camera, scene.width, scene.height);
    result.polygons.lights = point_lights(scene);
    return result;
}

/// Materials are numbered from 1 on, and each has its look: others make no sense.
std::vector<Look> looks_by_material(const Geometry& geometry) {
    std::vector<Look> looks(geometry.looks.size() + 1);
    for (const Geometry::MaterialLook& look : geometry.looks) {
        if (look.material >= looks.size()) continue;
        Look& to = looks[look.material] = look.look;
        if (to.kind == Look::Kind::image && to.image.image >= geometry.images.size())
            to.kind = Look::Kind::traced;
    }
    return looks;
}

}  // namespace

std::optional<PolygonScene> polygon_scene(const Geometry& geometry, const SceneDescription& scene) {
    std::optional<DrawableScene> drawable = drawable_polygons(geometry, scene);
    if (!drawable) return std::nullopt;
    return std::move(drawable->polygons);
}

std::optional<DrawableScene> drawable_scene(const Geometry& geometry,
                                            const SceneDescription& scene) {
    std::optional<DrawableScene> result = drawable_polygons(geometry, scene);
    if (!result) return std::nullopt;
    result->solids = geometry.solids;
    result->numbers = geometry.numbers;
    result->conditions = geometry.conditions;
    result->pieces = geometry.pieces;
    result->objects = geometry.objects;
    result->unknown = geometry.unknown;
    result->unknown_in_mirrors = geometry.unknown_in_mirrors;
    result->images = geometry.images;
    result->working_gamma = scene.working_gamma;
    result->looks = looks_by_material(geometry);
    return result;
}

}  // namespace povpreview
