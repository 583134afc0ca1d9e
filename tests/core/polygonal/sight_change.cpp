// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/core/polygonal/sight_change.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace povpreview {
namespace {

constexpr Real together = 1e-4L;  ///< of the distance: two points of one surface
/// Of the distance: so near before a mirror, the face pierces it. What the eye does not see but the
/// mirror shows has a border of its reflection there that no edge of either face gives.
constexpr Real at_mirror = 1e-4L;
constexpr Real apart = 1e-2L;  ///< of the distance: points of surfaces with a gap between

bool share_corner(const PolygonScene& scene, const Face& a, const Face& b) {
    for (std::uint32_t i = 0; i < a.count; ++i)
        for (std::uint32_t j = 0; j < b.count; ++j)
            if (scene.corner(a, i) == scene.corner(b, j)) return true;
    return false;
}

enum class Join { one_surface, matter_of_taste, edge };

/// What two hits on different faces, seen beside each other, have between them.
Join join(const BruteForce& brute, const Hit& a, const Hit& b) {
    const Face& fa = brute.scene().faces[a.face];
    const Face& fb = brute.scene().faces[b.face];
    const bool smooth = fa.smooth != 0 && fa.smooth == fb.smooth;
    if (!smooth && !brute.coplanar(a.face, b.face)) return Join::edge;
    const Real gap = glm::distance(a.point, b.point) / std::max(a.distance, b.distance);
    // A face seen edge on has its far and its near end side by side.
    if (gap > apart)
        return share_corner(brute.scene(), fa, fb) ? Join::matter_of_taste : Join::edge;
    if (gap > together) return Join::matter_of_taste;
    if (smooth) return Join::one_surface;
    if (fa.material != fb.material) return Join::edge;
    return fa.surface == fb.surface ? Join::one_surface : Join::matter_of_taste;
}

bool at_its_mirror(const Hit& hit) {
    return hit.mirrors > 0 && hit.from_mirror < at_mirror * hit.distance;
}

Change edge_at(const Hit& hit) {
    return {hit.mirrors == 0 ? EdgeKind::geometric : EdgeKind::reflection, hit.path, 0, false};
}

}  // namespace

std::optional<Change> change_between(const BruteForce& brute, const Sight& a, const Sight& b) {
    std::optional<Change> taste;
    const auto matter_of_taste = [&](Change change) {
        change.optional = true;
        if (!taste) taste = change;
    };
    for (std::size_t i = 0; i < std::max(a.hits.size(), b.hits.size()); ++i) {
        if (i >= a.hits.size()) return edge_at(b.hits[i]);
        if (i >= b.hits.size()) return edge_at(a.hits[i]);
        const Hit &p = a.hits[i], &q = b.hits[i];
        if (p.path != q.path) return edge_at(p.mirrors > q.mirrors ? p : q);
        const bool two_faces = p.face != q.face;
        if (two_faces) {
            const bool pierces = at_its_mirror(p) || at_its_mirror(q);
            const Join joined = pierces ? Join::matter_of_taste : join(brute, p, q);
            if (joined == Join::edge) return edge_at(p);
            if (joined == Join::matter_of_taste) matter_of_taste(edge_at(p));
        }
        Change shadow = edge_at(p);
        if (p.mirrors == 0) shadow.kind = EdgeKind::shadow;
        shadow.lights = p.lit ^ q.lit;
        if (shadow.lights != 0) {
            if (!two_faces || brute.coplanar(p.face, q.face)) return shadow;
            matter_of_taste(shadow);
        }
        shadow.lights = p.filtered ^ q.filtered;
        if (shadow.lights != 0) matter_of_taste(shadow);
    }
    return taste;
}

bool same_sight(const Sight& a, const Sight& b) {
    return std::equal(a.hits.begin(), a.hits.end(), b.hits.begin(), b.hits.end(),
                      [](const Hit& p, const Hit& q) {
                          return p.face == q.face && p.path == q.path && p.lit == q.lit;
                      });
}

void close_in(const BruteForce& brute, glm::dvec2& a, glm::dvec2& b) {
    const Sight before = brute.look(a);
    while (glm::distance(a, b) > 1e-9) {
        const glm::dvec2 middle = .5 * (a + b);
        (same_sight(before, brute.look(middle)) ? a : b) = middle;
    }
}

}  // namespace povpreview
