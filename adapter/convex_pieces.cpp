// SPDX-License-Identifier: AGPL-3.0-or-later
#include "adapter/convex_pieces.h"

// Rings that cross are rare, and then few: the advice to keep track of crossings is for others.
#define CGAL_NO_CDT_2_WARNING
#include <CGAL/Constrained_triangulation_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>
#include <optional>

namespace povpreview {
namespace {

/// Crossings are constructed exactly: rounded ones may lie on the wrong side of a third side.
using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Point2 = Kernel::Point_2;

constexpr std::uint32_t none = ~std::uint32_t{0};
struct VertexInfo {
    std::uint32_t point = none;
};
struct FaceInfo {
    int surrounded = -1;  ///< by how many rings, modulo 2; -1: not known yet
    std::uint32_t piece = none;
};
using Vertices = CGAL::Triangulation_vertex_base_with_info_2<VertexInfo, Kernel>;
using Faces = CGAL::Constrained_triangulation_face_base_2<
    Kernel, CGAL::Triangulation_face_base_with_info_2<FaceInfo, Kernel>>;
// Not Delaunay: that breaks ties by addresses in memory, and the same scene would have other faces.
using Triangulation =
    CGAL::Constrained_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertices, Faces>,
                                      CGAL::Exact_intersections_tag>;
using Edge = Triangulation::Edge;
using FaceHandle = Triangulation::Face_handle;

/// A plane of the polygon, seen along the axis to which its normal is closest.
struct Projection {
    int u, v, w;
    glm::dvec3 normal, origin;

