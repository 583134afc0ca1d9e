// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/polygonal/flat_faces.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <unordered_map>

#include "core/polygonal/sides.h"

namespace povpreview {
namespace {

/// Twice a face's area against its squared diameter: less is a line, as far as numbers can tell.
constexpr double least_area = 1e-12;

struct Hash {
    std::size_t operator()(const glm::dvec3& p) const {
        std::size_t h = 0;
        for (int k = 0; k < 3; ++k)  // + 0.: the two zeros are equal and must hash alike
            h = (h ^ std::hash<double>()(p[k] + 0.)) * 0x9e3779b97f4a7c15u;
        return h ^ (h >> 29);
    }
};

/// Of a parallel view: a step of one pixel to the right is 1 / |x row| long.
double view_width(const PolygonScene& scene) {
    const glm::dmat4x3& m = scene.camera.to_pixels;
    return scene.width / glm::length(glm::dvec3(m[0].x, m[1].x, m[2].x));
}

}  // namespace

FlatFaces::FlatFaces(const PolygonScene& scene) : scene_(scene), width_(view_width(scene)) {
    weld();
    flats_.reserve(scene.faces.size());
    for (std::uint32_t i = 0; i < scene.faces.size(); ++i) add(i);
}

void FlatFaces::weld() {
    std::unordered_map<glm::dvec3, std::uint32_t, Hash> numbers;
    numbers.reserve(scene_.points.size());
    welded_.reserve(scene_.points.size());
    for (const glm::dvec3& p : scene_.points) {
        const auto next = static_cast<std::uint32_t>(points_.size());
        const auto number = usable(p) ? numbers.try_emplace(p, next).first->second : next;
        if (number == next) points_.push_back(p);
        welded_.push_back(number);
    }
}

/// Takes a face over, unless it is none.
bool FlatFaces::add(std::uint32_t source) {
    const Face& face = scene_.faces[source];
    const auto first = static_cast<std::uint32_t>(corners_.size());
    if (std::size_t{face.first} + face.count > scene_.corners.size()) return false;
    for (std::uint32_t i = 0; i < face.count; ++i) {
        const std::uint32_t index = scene_.corners[face.first + i];
        if (index >= welded_.size() || !usable(scene_.points[index])) {
            corners_.resize(first);
            return false;
        }
        if (corners_.size() == first || corners_.back() != welded_[index])
            corners_.push_back(welded_[index]);
    }
    while (corners_.size() > first + 1 && corners_.back() == corners_[first]) corners_.pop_back();
    const auto count = static_cast<std::uint32_t>(corners_.size()) - first;
    // The widest triangle out of the first corner: the others might lie on a line with it.
    glm::dvec3 normal(0);
    double widest = 0, diameter2 = 0;
    std::array<std::uint32_t, 3> triangle{};
    for (std::uint32_t i = 1; i + 1 < count; ++i) {
        const std::uint32_t a = corners_[first], b = corners_[first + i],
                            c = corners_[first + i + 1];
        const glm::dvec3 u = points_[b] - points_[a], v = points_[c] - points_[a];
        const glm::dvec3 n = glm::cross(u, v);
        diameter2 = std::max({diameter2, glm::dot(u, u), glm::dot(v, v)});
        normal += n;
        if (const double area = glm::dot(n, n); area > widest) widest = area, triangle = {a, b, c};
    }
    const double area = glm::length(normal);
    if (count < 3 || !(area > least_area * diameter2) || widest == 0) {
        corners_.resize(first);
        return false;
    }
    flats_.push_back({first, count, triangle, normal / area, points_[triangle[0]], source});
    return true;
}

int FlatFaces::facing(std::size_t i, const glm::dvec4& viewpoint) const {
    const Flat& flat = flats_[i];
    const auto [a, b, c] = flat.triangle;
    return -exact_side(viewpoint, points_[a], points_[b], points_[c]);
}

}  // namespace povpreview
