// SPDX-License-Identifier: AGPL-3.0-or-later
#include "backend/oracle/convex.h"

namespace povpreview::tracer {

Point area_normal(const ConvexPolygon& polygon) {
    // Relative to the first corner, so that far from the origin no digits are lost.
    Point sum;
    for (std::size_t i = 2; i < polygon.size(); ++i)
        sum = sum + cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
    return sum;
}

Plane plane_of(const ConvexPolygon& polygon) {
    const Point area = area_normal(polygon);
    const double size = length(area);
    if (!(size > 0)) return {};
    const Point normal = (1 / size) * area;
    double offset = 0;
    for (const Point& corner : polygon) offset += dot(normal, corner);
    return {normal, offset / static_cast<double>(polygon.size())};
}

Point inner_point(const ConvexPolygon& polygon) {
    Point sum;
    double weights = 0;
    // Multiples of the golden ratio, modulo 1, are as irregular as numbers get.
    double fraction = 0.5;
    for (const Point& corner : polygon) {
        fraction = std::fmod(fraction + 0.6180339887498949, 1.0);
        const double weight = 1 + 0.3 * fraction;
        sum = sum + weight * corner;
        weights += weight;
    }
    return (1 / weights) * sum;
}

Side side_of(const ConvexPolygon& polygon, const Plane& plane) {
    bool behind = false, in_front = false;
    for (const Point& corner : polygon) {
        const double distance = plane.distance(corner), tolerance = plane.tolerance(corner);
        behind = behind || distance < -tolerance;
        in_front = in_front || distance > tolerance;
    }
    if (behind && in_front) return Side::both;
    return behind ? Side::behind : in_front ? Side::in_front : Side::on;
}

Halves cut(const ConvexPolygon& polygon, const Plane& plane) {
    Halves halves;
    const std::size_t n = polygon.size();
    const auto side = [&plane](const Point& p) {
        const double distance = plane.distance(p), tolerance = plane.tolerance(p);
        return distance < -tolerance ? -1 : distance > tolerance ? 1 : 0;
    };
    for (std::size_t i = 0; i < n; ++i) {
        const Point &a = polygon[i], &b = polygon[(i + 1) % n];
        const int side_a = side(a), side_b = side(b);
        if (side_a <= 0) halves.behind.push_back(a);
        if (side_a >= 0) halves.in_front.push_back(a);
        if (side_a * side_b >= 0) continue;
        // Always from behind to front, so that neighbours that share the edge get the same point.
        const Point &from = side_a < 0 ? a : b, &to = side_a < 0 ? b : a;
        const double d = plane.distance(from), e = plane.distance(to);
        const Point crossing = from + (d / (d - e)) * (to - from);
        halves.behind.push_back(crossing);
        halves.in_front.push_back(crossing);
    }
    return halves;
}

Extent Extent::around(const std::vector<Point>& points) {
    Extent extent;
    for (const Point& p : points) extent.include(p);
    return extent;
}

void Extent::include(const Point& p) {
    if (!bounded) {
        bounded = true;
        low = high = p;
        return;
    }
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
}

bool Extent::apart(const Extent& other) const {
    if (!bounded || !other.bounded) return false;
    const double margin = 1e-9 * (largest_coordinate(low) + largest_coordinate(high));
    return low.x > other.high.x + margin || other.low.x > high.x + margin ||
           low.y > other.high.y + margin || other.low.y > high.y + margin ||
           low.z > other.high.z + margin || other.low.z > high.z + margin;
}

bool Extent::apart(const Point& p) const { return apart(Extent{true, p, p}); }

ConvexCell cell_within(const std::vector<ConvexPolygon>& faces) {
    ConvexCell cell;
    Point middle;
    for (const ConvexPolygon& face : faces) {
        for (const Point& corner : face) cell.extent.include(corner);
        middle = middle + (1.0 / static_cast<double>(faces.size())) * inner_point(face);
    }
    for (const ConvexPolygon& face : faces) {
        const Plane plane = plane_of(face);
        if (plane.normal == Point{}) continue;
        const double distance = plane.distance(middle);
        if (std::fabs(distance) <= plane.tolerance(middle)) return {};
        cell.planes.push_back(distance < 0 ? plane : plane.flipped());
    }
    return cell;
}

}  // namespace povpreview::tracer
