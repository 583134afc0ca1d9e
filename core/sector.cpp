// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/sector.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "core/predicates.h"

namespace povpreview {

void find_sectors(const std::vector<Triangulation::Spoke>& fan, std::vector<Sector>& sectors) {
    sectors.clear();
    const std::size_t n = fan.size();
    const bool border = !fan.back().face;
    std::size_t constraints = 0, start = 0;
    for (std::size_t i = n; i-- > 0;)
        if (fan[i].constrained) ++constraints, start = i;
    if (border) {
        // The border bounds the first and the last sector, whether it is constrained or not.
        std::size_t first = 0;
        for (std::size_t i = 1; i < n; ++i)
            if (fan[i].constrained || i + 1 == n) {
                sectors.push_back({first, i - first, false});
                first = i;
            }
        return;
    }
    if (constraints <= 1) {
        sectors.push_back({start, n, true});
        return;
    }
    std::size_t first = start;
    for (std::size_t step = 1; step <= n; ++step) {
        const std::size_t i = (start + step) % n;
        if (!fan[i].constrained) continue;
        sectors.push_back({first, start + step - first, false});
        first = i;
    }
}

Wedge::Wedge(glm::dvec2 from, glm::dvec2 first, glm::dvec2 last, bool all_around)
    : centre(from),
      start(first),
      end(last),
      whole(all_around),
      turn(all_around ? 0 : orientation(from, first, last)) {}

bool Wedge::contains(glm::dvec2 p) const {
    if (whole) return true;
    const bool after_start = orientation(centre, start, p) > 0;
    if (turn == 0) return after_start;  // a half plane
    // Less than that or more.
    if (after_start != (turn > 0)) return after_start;
    return orientation(centre, p, end) > 0;
}

bool Wedge::along(glm::dvec2 ray, glm::dvec2 p) const {
    return orientation(centre, ray, p) == 0 && glm::dot(ray - centre, p - centre) > 0;
}

double Wedge::clearance(glm::dvec2 p) const {
    if (whole) return 0;
    const glm::dvec2 way = p - centre;
    const auto distance = [&](glm::dvec2 ray) {
        const glm::dvec2 u = glm::normalize(ray - centre);
        const double ahead = glm::dot(u, way);
        return glm::length(ahead > 0 ? way - ahead * u : way);
    };
    return std::min(distance(start), distance(end));
}

double Wedge::angle() const {
    if (whole) return 2 * std::numbers::pi;
    const glm::dvec2 u = start - centre, v = end - centre;
    const double angle = std::atan2(u.x * v.y - u.y * v.x, glm::dot(u, v));
    if (turn == 0) return std::numbers::pi;
    return turn > 0 ? std::abs(angle) : 2 * std::numbers::pi - std::abs(angle);
}

glm::dvec2 Wedge::bisector() const {
    const glm::dvec2 u = glm::normalize(start - centre);
    const double half = angle() / 2, c = std::cos(half), s = std::sin(half);
    return {c * u.x - s * u.y, s * u.x + c * u.y};
}

}  // namespace povpreview
