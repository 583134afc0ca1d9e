// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Polygons with several rings, cut into convex pieces, by the tracer (trapezoids) and by the
// previewer (convex_pieces): the pieces are convex, and a point is in exactly one of them if an odd
// number of rings surround it, in none otherwise.
#include "backend/oracle/even_odd.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <random>

#include "adapter/convex_pieces.h"

namespace povpreview {
namespace {

using tracer::Point2;
using tracer::Ring;

/// The sides of the rings that a ray to the right crosses.
bool surrounded(const std::vector<Ring>& rings, const Point2& p) {
    bool odd = false;
    for (const Ring& ring : rings)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
            if ((a.v > p.v) != (b.v > p.v) && p.u < a.u + (p.v - a.v) / (b.v - a.v) * (b.u - a.u))
                odd = !odd;
        }
    return odd;
}

double twice_area(const Point2& a, const Point2& b, const Point2& c) {
    return (b.u - a.u) * (c.v - a.v) - (b.v - a.v) * (c.u - a.u);
}

bool inside_convex(const Ring& ring, const Point2& p) {
    bool left = false, right = false;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
        // Crossings of three sides in one point may be two corners, apart by rounding.
        if (std::hypot(b.u - a.u, b.v - a.v) < 1e-12) continue;
        const double side = twice_area(a, b, p);
        left = left || side > 0;
        right = right || side < 0;
    }
    return left != right;
}

void expect_convex(const Ring& ring) {
    bool left = false, right = false;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const double turn =
            twice_area(ring[i], ring[(i + 1) % ring.size()], ring[(i + 2) % ring.size()]);
        left = left || turn > 1e-9;
        right = right || turn < -1e-9;
    }
    EXPECT_FALSE(left && right) << "a piece is not convex";
}

struct Shape {
    const char* name;
    std::vector<Ring> rings;
};

Ring circle(double u, double v, double radius, int corners, int step = 1) {
    Ring ring;
    for (int i = 0; i < corners; ++i) {
        const double angle = 6.283185307179586 * i * step / corners + .1;
        ring.push_back({u + radius * std::cos(angle), v + radius * std::sin(angle)});
    }
    return ring;
}

std::vector<Shape> shapes() {
    return {
        {"square", {{{0, 0}, {4, 0}, {4, 4}, {0, 4}}}},
        {"clockwise", {{{0, 4}, {4, 4}, {4, 0}, {0, 0}}}},
        {"L", {{{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 4}, {0, 4}}}},
        {"hole", {circle(2, 2, 2, 12), circle(2, 2, 1, 7)}},
        {"hole the same way round and an island",
         {circle(2, 2, 2, 12), circle(2, 2, 1.5, 9), circle(2, 2, .7, 5)}},
        {"star that crosses itself", {circle(2, 2, 2, 5, 2)}},
        {"crossing rings", {circle(1.5, 2, 1.4, 17), circle(2.5, 2, 1.4, 16)}},
        {"squares that share a side",
         {{{0, 0}, {2, 0}, {2, 2}, {0, 2}}, {{2, 0}, {4, 0}, {4, 2}, {2, 2}}}},
        {"hole that touches the outline",
         {{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{0, 1}, {2, 1}, {2, 3}, {0, 3}}}},
        {"hole in a corner, along part of two sides",
         {{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{0, 0}, {1, 0}, {1, 1}, {0, 1}}}},
        {"the same ring twice is empty", {circle(2, 2, 2, 6), circle(2, 2, 2, 6)}},
        {"three times is full", {circle(2, 2, 2, 6), circle(2, 2, 2, 6), circle(2, 2, 2, 6)}},
        {"keyhole: a ring that runs over itself",
         {{{0, 0},
           {4, 0},
           {4, 4},
           {0, 4},
           {0, 2},
           {1, 2},
           {1, 3},
           {3, 3},
           {3, 1},
           {1, 1},
           {1, 2},
           {0, 2}}}},
        {"repeated points", {{{0, 0}, {0, 0}, {4, 0}, {4, 0}, {4, 4}, {2, 4}, {2, 4}, {0, 4}}}},
        {"a spike without area", {{{0, 0}, {2, 0}, {2, 3}, {2, 0}, {4, 0}, {4, 2}, {0, 2}}}},
        {"bow tie", {{{0, 0}, {4, 3}, {4, 0}, {0, 3}}}},
    };
}

Ring random_ring(std::mt19937& random, bool on_grid) {
    Ring ring;
    const int corners = 3 + static_cast<int>(random() % 9);
    for (int i = 0; i < corners; ++i) {
        if (on_grid)
            ring.push_back({double(random() % 5), double(random() % 5)});
        else
            ring.push_back({std::uniform_real_distribution<>(0, 4)(random),
                            std::uniform_real_distribution<>(0, 4)(random)});
    }
    return ring;
}

