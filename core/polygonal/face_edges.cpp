// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/polygonal/face_edges.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <tuple>

namespace povpreview {
namespace {

/// Expected steps in colour, relative to that at a silhouette: rough, they only order the edges.
constexpr float material_step = .6f, least_crease = .05f, most_crease = .6f;

}  // namespace

FaceEdges::FaceEdges(const FlatFaces& faces) : faces_(faces) {
    struct Half {
        std::uint32_t a, b, face;
        bool forward;
    };
    std::vector<Half> halves;
    for (std::uint32_t face = 0; face < faces.size(); ++face) {
        const auto corners = faces.corners(face);
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const std::uint32_t a = corners[i], b = corners[(i + 1) % corners.size()];
            halves.push_back({std::min(a, b), std::max(a, b), face, a < b});
        }
    }
    std::sort(halves.begin(), halves.end(), [](const Half& p, const Half& q) {
        return std::tie(p.a, p.b, p.face) < std::tie(q.a, q.b, q.face);
    });
    users_.reserve(halves.size());
    forwards_.reserve(halves.size());
    for (const Half& half : halves) {
        if (edges_.empty() || edges_.back().a != half.a || edges_.back().b != half.b)
            edges_.push_back({half.a, half.b, static_cast<std::uint32_t>(users_.size()), 0, 0});
        ++edges_.back().count;
        users_.push_back(half.face);
        forwards_.push_back(half.forward);
    }
    for (Edge& edge : edges_) edge.crease = crease(edge);
}

/// Of several faces in one edge, two that continue each other make the others a mere ornament.
float FaceEdges::crease(const Edge& edge) const {
    float least = 1;
    for (std::uint32_t i = edge.first; i < edge.first + edge.count; ++i)
        for (std::uint32_t j = i + 1; j < edge.first + edge.count; ++j)
            least = std::min(least, crease_between(i, j));
    return edge.count > 2 ? std::max(least, least_crease) : least;
}

float FaceEdges::crease_between(std::uint32_t use, std::uint32_t other) const {
    const Face &p = faces_.face(users_[use]), &q = faces_.face(users_[other]);
    if (p.smooth != 0 && p.smooth == q.smooth) return 0;
    const glm::dvec3 &m = faces_[users_[use]].normal, &n = faces_[users_[other]].normal;
    // Faces that run along the edge in opposite directions have normals to the same side.
    const bool unfolded = (forwards_[use] != forwards_[other]) == (glm::dot(m, n) > 0);
    if (unfolded && coplanar(m, n)) return p.material == q.material ? 0 : material_step;
    if (p.material != q.material) return material_step;
    return std::clamp(static_cast<float>(glm::length(glm::cross(m, n))), least_crease, most_crease);
}

}  // namespace povpreview
