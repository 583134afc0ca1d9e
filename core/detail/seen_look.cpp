// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/detail/seen_look.h"

#include <glm/geometric.hpp>

#include "core/detail/image_look.h"
#include "core/detail/item_sources.h"
#include "core/detail/pattern_look.h"

namespace povpreview {

namespace {

using Source = ItemCanvas::Source;

bool has_uv(const DrawableScene& scene, Source source) {
    if (source & ItemCanvas::piece_bit) return false;
    const Face& face = scene.polygons.faces[source];
    return std::size_t{face.first} + face.count <= scene.corner_uvs.size();
}

/// Of a point on a face over which UV coordinates are linear. REQUIRES: has_uv().
glm::dvec2 uv(const DrawableScene& scene, const glm::dvec3& point, Source source) {
    const PolygonScene& polygons = scene.polygons;
    const Face& face = polygons.faces[source];
    const glm::dvec3 a = polygons.corner(face, 0), ab = polygons.corner(face, 1) - a,
                     ac = polygons.corner(face, 2) - a, ap = point - a;
    const glm::dvec3 normal = glm::cross(ab, ac);
    const double area = glm::dot(normal, normal);
    const double v = glm::dot(glm::cross(ap, ac), normal) / area,
                 w = glm::dot(glm::cross(ab, ap), normal) / area;
    const auto at = [&](std::size_t corner) {
        return glm::dvec2(scene.corner_uvs[face.first + corner]);
    };
    return (1 - v - w) * at(0) + v * at(1) + w * at(2);
}

std::optional<glm::vec3> albedo_of(const DrawableScene& scene, const ImageLook& look,
                                   const glm::dvec3& point, Source source) {
    const bool by_uv = look.mapping == ImageLook::Mapping::uv;
    if (by_uv && !has_uv(scene, source)) return std::nullopt;
    return image_albedo(scene, look, point, by_uv ? uv(scene, point, source) : glm::dvec2(0));
}

std::optional<glm::vec3> albedo_of(const PatternLook& look, const PixelRays& rays,
                                   const glm::dvec2& place, double depth) {
    constexpr double doubt = 1e-13;  // of the depth; some hundred roundings
    return pattern_albedo(look, rays.point(place, depth * (1 - doubt)),
                          rays.point(place, depth * (1 + doubt)));
}

}  // namespace

SeenLook seen_look(const DrawableScene& scene, const PixelRays& rays, const glm::dvec2& place,
                   double nearness, Source source) {
    if (source == ItemCanvas::nothing) return {Look::Kind::plain, {}};
    const Look* look = look_of(scene, source);
    if (!look) return {};
    if (!has_albedo(*look)) return {look->kind, {}};
    const double depth = rays.depth(nearness);
    const auto albedo = look->kind == Look::Kind::image
                            ? albedo_of(scene, look->image, rays.point(place, depth), source)
                            : albedo_of(look->pattern, rays, place, depth);
    return {albedo ? look->kind : Look::Kind::traced, albedo};
}

}  // namespace povpreview
