// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/edge_graph.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <tuple>
#include <utility>

namespace povpreview {

namespace {
constexpr std::uint32_t none = 0xffffffff;
/// Buckets at most: those of larger images are larger than a pixel.
constexpr double most_buckets = 1 << 20;
}  // namespace

PointGrid::PointGrid(glm::ivec2 size)
    : cell_(std::max(1., std::sqrt(double(size.x) * size.y / most_buckets))),
      columns_(static_cast<int>(size.x / cell_) + 1),
      rows_(static_cast<int>(size.y / cell_) + 1),
      heads_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), none) {}

glm::ivec2 PointGrid::cell_of(glm::dvec2 p) const {
    return glm::clamp(glm::ivec2(glm::floor(p / cell_)), glm::ivec2(0),
                      glm::ivec2(columns_ - 1, rows_ - 1));
}

std::uint32_t PointGrid::snap(glm::dvec2 p, double radius) {
    const glm::ivec2 low = cell_of(p - radius), high = cell_of(p + radius);
    std::uint32_t best = none;
    double least = radius;
    for (int j = low.y; j <= high.y; ++j)
        for (int i = low.x; i <= high.x; ++i)
            for (std::uint32_t n = head(i, j); n != none; n = next_[n])
                if (const double d = glm::distance(points_[n], p); d < least) least = d, best = n;
    if (best != none) return best;
    const glm::ivec2 cell = cell_of(p);
    const auto number = static_cast<std::uint32_t>(points_.size());
    points_.push_back(p);
    next_.push_back(head(cell.x, cell.y));
    head(cell.x, cell.y) = number;
    return number;
}

/// Walks along the segment column by column (row by row, where it is steep).
void PointGrid::beside(std::uint32_t a, std::uint32_t b, double radius,
                       std::vector<std::uint32_t>& found) const {
    found.clear();
    const glm::dvec2 from = points_[a], d = points_[b] - from;
    const double length2 = glm::dot(d, d);
    std::vector<std::pair<double, std::uint32_t>> placed;
    const auto consider = [&](std::uint32_t n) {
        if (n == a || n == b) return;
        const glm::dvec2 p = points_[n] - from;
        const double along = glm::dot(p, d), across = p.x * d.y - p.y * d.x;
        if (along > 0 && along < length2 && across * across < radius * radius * length2)
            placed.emplace_back(along, n);
    };
    const int major = std::abs(d.x) >= std::abs(d.y) ? 0 : 1, minor = 1 - major;
    const glm::dvec2 low = glm::min(from, points_[b]) - radius;
    const glm::dvec2 high = glm::max(from, points_[b]) + radius;
    const double slope = d[major] != 0 ? d[minor] / d[major] : 0;
    for (int k = cell_of(low)[major]; k <= cell_of(high)[major]; ++k) {
        const double start = std::max(k * cell_ - radius, low[major]);
        const double stop = std::min((k + 1) * cell_ + radius, high[major]);
        const double u = from[minor] + (start - from[major]) * slope;
        const double v = from[minor] + (stop - from[major]) * slope;
        glm::dvec2 p, q;
        p[major] = q[major] = (k + .5) * cell_;
        p[minor] = std::max(std::min(u, v) - radius, low[minor]);
        q[minor] = std::min(std::max(u, v) + radius, high[minor]);
        const glm::ivec2 first = cell_of(p), last = cell_of(q);
        for (int m = first[minor]; m <= last[minor]; ++m)
            for (std::uint32_t n = major == 0 ? head(k, m) : head(m, k); n != none; n = next_[n])
                consider(n);
    }
    std::sort(placed.begin(), placed.end());
    for (const auto& [along, n] : placed) found.push_back(n);
}

EdgeGraph build_edge_graph(const std::vector<ImageEdge>& pieces, glm::ivec2 size, double snap) {
    using Link = EdgeGraph::Link;
    PointGrid grid(size);
    std::vector<Link> whole;
    whole.reserve(pieces.size());
    for (const ImageEdge& piece : pieces) {
        const std::uint32_t a = grid.snap(piece.from, snap), b = grid.snap(piece.to, snap);
        if (a != b)
            whole.push_back(
                {std::min(a, b), std::max(a, b), piece.kind, piece.light, piece.importance});
    }
    const auto unify = [](std::vector<Link>& links) {
        std::sort(links.begin(), links.end(), [](const Link& p, const Link& q) {
            return std::tie(p.a, p.b, p.kind, p.light, q.importance) <
                   std::tie(q.a, q.b, q.kind, q.light, p.importance);
        });
        const auto same = [](const Link& p, const Link& q) { return p.a == q.a && p.b == q.b; };
        links.erase(std::unique(links.begin(), links.end(), same), links.end());
    };
    unify(whole);
    EdgeGraph graph;
    std::vector<std::uint32_t> on_the_way;
    for (const Link& link : whole) {
        grid.beside(link.a, link.b, snap, on_the_way);
        on_the_way.push_back(link.b);
        std::uint32_t from = link.a;
        for (std::uint32_t to : on_the_way) {
            Link part = link;
            part.a = std::min(from, to);
            part.b = std::max(from, to);
            graph.links.push_back(part);
            from = to;
        }
    }
    unify(graph.links);
    graph.nodes = grid.points();
    return graph;
}

}  // namespace povpreview
