// SPDX-License-Identifier: AGPL-3.0-or-later
//
// The tracer's constructive solid geometry against brute force: what a ray hits of the resolved
// faces is what it hits of the whole faces by POV-Ray's rules, applied hit by hit.
#include "backend/oracle/solids.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>

namespace povpreview::tracer {
namespace {

using Random = std::mt19937;

double uniform(Random& random, double low, double high) {
    return std::uniform_real_distribution<>(low, high)(random);
}
int whole(Random& random, int low, int high) {
    return std::uniform_int_distribution<>(low, high)(random);
}

/// A box between two corners, in a frame of its own.
Solid box(const Point& low, const Point& high, const std::function<Point(Point)>& frame,
          bool inverted, std::uint32_t number) {
    std::vector<Point> corners;
    for (int i = 0; i < 8; ++i)
        corners.push_back(
            frame({i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z}));
    const int sides[6][4] = {{0, 2, 6, 4}, {1, 5, 7, 3}, {0, 4, 5, 1},
                             {2, 3, 7, 6}, {0, 1, 3, 2}, {4, 6, 7, 5}};
    Solid solid;
    solid.number = number;
    solid.leaf.inverted = inverted;
    std::vector<ConvexPolygon> polygons;
    for (std::uint32_t side = 0; side < 6; ++side) {
        polygons.emplace_back();
        for (const int corner : sides[side])
            polygons.back().push_back(corners[static_cast<std::size_t>(corner)]);
        solid.leaf.faces.push_back({polygons.back(), side});
    }
    solid.leaf.cells = {cell_within(polygons)};
    return solid;
}

Point same(Point p) { return p; }

std::function<Point(Point)> random_frame(Random& random) {
    const auto vector = [&] {
        return Point{uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1)};
    };
    const Point a = vector(), b = vector(), c = vector(), origin = vector();
    return [=](Point p) { return origin + p.x * a + p.y * b + p.z * c; };
}

/// Boxes anywhere, in frames of any shape: no two faces coincide.
Solid box_anywhere(Random& random, std::uint32_t number) {
    const Point low{uniform(random, -2, 0), uniform(random, -2, 0), uniform(random, -2, 0)},
        size{uniform(random, .3, 3), uniform(random, .3, 3), uniform(random, .3, 3)};
    return box(low, low + size, random_frame(random), whole(random, 0, 3) == 0, number);
}

/// Boxes on a small grid: faces coincide, touch, and are the same all the time.
Solid box_on_grid(Random& random, std::uint32_t number) {
    const auto at = [&] { return double(whole(random, 0, 3)); };
    const Point low{at(), at(), at()};
    const Point size{double(whole(random, 1, 3)), double(whole(random, 1, 3)),
                     double(whole(random, 1, 3))};
    return box(low, low + size, same, whole(random, 0, 3) == 0, number);
}

Solid random_solid(Random& random, int depth, bool unions, std::uint32_t& number,
                   Solid (*leaf)(Random&, std::uint32_t)) {
    if (depth == 0 || whole(random, 0, 4) == 0) return leaf(random, number++);
    Solid solid;
    const int kind = whole(random, unions ? 0 : 1, 2);
    solid.kind = kind == 0   ? Solid::Kind::unite
                 : kind == 1 ? Solid::Kind::merge
                             : Solid::Kind::intersect;
    const int parts = whole(random, 1, 3);
    for (int i = 0; i < parts; ++i)
        solid.parts.push_back(random_solid(random, depth - 1, unions, number, leaf));
    if (unions && whole(random, 0, 5) == 0)
        solid.clips.push_back(random_solid(random, 0, unions, number, leaf));
    return solid;
}

struct Ray {
    Point origin, direction;
};

Ray random_ray(Random& random, const Point& middle) {
    const auto vector = [&](double size) {
        return Point{uniform(random, -size, size), uniform(random, -size, size),
                     uniform(random, -size, size)};
    };
    const Point target = middle + vector(2), far = vector(1);
    const Point origin = target + (20 / length(far)) * far;
    return {origin, target - origin};
}

/// Where the ray meets the polygon, as a multiple of its direction; negative if nowhere.
double hit(const Ray& ray, const ConvexPolygon& polygon) {
    const Plane plane = plane_of(polygon);
    const double slope = dot(plane.normal, ray.direction);
    if (slope == 0) return -1;
    const double at = -plane.distance(ray.origin) / slope;
    const Point p = ray.origin + at * ray.direction;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        if (dot(cross(b - a, p - a), plane.normal) < 0) return -1;
    }
    return at;
}

bool in_all(const std::vector<Solid>& solids, const Point& p) {
    return std::all_of(solids.begin(), solids.end(),
                       [&](const Solid& s) { return is_inside(s, p); });
}