    Point2 flat(const glm::dvec3& p) const { return {p[u], p[v]}; }
    glm::dvec3 lifted(const Point2& p) const {
        glm::dvec3 result;
        result[u] = CGAL::to_double(p.x());
        result[v] = CGAL::to_double(p.y());
        result[w] =
            origin[w] -
            (normal[u] * (result[u] - origin[u]) + normal[v] * (result[v] - origin[v])) / normal[w];
        return result;
    }
};

/// By the triangle of a first point, the one farthest from it, and the one farthest from their
/// line: the rings may wind any way, so their areas may cancel out.
std::optional<Projection> projection(const std::vector<IndexRing>& rings,
                                     const std::vector<glm::dvec3>& points) {
    const auto size2 = [](const glm::dvec3& v) { return glm::dot(v, v); };
    if (rings.empty() || rings.front().empty()) return std::nullopt;
    const glm::dvec3 origin = points[rings.front().front()];
    glm::dvec3 axis(0), normal(0);
    for (const IndexRing& ring : rings)
        for (const std::uint32_t i : ring)
            if (size2(points[i] - origin) > size2(axis)) axis = points[i] - origin;
    for (const IndexRing& ring : rings)
        for (const std::uint32_t i : ring) {
            const glm::dvec3 area = glm::cross(axis, points[i] - origin);
            if (size2(area) > size2(normal)) normal = area;
        }
    constexpr double thinnest = 1e-12;  // width of a polygon relative to its length
    const double size = std::sqrt(size2(normal));
    if (!(size > thinnest * size2(axis)) || !std::isfinite(size)) return std::nullopt;
    const glm::dvec3 a = glm::abs(normal);
    const int w = a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
    return Projection{(w + 1) % 3, (w + 2) % 3, w, normal, origin};
}

/// One that turns always the same way, and once around.
bool is_convex(const IndexRing& ring, const std::vector<glm::dvec3>& points,
               const Projection& projection) {
    const std::size_t n = ring.size();
    const auto flat = [&](std::size_t i) { return projection.flat(points[ring[i % n]]); };
    bool left = false, right = false;
    int turns_of_direction = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const Point2 a = flat(i), b = flat(i + 1), c = flat(i + 2);
        if (a == b) return false;
        const CGAL::Orientation turn = CGAL::orientation(a, b, c);
        left = left || turn == CGAL::LEFT_TURN;
        right = right || turn == CGAL::RIGHT_TURN;
        turns_of_direction += (a < b) != (b < c);
    }
    return left != right && turns_of_direction == 2;
}

using Vertex = Triangulation::Vertex_handle;
struct Side {
    Vertex from, to;
};

std::vector<Side> insert_sides(const std::vector<IndexRing>& rings,
                               const std::vector<glm::dvec3>& points, const Projection& plane,
                               Triangulation& triangulation) {
    std::vector<Side> sides;
    for (const IndexRing& ring : rings) {
        const std::size_t first = sides.size();
        for (const std::uint32_t i : ring) {
            const Vertex vertex = triangulation.insert(plane.flat(points[i]));
            vertex->info().point = i;
            if (sides.size() > first) sides.back().to = vertex;
            sides.push_back({vertex, vertex});
        }
        if (sides.size() > first) sides.back().to = sides[first].from;
    }
    std::erase_if(sides, [](const Side& side) { return side.from == side.to; });
    for (const Side& side : sides) triangulation.insert_constraint(side.from, side.to);
    return sides;
}

/// Whether no two sides cross, touch but for their ends, or run along each other.
bool are_simple(const std::vector<Side>& sides, const Triangulation& triangulation) {
    std::size_t constrained = 0;
    for (const Edge& edge : triangulation.finite_edges())
        constrained += triangulation.is_constrained(edge);
    return constrained == sides.size() &&
           std::all_of(sides.begin(), sides.end(),
                       [&](const Side& side) { return triangulation.is_edge(side.from, side.to); });
}

/// From outside inwards, each side a border. REQUIRES: are_simple().
void mark_by_borders(const Triangulation& triangulation) {
    std::vector<FaceHandle> waiting{triangulation.infinite_face()};
    waiting.front()->info().surrounded = 0;
    while (!waiting.empty()) {
        const FaceHandle face = waiting.back();
        waiting.pop_back();
        for (int i = 0; i < 3; ++i) {
            const FaceHandle next = face->neighbor(i);
            if (next->info().surrounded >= 0) continue;
            next->info().surrounded =
                face->info().surrounded ^ static_cast<int>(triangulation.is_constrained({face, i}));
            waiting.push_back(next);
        }
    }
}

/// Each triangle by itself, by the sides that a line from its middle crosses: a border along which
/// several sides run counts as often as they do.
void mark_by_crossings(const std::vector<Side>& sides, const Triangulation& triangulation) {
    for (const FaceHandle face : triangulation.finite_face_handles()) {
        const Point2 middle = CGAL::centroid(face->vertex(0)->point(), face->vertex(1)->point(),
                                             face->vertex(2)->point());
        bool odd = false;
        for (const Side& side : sides) {
            const Point2 &a = side.from->point(), &b = side.to->point();
            if ((a.y() > middle.y()) != (b.y() > middle.y()) &&
                middle.x() < a.x() + (middle.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
                odd = !odd;
        }
        face->info().surrounded = odd;
    }
}

/// Triangles merged into convex pieces across every edge that is not needed for that (Hertel and
/// Mehlhorn 1983).
class Pieces {
   public:
    explicit Pieces(const Triangulation& triangulation) : triangulation_(triangulation) {
        for (const FaceHandle face : triangulation.finite_face_handles()) {
            if (face->info().surrounded != 1) continue;
            face->info().piece = static_cast<std::uint32_t>(loops_.size());
            loops_.push_back({face->vertex(0), face->vertex(1), face->vertex(2)});
        }
        part_of_.resize(loops_.size());
        std::iota(part_of_.begin(), part_of_.end(), 0U);
    }

    void merge() {
        for (const Edge& edge : triangulation_.finite_edges()) {
            const std::uint32_t a = edge.first->info().piece,
                                b = edge.first->neighbor(edge.second)->info().piece;
            if (a != none && b != none)
                merge(root(a), root(b), edge.first->vertex(Triangulation::ccw(edge.second)),
                      edge.first->vertex(Triangulation::cw(edge.second)));
        }
    }

    std::vector<IndexRing> rings() const {
        std::vector<IndexRing> result;
        for (const Loop& loop : loops_) {
            if (loop.empty()) continue;
            result.emplace_back();
            for (const Vertex vertex : loop) result.back().push_back(vertex->info().point);
        }
        return result;
    }

   private:
    using Loop = std::vector<Vertex>;

    std::uint32_t root(std::uint32_t piece) {
        while (part_of_[piece] != piece) piece = part_of_[piece] = part_of_[part_of_[piece]];
        return piece;
    }

    static bool turns_left(Vertex a, Vertex b, Vertex c) {
        const CGAL::Orientation turn = CGAL::orientation(a->point(), b->point(), c->point());
        return turn == CGAL::LEFT_TURN ||
               (turn == CGAL::COLLINEAR && CGAL::collinear_are_strictly_ordered_along_line(
                                               a->point(), b->point(), c->point()));
    }

    /// Two pieces on either side of an edge, `a` running from `u` to `v`.
    void merge(std::uint32_t a, std::uint32_t b, Vertex u, Vertex v) {
        if (a == b) return;
        Loop &left = loops_[a], &right = loops_[b];
        std::rotate(left.begin(), std::find(left.begin(), left.end(), v), left.end());
        std::rotate(right.begin(), std::find(right.begin(), right.end(), u), right.end());
        // left = v ... u, right = u ... v
        if (left.back() != u || right.back() != v) return;
        if (!turns_left(left[left.size() - 2], u, right[1]) ||
            !turns_left(right[right.size() - 2], v, left[1]))
            return;
        left.insert(left.end(), right.begin() + 1, right.end() - 1);
        right.clear();
        part_of_[b] = a;
    }

    const Triangulation& triangulation_;
    std::vector<Loop> loops_;
    std::vector<std::uint32_t> part_of_;
};

}  // namespace

std::vector<IndexRing> convex_pieces(const std::vector<IndexRing>& rings,
                                     std::vector<glm::dvec3>& points) {
    for (const IndexRing& ring : rings)
        for (const std::uint32_t i : ring)
            if (!std::isfinite(points[i].x + points[i].y + points[i].z)) return {};
    const std::optional<Projection> plane = projection(rings, points);
    if (!plane) return {};
    if (rings.size() == 1 && is_convex(rings.front(), points, *plane)) return rings;

    Triangulation triangulation;
    const std::vector<Side> sides = insert_sides(rings, points, *plane, triangulation);
    if (triangulation.dimension() < 2) return {};
    for (const auto vertex : triangulation.finite_vertex_handles()) {
        if (vertex->info().point != none) continue;
        vertex->info().point = static_cast<std::uint32_t>(points.size());
        points.push_back(plane->lifted(vertex->point()));
    }
    if (are_simple(sides, triangulation))
        mark_by_borders(triangulation);
    else
        mark_by_crossings(sides, triangulation);
    Pieces pieces(triangulation);
    pieces.merge();
    return pieces.rings();
}

}  // namespace povpreview
