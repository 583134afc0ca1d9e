// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "backend/oracle/point.h"

/// Convex polygons and convex cells of space, cut by planes.
namespace povpreview::tracer {

/// The points p with dot(normal, p) = offset; `normal` has length 1.
struct Plane {
    Point normal;
    double offset = 0;

    /// Distance in front of the plane, in units of the scene.
    double distance(const Point& p) const { return dot(normal, p) - offset; }
    /// A point no farther from the plane counts as on it: far above what rounding does to points
    /// that were transformed and cut, and below what a scene means. Relative, as both are.
    double tolerance(const Point& p) const {
        return 1e-9 * (largest_coordinate(p) + std::fabs(offset));
    }
    Plane flipped() const { return {-1.0 * normal, -offset}; }
};

/// Corners in order around; flat and convex up to rounding.
using ConvexPolygon = std::vector<Point>;

/// Twice the area, perpendicular to the polygon, on the side from which it runs anticlockwise in a
/// right-handed system (Newell's method).
Point area_normal(const ConvexPolygon& polygon);

/// The plane through a polygon; its normal is zero if the polygon has no area.
Plane plane_of(const ConvexPolygon& polygon);

/// A point inside the polygon, in no special position: it lies on lines between corners, or on
/// planes that bisect the polygon, by chance only.
Point inner_point(const ConvexPolygon& polygon);

/// Where a polygon lies with respect to a plane.
enum class Side { behind, in_front, on, both };
Side side_of(const ConvexPolygon& polygon, const Plane& plane);

/// Cuts a polygon that lies on both sides of the plane.
struct Halves {
    ConvexPolygon behind, in_front;
};
Halves cut(const ConvexPolygon& polygon, const Plane& plane);

/// An axis-parallel box around something; reaches to infinity unless bounded.
struct Extent {
    bool bounded = false;
    Point low, high;

    static Extent around(const std::vector<Point>& points);
    void include(const Point& p);
    /// Apart by more than rounding.
    bool apart(const Extent& other) const;
    bool apart(const Point& p) const;
};

/// The points behind all of the planes.
struct ConvexCell {
    std::vector<Plane> planes;
    Extent extent;
};

/// The cell that faces enclose, whichever way round they run; without planes if it is flat.
ConvexCell cell_within(const std::vector<ConvexPolygon>& faces);

}  // namespace povpreview::tracer