/// `pieces` against `rings` at points by chance, none of them nearly on a side.
void expect_even_odd(const std::vector<Ring>& rings, const std::vector<Ring>& pieces,
                     std::mt19937& random) {
    for (const Ring& piece : pieces) expect_convex(piece);
    for (int i = 0; i < 300; ++i) {
        const Point2 p{std::uniform_real_distribution<>(-.5, 4.5)(random),
                       std::uniform_real_distribution<>(-.5, 4.5)(random)};
        const auto in = std::count_if(pieces.begin(), pieces.end(),
                                      [&](const Ring& piece) { return inside_convex(piece, p); });
        ASSERT_EQ(in, surrounded(rings, p) ? 1 : 0) << "at " << p.u << ", " << p.v;
    }
}

/// What convex_pieces makes of the rings in a tilted plane, flattened again.
std::vector<Ring> by_previewer(const std::vector<Ring>& rings) {
    const glm::dvec3 origin(1, -2, 3), u = glm::normalize(glm::dvec3(1, 2, -.5)),
                                       v = glm::normalize(glm::cross(u, glm::dvec3(.3, -.4, 1)));
    std::vector<glm::dvec3> points;
    std::vector<IndexRing> indices;
    for (const Ring& ring : rings) {
        indices.emplace_back();
        for (const Point2& p : ring) {
            indices.back().push_back(static_cast<std::uint32_t>(points.size()));
            points.push_back(origin + p.u * u + p.v * v);
        }
    }
    std::vector<Ring> flat;
    for (const IndexRing& piece : convex_pieces(indices, points)) {
        flat.emplace_back();
        for (const std::uint32_t i : piece) {
            const glm::dvec3 p = points.at(i) - origin;
            EXPECT_NEAR(glm::dot(p, glm::cross(u, v)), 0, 1e-9) << "off the plane";
            flat.back().push_back({glm::dot(p, u), glm::dot(p, v)});
        }
    }
    return flat;
}

TEST(EvenOdd, ShapesAreCutIntoConvexPieces) {
    std::mt19937 random(1);
    for (const Shape& shape : shapes()) {
        SCOPED_TRACE(shape.name);
        {
            SCOPED_TRACE("trapezoids");
            expect_even_odd(shape.rings, tracer::trapezoids(shape.rings), random);
        }
        SCOPED_TRACE("convex_pieces");
        expect_even_odd(shape.rings, by_previewer(shape.rings), random);
    }
}

TEST(EvenOdd, RandomRingsAreCutIntoConvexPieces) {
    constexpr unsigned seed = 2;
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    for (int round = 0; round < 300 && !testing::Test::HasFailure(); ++round) {
        SCOPED_TRACE(testing::Message() << "round " << round);
        std::vector<Ring> rings;
        for (unsigned i = 0; i <= random() % 3; ++i)
            rings.push_back(random_ring(random, round % 2 == 0));
        {
            SCOPED_TRACE("trapezoids");
            expect_even_odd(rings, tracer::trapezoids(rings), random);
        }
        SCOPED_TRACE("convex_pieces");
        expect_even_odd(rings, by_previewer(rings), random);
    }
}

TEST(EvenOdd, AConvexPolygonStaysAsItIs) {
    std::vector<glm::dvec3> points{{0, 0, 1}, {2, 0, 1}, {3, 2, 1}, {1, 3, 1}, {-1, 1, 1}};
    const std::vector<IndexRing> ring{{0, 1, 2, 3, 4}};
    EXPECT_EQ(convex_pieces(ring, points), ring);
    EXPECT_EQ(points.size(), 5U);
}

TEST(EvenOdd, FewPiecesAndNoNewPointsWithoutCrossings) {
    std::vector<glm::dvec3> points{{0, 0, 0}, {4, 0, 0}, {4, 0, 1},
                                   {1, 0, 1}, {1, 0, 4}, {0, 0, 4}};
    EXPECT_EQ(convex_pieces({{0, 1, 2, 3, 4, 5}}, points).size(), 2U);
    EXPECT_EQ(points.size(), 6U);
}

TEST(EvenOdd, NothingComesOfWhatHasNoAreaOrIsNoNumber) {
    const double nan = std::numeric_limits<double>::quiet_NaN(),
                 infinity = std::numeric_limits<double>::infinity();
    std::vector<glm::dvec3> points{{0, 0, 0},        {1, 1, 1}, {2, 2, 2},         {nan, 0, 0},
                                   {infinity, 1, 0}, {0, 1, 0}, {1e300, 0, 1e300}, {1, 0, 0}};
    EXPECT_TRUE(convex_pieces({}, points).empty());
    EXPECT_TRUE(convex_pieces({{}}, points).empty());
    EXPECT_TRUE(convex_pieces({{0, 1}}, points).empty());
    EXPECT_TRUE(convex_pieces({{0, 1, 2, 1}}, points).empty());
    EXPECT_TRUE(convex_pieces({{0, 0, 0, 0}}, points).empty());
    EXPECT_TRUE(convex_pieces({{0, 3, 5, 7}}, points).empty());
    EXPECT_TRUE(convex_pieces({{0, 4, 5, 7}}, points).empty());
    EXPECT_NO_THROW(convex_pieces({{0, 6, 5, 7}}, points));
}

}  // namespace
}  // namespace povpreview