/// POV-Ray's All_Intersections (csg.cpp).
std::vector<double> hits_by_the_rules(const Solid& solid, const Ray& ray) {
    std::vector<double> hits;
    const auto point = [&](double at) { return ray.origin + at * ray.direction; };
    if (solid.kind == Solid::Kind::leaf)
        for (const SolidFace& face : solid.leaf.faces)
            if (const double at = hit(ray, face.corners); at >= 0) hits.push_back(at);
    for (const Solid& part : solid.parts)
        for (const double at : hits_by_the_rules(part, ray)) {
            const bool kept =
                std::all_of(solid.parts.begin(), solid.parts.end(), [&](const Solid& other) {
                    if (&other == &part || solid.kind == Solid::Kind::unite) return true;
                    return is_inside(other, point(at)) == (solid.kind == Solid::Kind::intersect);
                });
            if (kept) hits.push_back(at);
        }
    hits.erase(std::remove_if(hits.begin(), hits.end(),
                              [&](double at) { return !in_all(solid.clips, point(at)); }),
               hits.end());
    std::sort(hits.begin(), hits.end());
    return hits;
}

std::vector<SolidPiece> resolved(const Solid& solid) {
    std::vector<SolidPiece> pieces;
    EXPECT_TRUE(resolve(solid, 100000, pieces));
    return pieces;
}

std::vector<double> hits_of(const std::vector<SolidPiece>& pieces, const Ray& ray) {
    std::vector<double> hits;
    for (const SolidPiece& piece : pieces)
        if (const double at = hit(ray, piece.corners); at >= 0) hits.push_back(at);
    std::sort(hits.begin(), hits.end());
    return hits;
}

double area(const std::vector<SolidPiece>& pieces) {
    double sum = 0;
    for (const SolidPiece& piece : pieces) sum += length(area_normal(piece.corners)) / 2;
    return sum;
}

TEST(Solids, RaysHitThePiecesWhereTheyHitTheSolid) {
    constexpr unsigned seed = 11;
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    std::size_t hit_at_all = 0;
    for (int round = 0; round < 300 && !testing::Test::HasFailure(); ++round) {
        std::uint32_t number = 0;
        const Solid solid = random_solid(random, 3, true, number, box_anywhere);
        const std::vector<SolidPiece> pieces = resolved(solid);
        for (int i = 0; i < 50; ++i) {
            const Ray ray = random_ray(random, {0, 0, 0});
            const std::vector<double> expected = hits_by_the_rules(solid, ray),
                                      found = hits_of(pieces, ray);
            ASSERT_EQ(found.size(), expected.size()) << "round " << round << ", ray " << i;
            for (std::size_t k = 0; k < found.size(); ++k) ASSERT_NEAR(found[k], expected[k], 1e-9);
            hit_at_all += !found.empty();
        }
    }
    EXPECT_GT(hit_at_all, 2000U);
}

/// The surface of a merge or intersection is a border: whoever crosses it is inside or outside
/// alternately, also where faces coincide.
TEST(Solids, PiecesAreTheBorderOfTheInsideWhereFacesCoincide) {
    constexpr unsigned seed = 12;
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    std::size_t inside = 0, tests = 0;
    for (int round = 0; round < 600 && !testing::Test::HasFailure(); ++round) {
        std::uint32_t number = 0;
        const Solid solid = random_solid(random, 3, false, number, box_on_grid);
        const std::vector<SolidPiece> pieces = resolved(solid);
        const bool far_inside = is_inside(solid, {1000, 1000, 1000});
        for (int i = 0; i < 50; ++i) {
            const Ray ray = random_ray(random, {2, 2, 2});
            const Point start = ray.origin + ray.direction;
            const std::size_t crossed = hits_of(pieces, {start, ray.direction}).size();
            ASSERT_EQ(is_inside(solid, start), far_inside != (crossed % 2 == 1))
                << "round " << round << ", ray " << i;
            inside += is_inside(solid, start);
            ++tests;
        }
    }
    EXPECT_GT(inside, tests / 20);
    EXPECT_LT(inside, tests - tests / 20);
}

Solid of(Solid::Kind kind, std::vector<Solid> parts) {
    Solid solid;
    solid.kind = kind;
    solid.parts = std::move(parts);
    return solid;
}

