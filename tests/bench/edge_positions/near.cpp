// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/bench/edge_positions/near.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace povpreview {

Cells::Cells(glm::ivec2 size) : size_(size), cells_(std::size_t(size.x) * std::size_t(size.y)) {}

glm::ivec2 Cells::cell(glm::dvec2 p) const {
    return glm::clamp(glm::ivec2(glm::floor(p)), glm::ivec2(0), size_ - 1);
}

void Cells::add(glm::dvec2 p, std::uint32_t what) {
    const glm::ivec2 c = cell(p);
    std::vector<std::uint32_t>& here = cells_[std::size_t(c.y) * size_.x + c.x];
    if (here.empty() || here.back() != what) here.push_back(what);
}

NearPoints::NearPoints(std::span<const glm::dvec2> points, glm::ivec2 size)
    : points_(points.begin(), points.end()), cells_(size) {
    for (std::size_t i = 0; i < points_.size(); ++i)
        cells_.add(points_[i], static_cast<std::uint32_t>(i));
}

bool NearPoints::within(glm::dvec2 p, double radius) const {
    bool found = false;
    cells_.for_each_near(p,
                         [&](std::uint32_t i) { found |= glm::distance(points_[i], p) <= radius; });
    return found;
}

void NearSegments::add(const EdgeChain& chain) {
    for (std::size_t i = 1; i < chain.vertices.size(); ++i) {
        const glm::dvec2 a = chain.vertices[i - 1], b = chain.vertices[i];
        const auto number = static_cast<std::uint32_t>(segments_.size());
        segments_.push_back({a, b});
        // A point of the segment is never farther than a quarter of a pixel from one added here.
        const int steps = std::max(1, static_cast<int>(std::ceil(glm::distance(a, b) / .5)));
        for (int k = 0; k <= steps; ++k) cells_.add(a + (b - a) * (double(k) / steps), number);
    }
}

bool NearSegments::within(glm::dvec2 p, double radius) const {
    bool found = false;
    cells_.for_each_near(p, [&](std::uint32_t i) {
        if (found) return;
        const glm::dvec2 a = segments_[i].from, d = segments_[i].to - a;
        const double square = glm::dot(d, d);
        const double t = square > 0 ? glm::clamp(glm::dot(p - a, d) / square, 0., 1.) : 0;
        found = glm::distance(a + t * d, p) <= radius;
    });
    return found;
}

}  // namespace povpreview
