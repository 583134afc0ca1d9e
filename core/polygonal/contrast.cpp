// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/polygonal/contrast.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "core/polygonal/sides.h"

namespace povpreview {
namespace {

/// How far beside an edge one looks, as a share of its distance: about a tenth of a pixel.
constexpr double beside = 1e-4;

/// A surface goes on where the other side is no farther than this from its plane, or from its
/// point, times how far beside the edge one looked: the slope of the line of sight.
constexpr double steepest = 20;

glm::dvec3 unit(const glm::dvec3& v) {
    const double length = glm::length(v);
    return length > 0 ? v / length : glm::dvec3(0);
}

}  // namespace

bool Contrast::of_surfaces(const ShadowVolumes& volumes, const glm::dvec3& p,
                           const glm::dvec3& along) const {
    const glm::dvec3 step =
        beside * faces_.scale(p) * unit(glm::cross(sight_line(volumes.viewpoint(), p), along));
    const auto a = volumes.first_face(p - step), b = volumes.first_face(p + step);
    if (!a || !b) return a.has_value() != b.has_value();
    return a->face != b->face && !continues(volumes, *a, *b, volumes.behind(p - step, a->nearness),
                                            volumes.behind(p + step, b->nearness));
}

/// Whether two points are on the same even surface.
bool Contrast::continues(const ShadowVolumes& volumes, const ShadowVolumes::Sight& a,
                         const ShadowVolumes::Sight& b, const glm::dvec3& at_a,
                         const glm::dvec3& at_b) const {
    const Face &f = faces_.face(a.face), &g = faces_.face(b.face);
    const double gap = beside * faces_.scale(at_a);
    if (f.smooth != 0 && f.smooth == g.smooth)
        return glm::distance(at_a, at_b) < steepest * gap &&
               volumes.facing(a.face) * volumes.facing(b.face) *
                       glm::dot(faces_[a.face].normal, faces_[b.face].normal) >
                   0;
    return f.material == g.material && coplanar(faces_[a.face].normal, faces_[b.face].normal) &&
           std::abs(faces_.height(a.face, at_b)) < coplanar_sine * steepest * gap;
}

bool Contrast::of_light(const ShadowVolumes& light, std::uint32_t face, const glm::dvec3& p,
                        const glm::dvec3& along) const {
    const glm::dvec3 step = beside * faces_.scale(p) * unit(glm::cross(faces_[face].normal, along));
    return lit(light, p - step) != lit(light, p + step);
}

bool Contrast::lit(const ShadowVolumes& light, const glm::dvec3& p) const {
    const auto first = light.first_face(p);
    if (!first || first->nearness <= light.viewpoint().w) return true;  // beyond the point
    return glm::distance(light.behind(p, first->nearness), p) <= beside * faces_.scale(p);
}

}  // namespace povpreview
