// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/polygonal/contrast.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/polygonal/sides.h"

namespace povpreview {
namespace {

/// How far beside an edge one looks, as a share of its distance: about a tenth of a pixel.
constexpr double beside = 1e-4;

/// What is seen beside an edge belongs to the surface at the edge where it is no farther from there
/// than this times how far beside it one looked: as far as a surface may lean from the eye.
constexpr double steepest = 20;

glm::dvec3 unit(const glm::dvec3& v) {
    const double length = glm::length(v);
    return length > 0 ? v / length : glm::dvec3(0);
}

}  // namespace

bool Contrast::of_surfaces(const ShadowVolumes& volumes, std::span<const std::uint32_t> faces,
                           const glm::dvec3& p, const glm::dvec3& along) const {
    const glm::dvec3 step =
        beside * faces_.scale(p) * unit(glm::cross(sight_line(volumes.viewpoint(), p), along));
    const auto a = volumes.first_face(p - step), b = volumes.first_face(p + step);
    if (!a || !b) return true;
    // What shines through is not looked into.
    if (faces_.face(a->face).transparent || faces_.face(b->face).transparent) return true;
    const double gap = steepest * glm::length(step);
    const glm::dvec3 at_a = volumes.behind(p - step, a->nearness);
    const glm::dvec3 at_b = volumes.behind(p + step, b->nearness);
    if (a->face != b->face && !continue_each_other(a->face, b->face, at_b, gap)) return true;
    // It is one even surface; or the edge belongs to something very thin before that.
    return std::none_of(faces.begin(), faces.end(), [&](std::uint32_t face) {
        return continue_each_other(face, a->face, at_a, gap);
    });
}

/// Whether b, at a point that is near to a or to its plane, goes on with the same even surface.
bool Contrast::continue_each_other(std::uint32_t a, std::uint32_t b, const glm::dvec3& at_b,
                                   double gap) const {
    const Face &f = faces_.face(a), &g = faces_.face(b);
    const double height = std::abs(faces_.height(a, at_b));
    if (f.smooth != 0 && f.smooth == g.smooth) return height < gap;
    return f.material == g.material && coplanar(faces_[a].normal, faces_[b].normal) &&
           height < coplanar_sine * gap;
}

bool Contrast::of_light(const ShadowVolumes& light, std::uint32_t face, const glm::dvec3& p,
                        const glm::dvec3& along) const {
    const glm::dvec3 step = beside * faces_.scale(p) * unit(glm::cross(faces_[face].normal, along));
    const Light a = falling(light, p - step), b = falling(light, p + step);
    return a != b || a == Light::filtered;
}

Contrast::Light Contrast::falling(const ShadowVolumes& light, const glm::dvec3& p) const {
    const auto first = light.first_face(p);
    const bool beyond = !first || first->nearness <= light.viewpoint().w;
    if (beyond || glm::distance(light.behind(p, first->nearness), p) <= beside * faces_.scale(p))
        return Light::full;
    return faces_.face(first->face).transparent ? Light::filtered : Light::none;
}

}  // namespace povpreview
