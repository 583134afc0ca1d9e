// SPDX-License-Identifier: AGPL-3.0-or-later
#include "backend/oracle/even_odd.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace povpreview::tracer {

namespace {

/// A side of a ring, upwards; never level.
struct Edge {
    Point2 low, high;

    double at(double v) const {
        if (v <= low.v) return low.u;
        if (v >= high.v) return high.u;
        return low.u + (v - low.v) / (high.v - low.v) * (high.u - low.u);
    }
};

std::vector<Edge> edges_of(const std::vector<Ring>& rings) {
    std::vector<Edge> edges;
    for (const Ring& ring : rings)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
            if (a.v < b.v) edges.push_back({a, b});
            if (b.v < a.v) edges.push_back({b, a});
        }
    return edges;
}

/// Levels strictly between `low` and `high` at which two of the edges cross.
void add_crossings(const std::vector<Edge>& edges, double low, double high,
                   std::vector<double>& levels) {
    for (std::size_t i = 0; i < edges.size(); ++i)
        for (std::size_t j = i + 1; j < edges.size(); ++j) {
            const double below = edges[i].at(low) - edges[j].at(low),
                         above = edges[i].at(high) - edges[j].at(high);
            if (below * above >= 0) continue;
            const double level = low + below / (below - above) * (high - low);
            if (level > low && level < high) levels.push_back(level);
        }
}

/// From one edge to the next at a level; where they meet, rounding could put them in wrong order.
std::pair<double, double> between(const Edge& left, const Edge& right, double level) {
    const double u = left.at(level), v = right.at(level);
    constexpr double rounding = 1e-12;
    return {u, v - u > rounding * (std::fabs(u) + std::fabs(v)) ? v : u};
}

void add_slab(std::vector<Edge>& edges, double low, double high, std::vector<Ring>& pieces) {
    const double middle = low + (high - low) / 2;
    std::sort(edges.begin(), edges.end(),
              [middle](const Edge& a, const Edge& b) { return a.at(middle) < b.at(middle); });
    for (std::size_t i = 0; i + 1 < edges.size(); i += 2) {
        const auto [low_left, low_right] = between(edges[i], edges[i + 1], low);
        const auto [high_left, high_right] = between(edges[i], edges[i + 1], high);
        Ring piece{{low_left, low}};
        if (low_right != low_left) piece.push_back({low_right, low});
        piece.push_back({high_right, high});
        if (high_left != high_right) piece.push_back({high_left, high});
        if (piece.size() >= 3) pieces.push_back(std::move(piece));
    }
}

}  // namespace

std::vector<Ring> trapezoids(const std::vector<Ring>& rings) {
    const std::vector<Edge> edges = edges_of(rings);
    std::vector<double> levels;
    for (const Edge& edge : edges) levels.insert(levels.end(), {edge.low.v, edge.high.v});
    const auto sort_out = [](std::vector<double>& values) {
        std::sort(values.begin(), values.end());
        values.erase(std::unique(values.begin(), values.end()), values.end());
    };
    sort_out(levels);

    std::vector<Ring> pieces;
    for (std::size_t i = 0; i + 1 < levels.size(); ++i) {
        std::vector<Edge> crossing;
        for (const Edge& edge : edges)
            if (edge.low.v <= levels[i] && edge.high.v >= levels[i + 1]) crossing.push_back(edge);
        std::vector<double> inner{levels[i], levels[i + 1]};
        add_crossings(crossing, levels[i], levels[i + 1], inner);
        sort_out(inner);
        for (std::size_t j = 0; j + 1 < inner.size(); ++j)
            add_slab(crossing, inner[j], inner[j + 1], pieces);
    }
    return pieces;
}

}  // namespace povpreview::tracer