/// A cube of side 4 with a hole of side 2 through it from top to bottom, both ending in the same
/// planes: 6 * 16 - 2 * 4 + 4 * 8.
TEST(Solids, AHoleThatEndsInTheSurfaceIsOpen) {
    const Solid solid = of(Solid::Kind::intersect, {box({0, 0, 0}, {4, 4, 4}, same, false, 0),
                                                    box({1, 0, 1}, {3, 4, 3}, same, true, 1)});
    const std::vector<SolidPiece> pieces = resolved(solid);
    EXPECT_NEAR(area(pieces), 120, 1e-9);
    for (const SolidPiece& piece : pieces) {
        const bool holed = piece.leaf == 0 && (piece.face == 2 || piece.face == 3);
        EXPECT_EQ(piece.whole, !holed) << piece.leaf << " " << piece.face;
    }
}

TEST(Solids, WhatIsNotTouchedStaysInOnePiece) {
    const Solid solid = of(Solid::Kind::intersect, {box({0, 0, 0}, {1, 1, 1}, same, false, 0),
                                                    box({5, 0, 0}, {6, 1, 1}, same, true, 1)});
    const std::vector<SolidPiece> pieces = resolved(solid);
    ASSERT_EQ(pieces.size(), 6U);
    for (const SolidPiece& piece : pieces) {
        EXPECT_TRUE(piece.whole);
        EXPECT_EQ(piece.leaf, 0U);
    }
}

/// Two boxes side by side merged are one box; united they keep the wall between them, twice.
TEST(Solids, TouchingBoxesAreOneInAMergeAndTwoInAUnion) {
    const std::vector<Solid> parts{box({0, 0, 0}, {1, 1, 1}, same, false, 0),
                                   box({1, 0, 0}, {2, 1, 1}, same, false, 1)};
    EXPECT_NEAR(area(resolved(of(Solid::Kind::merge, parts))), 10, 1e-9);
    EXPECT_NEAR(area(resolved(of(Solid::Kind::unite, parts))), 12, 1e-9);
}

/// The same box twice is shown once.
TEST(Solids, CoincidingFacesAreShownOnce) {
    const std::vector<Solid> parts{box({0, 0, 0}, {1, 1, 1}, same, false, 0),
                                   box({0, 0, 0}, {1, 1, 1}, same, false, 1)};
    EXPECT_NEAR(area(resolved(of(Solid::Kind::intersect, parts))), 6, 1e-9);
    EXPECT_NEAR(area(resolved(of(Solid::Kind::merge, parts))), 6, 1e-9);
}

/// A patch has no inside, is cut by the others, and makes an intersection with it show nothing of
/// them, inverted or not, as in POV-Ray.
TEST(Solids, APatchInAnIntersectionIsCutAndHidesTheRest) {
    Solid patch;
    patch.number = 7;
    patch.leaf.inverted = true;
    patch.leaf.faces = {{{{-1, .5, .5}, {2, .5, .5}, {2, .5, .75}}, 0}};
    const Solid solid =
        of(Solid::Kind::intersect, {box({0, 0, 0}, {1, 1, 1}, same, false, 0), patch});
    const std::vector<SolidPiece> pieces = resolved(solid);
    ASSERT_FALSE(pieces.empty());
    for (const SolidPiece& piece : pieces) {
        EXPECT_EQ(piece.leaf, 7U);
        for (const Point& p : piece.corners) {
            EXPECT_GE(p.x, -1e-9);
            EXPECT_LE(p.x, 1 + 1e-9);
        }
    }
    // Of the triangle's width, z from .5 to .5 + (x + 1) / 12, what is between x = 0 and 1.
    EXPECT_NEAR(area(pieces), 1.5 / 12, 1e-9);
}

TEST(Solids, TooManyPiecesAreRefused) {
    std::vector<Solid> parts{box({0, 0, 0}, {100, 1, 1}, same, false, 0)};
    for (int i = 1; i < 40; ++i)
        parts.push_back(box({2. * i, -1, .25}, {2. * i + 1, 2, .75}, same, true,
                            static_cast<std::uint32_t>(i)));
    std::vector<SolidPiece> pieces;
    EXPECT_FALSE(resolve(of(Solid::Kind::intersect, parts), 20, pieces));
    pieces.clear();
    EXPECT_TRUE(resolve(of(Solid::Kind::intersect, parts), 2000, pieces));
}

TEST(Solids, FacesWithoutAreaAndFlatBoxesDoNoHarm) {
    const Solid flat = box({0, 1, 0}, {2, 1, 2}, same, false, 0);
    EXPECT_TRUE(flat.leaf.cells.front().planes.empty());
    Solid patch = flat;
    patch.leaf.cells.clear();
    const Solid solid =
        of(Solid::Kind::intersect, {patch, box({1, 0, 0}, {3, 2, 3}, same, false, 1)});
    EXPECT_GT(area(resolved(solid)), 0);
}

}  // namespace
}  // namespace povpreview::tracer
