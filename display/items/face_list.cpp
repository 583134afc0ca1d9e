// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/items/face_list.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

namespace povpreview::items {

namespace {

/// A function that is linear in the image: value at a reference pixel, and slopes.
struct Linear {
    double at = 0, x = 0, y = 0;
};

Linear operator*(double factor, const Linear& f) {
    return {factor * f.at, factor * f.x, factor * f.y};
}
Linear operator+(const Linear& a, const Linear& b) { return {a.at + b.at, a.x + b.x, a.y + b.y}; }
Linear operator+(double a, const Linear& b) { return {a + b.at, b.x, b.y}; }

class FaceLister {
   public:
    FaceLister(const DrawableScene& scene, const PixelRays& rays, DrawLists& lists)
        : scene_(scene), polygons_(scene.polygons), rays_(rays), lists_(lists) {}

    void add(const Face& face) {
        if (!face.visible || face.count < 3) return;
        if (!has_uv_image(scene_, face.material)) {
            corners_.clear();
            for (std::size_t i = 0; i < face.count; ++i)
                corners_.push_back(polygons_.corner(face, i));
            add_polygon(face, nullptr);
            return;
        }
        for (std::uint32_t i = 2; i < face.count; ++i) {
            const std::uint32_t fan[] = {face.first, face.first + i - 1, face.first + i};
            corners_.clear();
            glm::vec2 uvs[3];
            for (int corner = 0; corner < 3; ++corner) {
                corners_.push_back(polygons_.points[polygons_.corners[fan[corner]]]);
                uvs[corner] = scene_.corner_uvs[fan[corner]];
            }
            add_polygon(face, uvs);
        }
    }

   private:
    /// The polygon of corners_; `uvs`, of its three corners, may be null.
    void add_polygon(const Face& face, const glm::vec2* uvs) {
        clipped_.clear();
        for (const glm::dvec3& p : corners_) {
            clipped_.push_back(rays_.project(p));
            const Projected& last = clipped_.back();
            if (!std::isfinite(last.x + last.y + last.w + last.depth)) return;
        }
        clip_to_view(clipped_, polygons_.width, polygons_.height);
        if (clipped_.size() < 3) return;

        const glm::dvec3 normal = normal_of_corners();
        reference_ = glm::round(clipped_[0].pixel());
        const Linear v = depth_measure(normal);
        if (!std::isfinite(v.at + v.x + v.y)) return;  // no area, or seen edge-on

        const std::uint32_t record = lists_.records.next();
        lists_.records.push(glm::dvec3(reference_, v.at), 0u);
        lists_.records.push(glm::dvec3(v.x, v.y, 0), 0u);
        lists_.records.push_bits(face.surface,
                                 look_of(face.material) | (uvs ? Records::has_uvs : 0), 0, 0);
        if (uvs) push_uvs(normal, v, uvs);
        push_fan(record);
    }

    /// Newell's: right for polygons with doubled or collinear corners too.
    glm::dvec3 normal_of_corners() const {
        glm::dvec3 normal{0};
        for (std::size_t i = 2; i < corners_.size(); ++i)
            normal += glm::cross(corners_[i - 1] - corners_[0], corners_[i] - corners_[0]);
        return normal;
    }

    /// dot(vector, direction of the rays); orthographic: their origins.
    Linear along_rays(const glm::dvec3& vector) const {
        const glm::dvec3 at = rays_.orthographic ? rays_.point(reference_, 0) - rays_.origin
                                                 : rays_.direction(reference_);
        return {glm::dot(vector, at), glm::dot(vector, rays_.across), glm::dot(vector, rays_.down)};
    }

    /// What texture and depth are computed from, see list_faces().
    Linear depth_measure(const glm::dvec3& normal) const {
        const double distance = glm::dot(normal, corners_[0] - rays_.origin);
        if (rays_.orthographic)
            return (1 / glm::dot(normal, rays_.along)) * (distance + -1. * along_rays(normal));
        return (nearest_depth / distance) * along_rays(normal);
    }

    void push_uvs(const glm::dvec3& normal, const Linear& v, const glm::vec2* uvs) {
        const glm::dvec3 a = corners_[1] - corners_[0], b = corners_[2] - corners_[0];
        const double area = glm::dot(normal, normal);
        Linear coordinate[2];
        for (int i = 0; i < 2; ++i) {
            const double to_a = double(uvs[1][i]) - uvs[0][i], to_b = double(uvs[2][i]) - uvs[0][i];
            const glm::dvec3 slope =
                (to_a * glm::cross(b, normal) + to_b * glm::cross(normal, a)) / area;
            const double at_origin = uvs[0][i] + glm::dot(slope, rays_.origin - corners_[0]);
            if (rays_.orthographic)
                coordinate[i] = at_origin + (along_rays(slope) + glm::dot(slope, rays_.along) * v);
            else
                coordinate[i] = at_origin * v + nearest_depth * along_rays(slope);
        }
        const auto& [u, w] = coordinate;
        lists_.records.push(glm::dvec3(u.at, u.x, u.y), Records::bits(w.at));
        lists_.records.push(glm::dvec3(w.x, w.y, 0), 0u);
    }

    void push_fan(std::uint32_t record) {
        for (std::size_t i = 2; i < clipped_.size(); ++i)
            for (const std::size_t corner : {std::size_t{0}, i - 1, i})
                lists_.faces.push_back({glm::vec2(clipped_[corner].pixel()), record});
    }

    const DrawableScene& scene_;
    const PolygonScene& polygons_;
    const PixelRays& rays_;
    DrawLists& lists_;
    std::vector<glm::dvec3> corners_;
    std::vector<Projected> clipped_;
    glm::dvec2 reference_{};
};

}  // namespace

bool has_uv_image(const DrawableScene& scene, std::uint32_t material) {
    return material < scene.looks.size() && scene.looks[material].kind == Look::Kind::image &&
           scene.looks[material].image.mapping == ImageLook::Mapping::uv &&
           scene.corner_uvs.size() == scene.polygons.corners.size();
}

std::uint32_t look_of(std::uint32_t material) { return std::min(material, Records::no_look); }

void list_faces(const DrawableScene& scene, const PixelRays& rays, DrawLists& lists) {
    FaceLister lister(scene, rays, lists);
    lists.faces.reserve(3 * scene.polygons.faces.size());
    lists.records.texels().reserve(3 * scene.polygons.faces.size());
    for (const Face& face : scene.polygons.faces) lister.add(face);
}

}  // namespace povpreview::items
