// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/polyline.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

namespace povpreview {
namespace {

double cross(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }

/// Marks the vertices to keep strictly between `first` and `last`. A stack of its own, since a
/// polyline may be long and recursion as deep as it.
void mark_kept(const Polyline& line, std::size_t first, std::size_t last, double tolerance,
               std::vector<bool>& kept) {
    std::vector<std::pair<std::size_t, std::size_t>> open{{first, last}};
    while (!open.empty()) {
        const auto [a, b] = open.back();
        open.pop_back();
        double worst = tolerance;
        std::size_t split = a;
        for (std::size_t i = a + 1; i < b; ++i) {
            const double d = distance_to_segment(line[i], line[a], line[b % line.size()]);
            if (d > worst) worst = d, split = i;
        }
        if (split == a) continue;
        kept[split] = true;
        open.push_back({a, split});
        open.push_back({split, b});
    }
}

}  // namespace

double distance_to_segment(glm::dvec2 p, glm::dvec2 a, glm::dvec2 b) {
    const glm::dvec2 ab = b - a;
    const double length2 = glm::dot(ab, ab);
    const double t = length2 > 0 ? std::clamp(glm::dot(p - a, ab) / length2, 0., 1.) : 0.;
    return glm::distance(p, a + t * ab);
}

Polyline simplify(const Polyline& line, double tolerance, bool closed) {
    const std::size_t n = line.size();
    if (n < 3) return line;
    std::vector<bool> kept(n, false);
    kept[0] = true;
    if (closed) {
        const auto farthest =
            std::max_element(line.begin(), line.end(), [&](glm::dvec2 p, glm::dvec2 q) {
                return glm::distance(p, line[0]) < glm::distance(q, line[0]);
            });
        const auto half = static_cast<std::size_t>(farthest - line.begin());
        kept[half] = true;
        mark_kept(line, 0, half, tolerance, kept);
        mark_kept(line, half, n, tolerance, kept);
    } else {
        kept[n - 1] = true;
        mark_kept(line, 0, n - 1, tolerance, kept);
    }
    Polyline result;
    for (std::size_t i = 0; i < n; ++i) {
        if (kept[i]) result.push_back(line[i]);
    }
    return result;
}

glm::dvec2 clip_to_border(glm::dvec2 inside, glm::dvec2 outside, glm::dvec2 size) {
    double t = 1;
    int axis = -1;
    double border = 0;
    for (int k = 0; k < 2; ++k) {
        if (outside[k] >= 0 && outside[k] <= size[k]) continue;
        const double side = outside[k] < 0 ? 0 : size[k];
        const double at = (side - inside[k]) / (outside[k] - inside[k]);
        if (axis < 0 || at < t) t = at, axis = k, border = side;
    }
    assert(axis >= 0);
    glm::dvec2 p = glm::clamp(inside + t * (outside - inside), glm::dvec2(0), size);
    p[axis] = border;
    return p;
}

std::optional<Circle> circle_through(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
    const glm::dvec2 ab = b - a, ac = c - a;
    const double area2 = cross(ab, ac);
    const double length2 = std::max(glm::dot(ab, ab), glm::dot(ac, ac));
    // Flatter than this, the radius is more than a million times the points' distance.
    if (!(std::abs(area2) > 1e-6 * length2)) return std::nullopt;
    const double bb = glm::dot(ab, ab), cc = glm::dot(ac, ac);
    const glm::dvec2 to_centre =
        glm::dvec2(ac.y * bb - ab.y * cc, ab.x * cc - ac.x * bb) / (2 * area2);
    return Circle{a + to_centre, glm::length(to_centre)};
}

glm::dvec2 turned(const Circle& circle, glm::dvec2 p, double angle) {
    const glm::dvec2 v = p - circle.centre;
    const double c = std::cos(angle), s = std::sin(angle);
    return circle.centre + glm::dvec2(c * v.x - s * v.y, s * v.x + c * v.y);
}

double angle_between(const Circle& circle, glm::dvec2 a, glm::dvec2 b) {
    const glm::dvec2 u = a - circle.centre, v = b - circle.centre;
    return std::atan2(cross(u, v), glm::dot(u, v));
}

}  // namespace povpreview
