// SPDX-License-Identifier: AGPL-3.0-or-later
#include "backend/oracle/flat_faces.h"

// The order of POV-Ray's headers matters: frame.h first, povdebug.h last.
// clang-format off
#include "backend/frame.h"
#include "backend/scene/objects.h"
#include "backend/shape/boxes.h"
#include "backend/shape/discs.h"
#include "backend/shape/planes.h"
#include "backend/shape/polygon.h"
#include "backend/shape/prism.h"
// clang-format on

#include "backend/oracle/even_odd.h"
#include "backend/oracle/prism_parts.h"
#include "backend/oracle/transform.h"
#include "base/povdebug.h"

namespace povpreview::tracer {

namespace {

/// The outline of a disc of n corners, half inside and half outside, is off by r/4 (pi/n)^2: a
/// seventh of a pixel where the radius is a thousand.
constexpr int disc_corners = 128;

constexpr double pi = 3.14159265358979323846;

std::uint32_t size32(std::size_t size) { return static_cast<std::uint32_t>(size); }

}  // namespace

// ---- box

const char* add_faces(const pov::Box& box, const FaceLimits&, ObjectFaces& faces) {
    // Corner i has the upper bound in x, y, z where bit 0, 1, 2 is set.
    for (int i = 0; i < 8; ++i)
        faces.points.push_back(to_world(
            box.Trans, {box.bounds[i & 1][0], box.bounds[i >> 1 & 1][1], box.bounds[i >> 2][2]}));
    // In the order of POV-Ray's SIDE_X_0 = 1, SIDE_X_1, SIDE_Y_0 ...
    const std::uint32_t sides[6][4] = {{0, 2, 6, 4}, {1, 5, 7, 3}, {0, 4, 5, 1},
                                       {2, 3, 7, 6}, {0, 1, 3, 2}, {4, 6, 7, 5}};
    for (int side = 0; side < 6; ++side) {
        faces.add_face({side + 1, 0});
        faces.add_ring({sides[side], sides[side] + 4});
    }
    return nullptr;
}

// ---- polygon

const char* add_faces(const pov::Polygon& polygon, const FaceLimits&, ObjectFaces& faces) {
    if (Test_Flag(&polygon, DEGENERATE_FLAG)) return nullptr;
    const pov::POLYGON_DATA& data = *polygon.Data;
    faces.add_face().convex = false;
    // A ring ends where its first point comes again; the next point begins another.
    for (int first = 0; first < data.Number;) {
        std::vector<std::uint32_t> ring;
        int i = first;
        do {
            ring.push_back(size32(faces.points.size()));
            faces.points.push_back(
                to_world(polygon.Trans, {data.Points[i][0], data.Points[i][1], 0}));
            ++i;
        } while (i < data.Number && (data.Points[i][0] != data.Points[first][0] ||
                                     data.Points[i][1] != data.Points[first][1]));
        if (ring.size() >= 3) faces.add_ring(ring);
        first = i + 1;
    }
    if (faces.faces.back().rings == 0) faces.faces.pop_back();
    return nullptr;
}

// ---- prism

namespace {

/// The rings of a prism's base, as it is at height 1 in a conic sweep. Corner j of all rings
/// together begins segment j.
std::vector<Ring> base_rings(const pov::Prism& prism) {
    std::vector<Ring> rings;
    bool open = false;
    for (int j = 0; j < prism.Number; ++j) {
        const pov::PRISM_SPLINE_ENTRY& entry = prism.Spline->Entry[j];
        if (!open) rings.emplace_back();
        rings.back().push_back({entry.D[0], entry.D[1]});
        const Point2 &first = rings.back().front(),
                     end{entry.C[0] + entry.D[0], entry.C[1] + entry.D[1]};
        // As POV-Ray's Compute_Prism finds the end of a ring.
        open = std::fabs(end.u - first.u) >= EPSILON || std::fabs(end.v - first.v) >= EPSILON;
    }
    return rings;
}

Point on_prism(const pov::Prism& prism, const Point2& p, double height) {
    const double scale = prism.Sweep_Type == CONIC_SWEEP ? height : 1;
    return to_world(prism.Trans, {scale * p.u, height, scale * p.v});
}

/// Heights between which the sides of the prism are flat: a double cone has its apex at 0.
std::vector<double> heights_of(const pov::Prism& prism) {
    if (prism.Sweep_Type == CONIC_SWEEP && prism.Height1 < 0 && prism.Height2 > 0)
        return {prism.Height1, 0, prism.Height2};
    return {prism.Height1, prism.Height2};
}

void add_side(const std::vector<std::uint32_t>& corners, int segment, ObjectFaces& faces) {
    std::vector<std::uint32_t> distinct;
    for (const std::uint32_t corner : corners) {
        const auto same = [&](std::uint32_t other) {
            return faces.points[other] == faces.points[corner];
        };
        if (distinct.empty() || (!same(distinct.back()) && !same(distinct.front())))
            distinct.push_back(corner);
    }
    if (distinct.size() < 3) return;
    faces.add_face({spline_hit, segment});
    faces.add_ring(distinct);
}

}  // namespace

const char* add_faces(const pov::Prism& prism, const FaceLimits& limits, ObjectFaces& faces) {
    if (prism.Spline_Type != LINEAR_SPLINE) return "curved";
    if (Test_Flag(&prism, DEGENERATE_FLAG)) return nullptr;
    if (static_cast<std::size_t>(prism.Number) > limits.max_faces / 4) return "too many faces";
    const std::vector<Ring> rings = base_rings(prism);
    const std::vector<double> heights = heights_of(prism);
    const bool conic = prism.Sweep_Type == CONIC_SWEEP;

    // Points of level l, then of level l + 1 ..., in the order of the rings.
    std::uint32_t level_size = 0;
    for (const Ring& ring : rings) level_size += size32(ring.size());
    for (const double height : heights)
        for (const Ring& ring : rings)
            for (const Point2& p : ring) faces.points.push_back(on_prism(prism, p, height));

    for (std::uint32_t level = 0; level + 1 < heights.size(); ++level) {
        std::uint32_t first = level * level_size;
        for (const Ring& ring : rings) {
            const std::uint32_t n = size32(ring.size());
            for (std::uint32_t i = 0; i < n; ++i) {
                const std::uint32_t a = first + i, b = first + (i + 1) % n;
                add_side({a, b, b + level_size, a + level_size},
                         static_cast<int>(a - level * level_size), faces);
            }
            first += n;
        }
    }
    if (!Test_Flag(&prism, CLOSED_FLAG)) return nullptr;
    const std::uint32_t top = size32(heights.size() - 1) * level_size;
    for (const auto& [height, number, start] :
         {std::tuple(heights.front(), base_hit, std::uint32_t{0}),
          std::tuple(heights.back(), cap_hit, top)}) {
        if (conic && std::fabs(height) <= EPSILON) continue;
        faces.add_face({number, 0}).convex = false;
        std::uint32_t next = start;
        for (const Ring& ring : rings) {
            std::vector<std::uint32_t> indices;
            for (std::size_t i = 0; i < ring.size(); ++i) indices.push_back(next++);
            if (ring.size() >= 3) faces.add_ring(indices);
        }
        if (faces.faces.back().rings == 0) faces.faces.pop_back();
    }
    return nullptr;
}

std::vector<ConvexCell> cells_of(const pov::Prism& prism) {
    std::vector<ConvexCell> cells;
    const std::vector<double> heights = heights_of(prism);
    for (const Ring& piece : trapezoids(base_rings(prism)))
        for (std::size_t level = 0; level + 1 < heights.size(); ++level) {
            ConvexPolygon low, high;
            for (const Point2& p : piece) {
                low.push_back(on_prism(prism, p, heights[level]));
                high.push_back(on_prism(prism, p, heights[level + 1]));
            }
            std::vector<ConvexPolygon> sides{low, high};
            for (std::size_t i = 0; i < low.size(); ++i) {
                const std::size_t next = (i + 1) % low.size();
                sides.push_back({low[i], low[next], high[next], high[i]});
            }
            cells.push_back(cell_within(sides));
        }
    return cells;
}

// ---- disc

namespace {

/// Such that a polygon of that circumradius is as far outside the circle at its corners as it is
/// inside it at the middles of its sides.
double polygon_radius(double squared_radius) {
    return std::sqrt(squared_radius) * 2 / (1 + std::cos(pi / disc_corners));
}

ConvexPolygon circle(const pov::Disc& disc, double radius) {
    ConvexPolygon corners;
    for (int i = 0; i < disc_corners; ++i) {
        const double angle = 2 * pi * i / disc_corners;
        corners.push_back(
            to_world(disc.Trans, {radius * std::cos(angle), radius * std::sin(angle), 0}));
    }
    return corners;
}

}  // namespace

const char* add_faces(const pov::Disc& disc, const FaceLimits&, ObjectFaces& faces) {
    const ConvexPolygon outer = circle(disc, polygon_radius(disc.oradius2));
    if (!(disc.iradius2 > 0)) {
        faces.add_polygon(outer);
        return nullptr;
    }
    faces.points = outer;
    const ConvexPolygon inner = circle(disc, polygon_radius(disc.iradius2));
    faces.points.insert(faces.points.end(), inner.begin(), inner.end());
    for (std::uint32_t i = 0; i < disc_corners; ++i) {
        const std::uint32_t next = (i + 1) % disc_corners;
        faces.add_face();
        faces.add_ring({i, next, next + disc_corners, i + disc_corners});
    }
    return nullptr;
}

std::vector<ConvexCell> cells_of(const pov::Disc& disc) {
    return {ConvexCell{{plane_to_world(disc.Trans, {0, 0, 1}, 0)}, {}}};
}

// ---- plane

namespace {

Plane world_plane(const pov::Plane& plane) {
    const auto& n = plane.Normal_Vector;
    return plane_to_world(plane.Trans, {n[0], n[1], n[2]}, plane.Distance);
}

}  // namespace

const char* add_faces(const pov::Plane& object, const FaceLimits& limits, ObjectFaces& faces) {
    const Plane plane = world_plane(object);
    const double distance = plane.distance(limits.middle);
    if (plane.normal == Point{} || !(std::fabs(distance) < limits.reach)) return nullptr;
    const Point foot = limits.middle - distance * plane.normal;
    // Along the axes of the world where it can be.
    const Point &n = plane.normal, axis = std::fabs(n.x) < 0.9 && std::fabs(n.x) <= std::fabs(n.z)
                                              ? Point{1, 0, 0}
                                          : std::fabs(n.z) < 0.9 ? Point{0, 0, 1}
                                                                 : Point{0, 1, 0};
    Point u = cross(cross(n, axis), n);
    u = (limits.reach / length(u)) * u;
    const Point v = cross(n, u);
    faces.add_polygon({foot - u - v, foot + u - v, foot + u + v, foot - u + v});
    return nullptr;
}

std::vector<ConvexCell> cells_of(const pov::Plane& plane) {
    return {ConvexCell{{world_plane(plane)}, {}}};
}

}  // namespace povpreview::tracer
