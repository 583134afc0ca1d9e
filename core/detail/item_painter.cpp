// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/detail/item_painter.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <optional>

#include "core/detail/curved_items.h"
#include "core/detail/face_items.h"
#include "core/detail/image_look.h"
#include "core/detail/item_sources.h"
#include "core/detail/mirrored_items.h"
#include "core/detail/pattern_look.h"
#include "core/detail/row_bands.h"

namespace povpreview {

namespace {

using Source = ItemCanvas::Source;

/// What a canvas shows, told in the scene's terms.
class Reading {
   public:
    Reading(const DrawableScene& scene, const PixelRays& rays, const ItemCanvas& canvas)
        : scene_(scene), rays_(rays), canvas_(canvas) {}

    ItemBuffer read() {
        result_.width = canvas_.width();
        result_.height = canvas_.height();
        const std::size_t pixels = std::size_t(result_.width) * std::size_t(result_.height);
        result_.surfaces.resize(pixels, ItemBuffer::unknown);
        result_.kinds.resize(pixels, Look::Kind::mixed);
        if (std::any_of(scene_.looks.begin(), scene_.looks.end(), has_albedo))
            result_.albedos.resize(pixels);
        for_each_band(0, result_.height, rows_for_threads(result_.height),
                      [&](int, int top, int bottom) {
                          for (int y = top; y < bottom; ++y)
                              for (int x = 0; x < result_.width; ++x) read(x, y);
                      });
        for (const ItemCanvas::Tie& tie : canvas_.ties())
            if (canvas_.stands(tie) &&
                surface_of(scene_, tie.first) != surface_of(scene_, tie.second))
                forget(tie.pixel);
        return std::move(result_);
    }

   private:
    static bool has_albedo(const Look& look) {
        return look.kind == Look::Kind::image || look.kind == Look::Kind::pattern;
    }

    void read(int x, int y) {
        const std::size_t pixel = canvas_.index(x, y);
        const Source source = canvas_.source(pixel);
        result_.surfaces[pixel] = surface_of(scene_, source);
        if (source == ItemCanvas::unknown) return;
        if (source == ItemCanvas::nothing) {
            // A sky may be of any colour, and nothing tells it apart from light.
            result_.kinds[pixel] = Look::Kind::plain;
            return;
        }
        const std::uint32_t number = material_of(scene_, source);
        if (number >= scene_.looks.size()) return;
        const Look& look = scene_.looks[number];
        result_.kinds[pixel] = look.kind;
        const glm::dvec2 centre(x + .5, y + .5);
        const double depth = rays_.depth(canvas_.nearness(pixel));
        if (look.kind == Look::Kind::image)
            set_albedo(pixel, albedo_of(look.image, rays_.point(centre, depth), source));
        if (look.kind == Look::Kind::pattern)
            set_albedo(pixel, albedo_of(look.pattern, centre, depth));
    }

    std::optional<glm::vec3> albedo_of(const ImageLook& look, const glm::dvec3& point,
                                       Source source) const {
        const bool by_uv = look.mapping == ImageLook::Mapping::uv;
        if (by_uv && !has_uv(source)) return std::nullopt;
        return image_albedo(scene_, look, point, by_uv ? uv(point, source) : glm::dvec2(0));
    }

    /// Nothing where the surface lies in a border of the pattern, as well as depths are known: a
    /// ray's rounding would decide there, all over the surface.
    std::optional<glm::vec3> albedo_of(const PatternLook& look, const glm::dvec2& centre,
                                       double depth) const {
        constexpr double doubt = 1e-13;  // of the depth; some hundred roundings
        const auto albedo = pattern_albedo(look, rays_.point(centre, depth));
        for (const double factor : {1 - doubt, 1 + doubt})
            if (pattern_albedo(look, rays_.point(centre, depth * factor)) != albedo)
                return std::nullopt;
        return albedo;
    }

    void set_albedo(std::size_t pixel, const std::optional<glm::vec3>& albedo) {
        if (!albedo) {
            result_.kinds[pixel] = Look::Kind::traced;
            return;
        }
        result_.albedos[pixel] = *albedo;
    }

    bool has_uv(Source source) const {
        if (source & ItemCanvas::piece_bit) return false;
        const Face& face = scene_.polygons.faces[source];
        return std::size_t{face.first} + face.count <= scene_.corner_uvs.size();
    }
    /// Of a point on a face over which UV coordinates are linear. REQUIRES: has_uv().
    glm::dvec2 uv(const glm::dvec3& point, Source source) const {
        const PolygonScene& polygons = scene_.polygons;
        const Face& face = polygons.faces[source];
        const glm::dvec3 a = polygons.corner(face, 0), ab = polygons.corner(face, 1) - a,
                         ac = polygons.corner(face, 2) - a, ap = point - a;
        const glm::dvec3 normal = glm::cross(ab, ac);
        const double area = glm::dot(normal, normal);
        const double v = glm::dot(glm::cross(ap, ac), normal) / area,
                     w = glm::dot(glm::cross(ab, ap), normal) / area;
        const auto at = [&](std::size_t corner) {
            return glm::dvec2(scene_.corner_uvs[face.first + corner]);
        };
        return (1 - v - w) * at(0) + v * at(1) + w * at(2);
    }

    void forget(std::size_t pixel) {
        result_.surfaces[pixel] = ItemBuffer::unknown;
        result_.kinds[pixel] = Look::Kind::mixed;
    }

    const DrawableScene& scene_;
    const PixelRays& rays_;
    const ItemCanvas& canvas_;
    ItemBuffer result_;
};

}  // namespace

ItemPainting::ItemPainting(const DrawableScene& scene, const std::atomic<bool>& stop)
    : rays_(scene.polygons.camera), canvas_(scene.polygons.width, scene.polygons.height) {
    if (!rays_.valid) {
        for (std::size_t pixel = 0; pixel < canvas_.index(0, canvas_.height()); ++pixel)
            canvas_.hide(pixel, 0);
        return;
    }
    draw_faces(scene.polygons, rays_, canvas_, stop);
    draw_curved(scene, rays_, canvas_, stop);
}

ItemBuffer ItemPainting::read(const DrawableScene& scene) const {
    return Reading(scene, rays_, canvas_).read();
}

void ItemPainting::paint_mirrors(const DrawableScene& scene, const std::atomic<bool>& stop,
                                 ItemBuffer& items) const {
    if (rays_.valid) paint_mirrored(scene, rays_, canvas_, stop, items);
}

ItemBuffer paint_items(const DrawableScene& scene, const std::atomic<bool>& stop) {
    const ItemPainting painting(scene, stop);
    ItemBuffer items = painting.read(scene);
    painting.paint_mirrors(scene, stop, items);
    return items;
}

}  // namespace povpreview
