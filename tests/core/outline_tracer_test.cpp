// SPDX-License-Identifier: AGPL-3.0-or-later
// The law: every point of a traced outline is near the true curve, and the outline goes all the way
// to the curve's true ends. Worlds are functions from position to surface.
#include "core/outline_tracer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <limits>
#include <random>
#include <string>

#include "core/polyline.h"

namespace povpreview {
namespace {

using World = std::function<std::uint32_t(glm::dvec2)>;
using Distance = std::function<double(glm::dvec2)>;

constexpr glm::ivec2 image{640, 480};
/// What OutlineTracer promises with its default options.
constexpr double promised = .1 + .25;

Sample at(const World& world, glm::dvec2 p) {
    Sample sample;
    sample.position = p;
    sample.kind = RayKind::probe;
    sample.surface = world(p);
    return sample;
}

Outline trace(const World& world, glm::dvec2 a, glm::dvec2 b, glm::ivec2 size = image) {
    OutlineTracer tracer(at(world, a), at(world, b), size);
    while (const auto p = tracer.next()) {
        EXPECT_FALSE(tracer.done());
        EXPECT_FALSE(tracer.next()) << "one probe at a time";
        tracer.accept(at(world, *p));
    }
    EXPECT_TRUE(tracer.done());
    EXPECT_LE(tracer.outline().probes, OutlineOptions().most_probes);
    return tracer.outline();
}

/// Points every quarter pixel or so along the outline.
std::vector<glm::dvec2> points_on(const Outline& outline) {
    std::vector<glm::dvec2> points;
    const auto& v = outline.vertices;
    for (std::size_t i = 0; i + (outline.closed ? 0 : 1) < v.size(); ++i) {
        const glm::dvec2 from = v[i], to = v[(i + 1) % v.size()];
        const int n = int(4 * glm::distance(from, to)) + 1;
        for (int k = 0; k <= n; ++k) points.push_back(from + (k / double(n)) * (to - from));
    }
    return points;
}

double length(const Outline& outline) {
    double sum = 0;
    const auto points = points_on(outline);
    for (std::size_t i = 1; i < points.size(); ++i) sum += glm::distance(points[i - 1], points[i]);
    return sum;
}

double worst(const Outline& outline, const Distance& distance) {
    double greatest = 0;
    for (const glm::dvec2 p : points_on(outline)) greatest = std::max(greatest, distance(p));
    return greatest;
}

/// The surfaces that it names really are left and right of it, a pixel away from long segments.
void expect_sides(const World& world, const Outline& outline, double aside = 1) {
    const auto& v = outline.vertices;
    for (std::size_t i = 0; i + 1 < v.size(); ++i) {
        const glm::dvec2 d = v[i + 1] - v[i];
        if (glm::length(d) < 4 * aside) continue;
        const glm::dvec2 left = glm::dvec2(d.y, -d.x) / glm::length(d),
                         mid = (v[i] + v[i + 1]) / 2.;
        EXPECT_EQ(world(mid + aside * left), outline.left);
        EXPECT_EQ(world(mid - aside * left), outline.right);
    }
}

/// Distance to the sides of a closed polygon.
Distance to_polygon(const Polyline& polygon) {
    return [polygon](glm::dvec2 p) {
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const glm::dvec2 next = polygon[(i + 1) % polygon.size()];
            least = std::min(least, distance_to_segment(p, polygon[i], next));
        }
        return least;
    };
}

double perimeter(const Polyline& polygon) {
    double sum = glm::distance(polygon.front(), polygon.back());
    for (std::size_t i = 1; i < polygon.size(); ++i)
        sum += glm::distance(polygon[i - 1], polygon[i]);
    return sum;
}

bool contains(const Polyline& polygon, glm::dvec2 p) {
    bool in = false;
    for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
        const glm::dvec2 a = polygon[i], b = polygon[j];
        if ((a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x)
            in = !in;
    }
    return in;
}

World inside(const Polyline& polygon) {
    return [polygon](glm::dvec2 p) { return contains(polygon, p) ? 1u : 0u; };
}

TEST(OutlineTracer, AStraightEdgeCrossesTheImageInFewProbes) {
    const World edge = [](glm::dvec2 p) { return p.y > 100 + .2 * (p.x - 100) ? 1u : 2u; };
    const Outline outline = trace(edge, {170.3, 110}, {170.3, 118}, {300, 300});
    ASSERT_EQ(outline.vertices.size(), 2u) << "one segment";
    EXPECT_EQ(outline.begin, OutlineEnd::border);
    EXPECT_EQ(outline.end, OutlineEnd::border);
    EXPECT_EQ(std::min(outline.vertices[0].x, outline.vertices[1].x), 0) << "clipped exactly";
    EXPECT_EQ(std::max(outline.vertices[0].x, outline.vertices[1].x), 300) << "clipped exactly";
    EXPECT_LE(worst(outline,
                    [](glm::dvec2 p) {
                        return std::abs(p.y - 100 - .2 * (p.x - 100)) / std::hypot(1, .2);
                    }),
              promised);
    expect_sides(edge, outline);
    EXPECT_LE(outline.probes, 60);
}

TEST(OutlineTracer, StraightEdgesOfAllDirections) {
    for (int degrees = 0; degrees < 360; degrees += 7) {
        SCOPED_TRACE(std::to_string(degrees) + " degrees");
        const double a = degrees * 3.14159265358979 / 180;
        const glm::dvec2 n{std::cos(a), std::sin(a)}, through{311.7, 222.2};
        const auto signed_distance = [=](glm::dvec2 p) { return glm::dot(p - through, n); };
        const World edge = [=](glm::dvec2 p) { return signed_distance(p) > 0 ? 7u : 8u; };
        const Outline outline = trace(edge, through + 3. * n, through - 2. * n);
        EXPECT_EQ(outline.begin, OutlineEnd::border);
        EXPECT_EQ(outline.end, OutlineEnd::border);
        EXPECT_LE(worst(outline, [=](glm::dvec2 p) { return std::abs(signed_distance(p)); }),
                  promised);
        EXPECT_LE(outline.vertices.size(), 4u);
        EXPECT_LE(outline.probes, 100);
        expect_sides(edge, outline);
    }
}

TEST(OutlineTracer, DiscsOfAllSizesClose) {
    for (const double r : {1.5, 2., 3., 5., 8., 13., 20., 40., 70., 100., 150., 220.}) {
        for (int degrees = 0; degrees < 360; degrees += 31) {
            SCOPED_TRACE("radius " + std::to_string(r) + ", seed at " + std::to_string(degrees));
            const glm::dvec2 centre{320.3, 240.6};
            const World disc = [=](glm::dvec2 p) { return glm::distance(p, centre) < r ? 1u : 0u; };
            const double a = degrees * 3.14159265358979 / 180;
            const glm::dvec2 n{std::cos(a), std::sin(a)};
            const Outline outline =
                trace(disc, centre + (r + 2) * n, centre + (r - std::min(r / 2, 3.)) * n);
            EXPECT_TRUE(outline.closed);
            EXPECT_LE(worst(outline,
                            [=](glm::dvec2 p) { return std::abs(glm::distance(p, centre) - r); }),
                      promised);
            EXPECT_GT(length(outline), .9 * 2 * 3.14159 * r - 1);
            EXPECT_LT(length(outline), 1.1 * 2 * 3.14159 * r + 1);
            expect_sides(disc, outline, .7);
        }
    }
}

TEST(OutlineTracer, ADiscOfRadiusAHundredTakesFewProbes) {
    const glm::dvec2 centre{300.3, 240.2};
    const World disc = [=](glm::dvec2 p) { return glm::distance(p, centre) < 100 ? 1u : 0u; };
    const Outline outline = trace(disc, {398.3, 240}, {403.3, 241});
    EXPECT_TRUE(outline.closed);
    EXPECT_LE(
        worst(outline, [=](glm::dvec2 p) { return std::abs(glm::distance(p, centre) - 100); }),
        .25);
    EXPECT_LE(outline.probes, 150);
}

TEST(OutlineTracer, ADiscCutByTheBorderEndsThere) {
    const glm::dvec2 centre{10, 240};
    const World disc = [=](glm::dvec2 p) { return glm::distance(p, centre) < 50 ? 1u : 0u; };
    const Outline outline = trace(disc, {58, 240}, {62, 240});
    EXPECT_FALSE(outline.closed);
    ASSERT_GE(outline.vertices.size(), 2u);
    for (const glm::dvec2 end : {outline.vertices.front(), outline.vertices.back()}) {
        EXPECT_EQ(end.x, 0);
        EXPECT_NEAR(std::abs(end.y - 240), std::sqrt(2500 - 100), promised);
    }
    EXPECT_LE(worst(outline, [=](glm::dvec2 p) { return std::abs(glm::distance(p, centre) - 50); }),
              promised);
}

TEST(OutlineTracer, PolygonsKeepTheirCorners) {
    const std::vector<Polyline> polygons{
        {{120, 150}, {280, 150}, {280, 250}, {120, 250}},
        {{100.3, 100.7}, {400.2, 130.1}, {220.6, 390.4}},
        {{200, 100},
         {230, 180},
         {310, 180},
         {245, 230},
         {270, 310},
         {200, 260},
         {130, 310},
         {155, 230},
         {90, 180},
         {170, 180}},                                                      // a star
        {{50, 50}, {400, 50}, {400, 90}, {90, 90}, {90, 300}, {50, 300}},  // an L
        {{100, 100}, {500, 180}, {100, 140}},                              // a sharp point
    };
    for (std::size_t k = 0; k < polygons.size(); ++k) {
        const Polyline& polygon = polygons[k];
        for (std::size_t seed = 0; seed < 8 * polygon.size(); ++seed) {
            const std::size_t side = seed / 8;
            const double along = .1 + .11 * double(seed % 8);
            SCOPED_TRACE("polygon " + std::to_string(k) + ", seed on side " + std::to_string(side) +
                         " at " + std::to_string(along));
            const glm::dvec2 a = polygon[side], b = polygon[(side + 1) % polygon.size()];
            const glm::dvec2 n = glm::normalize(glm::dvec2(b.y - a.y, a.x - b.x));
            const glm::dvec2 on = a + along * (b - a);
            const World world = inside(polygon);
            const Outline outline = trace(world, on + 1.5 * n, on - 1.5 * n);
            // A tip of 6 degrees is given up where its sides are a few tenths of a pixel apart; the
            // two ends there are joined only if they are near each other.
            EXPECT_TRUE(outline.closed || k == 4);
            EXPECT_NEAR(length(outline), perimeter(polygon), 8);
            const Distance distance = to_polygon(polygon);
            EXPECT_LE(worst(outline, distance), 2 * promised);
            for (const glm::dvec2 corner : polygon) {
                double nearest = 1e9;
                for (const glm::dvec2 p : points_on(outline))
                    nearest = std::min(nearest, glm::distance(p, corner));
                EXPECT_LE(nearest, k == 4 ? 4 : 3 * promised)
                    << "corner " << corner.x << ", " << corner.y;
            }
            expect_sides(world, outline);
            EXPECT_LE(outline.probes, 130 * int(polygon.size())) << "two laps at worst";
        }
    }
}

TEST(OutlineTracer, EndsWhereAThirdSurfaceMeetsIt) {
    // T-junctions on the left side, the right side and both, and a line that ends the world.
    for (int kind = 0; kind < 3; ++kind) {
        SCOPED_TRACE(kind);
        const auto line = [](double x) { return 100 + .1 * (x - 100); };
        const World world = [=](glm::dvec2 p) -> std::uint32_t {
            const bool above = p.y < line(p.x);
            if (p.x > 350.6 && (kind == 0 ? above : kind == 1 ? !above : true)) return 4;
            if (p.x < 50.3 && (kind == 0 ? !above : kind == 1 ? above : true)) return 3;
            return above ? 2 : 1;
        };
        const Outline outline = trace(world, {170.3, 103}, {170.3, 111});
        ASSERT_GE(outline.vertices.size(), 2u);
        EXPECT_EQ(outline.begin, OutlineEnd::junction);
        EXPECT_EQ(outline.end, OutlineEnd::junction);
        auto [from, to] = std::pair{outline.vertices.front(), outline.vertices.back()};
        if (from.x > to.x) std::swap(from, to);
        EXPECT_LE(glm::distance(from, {50.3, line(50.3)}), .4);
        EXPECT_LE(glm::distance(to, {350.6, line(350.6)}), .4);
        EXPECT_LE(worst(outline, [&](glm::dvec2 p) { return std::abs(p.y - line(p.x)); }),
                  promised);
        EXPECT_LE(outline.probes, 80);
    }
}

TEST(OutlineTracer, ACurveEndsWhereAnotherDiscHidesIt) {
    const glm::dvec2 near{260, 240}, far{340, 250};
    const World world = [=](glm::dvec2 p) -> std::uint32_t {
        return glm::distance(p, near) < 80 ? 2 : glm::distance(p, far) < 70 ? 1 : 0;
    };
    const Outline hidden = trace(world, far + glm::dvec2(68, 0), far + glm::dvec2(72, 0));
    EXPECT_EQ(hidden.begin, OutlineEnd::junction);
    EXPECT_EQ(hidden.end, OutlineEnd::junction);
    for (const glm::dvec2 end : {hidden.vertices.front(), hidden.vertices.back()}) {
        EXPECT_NEAR(glm::distance(end, far), 70, .4);
        EXPECT_NEAR(glm::distance(end, near), 80, .5);
    }
    EXPECT_LE(worst(hidden, [=](glm::dvec2 p) { return std::abs(glm::distance(p, far) - 70); }),
              promised);
}

TEST(OutlineTracer, FollowsASpiralToItsEnd) {
    // r = 4 a between the spiral's two edges, 12 pixels apart, from the middle outwards.
    const glm::dvec2 centre{320, 240};
    const auto phase = [=](glm::dvec2 p) {
        const glm::dvec2 d = p - centre;
        const double r = glm::length(d) / 24, a = std::atan2(d.y, d.x) / 6.28318530718;
        return r - a - std::floor(r - a);
    };
    const World world = [=](glm::dvec2 p) -> std::uint32_t {
        const double r = glm::distance(p, centre);
        if (r > 150 || r < 20) return 9;
        return phase(p) < .5 ? 1 : 2;
    };
    const Outline outline =
        trace(world, centre + glm::dvec2(24 * 3 - 2, 0), centre + glm::dvec2(24 * 3 + 2, 0));
    EXPECT_EQ(outline.begin, OutlineEnd::junction);
    EXPECT_EQ(outline.end, OutlineEnd::junction);
    EXPECT_GT(length(outline), 2500) << "five turns of growing radius";
    EXPECT_LE(worst(outline,
                    [=](glm::dvec2 p) {
                        const double f = phase(p);
                        return 24 * std::min(f, 1 - f);
                    }),
              1.5 * promised);
    const double r0 = glm::distance(outline.vertices.front(), centre);
    const double r1 = glm::distance(outline.vertices.back(), centre);
    EXPECT_NEAR(std::min(r0, r1), 20, .5);
    EXPECT_NEAR(std::max(r0, r1), 150, .5);
}

TEST(OutlineTracer, ThinBars) {
    for (const double width : {1.2, 2., 3.}) {
        SCOPED_TRACE(width);
        const Polyline bar{{100, 200.3}, {300, 200.3}, {300, 200.3 + width}, {100, 200.3 + width}};
        const World world = inside(bar);
        const Outline outline = trace(world, {200, 198}, {200, 200.3 + width / 2});
        const Distance distance = to_polygon(bar);
        EXPECT_LE(worst(outline, distance), 2 * promised);
        EXPECT_GT(length(outline), 180) << "at least one long side";
    }
}

TEST(OutlineTracer, NoAnswersLeadAstrayForever) {
    for (std::uint32_t seed = 1; seed <= 300; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::mt19937 random(seed);
        const std::uint32_t surfaces = 2 + seed % 5, failing = seed % 3 == 0 ? 20 : 0;
        OutlineTracer tracer(at([](glm::dvec2) { return 0u; }, {100, 100}),
                             at([](glm::dvec2) { return 1u; }, {104, 103}), image);
        int probes = 0;
        while (const auto p = tracer.next()) {
            ASSERT_TRUE(std::isfinite(p->x) && std::isfinite(p->y));
            Sample answer;
            answer.position = *p;
            answer.surface = random() % surfaces;
            answer.failed = random() % 100 < failing;
            tracer.accept(answer);
            ASSERT_LE(++probes, OutlineOptions().most_probes);
        }
        EXPECT_TRUE(tracer.done());
        EXPECT_NE(tracer.outline().vertices.size(), 1u);
    }
}

TEST(OutlineTracer, NoiseOfOnePixelSurfacesTerminates) {
    for (std::uint32_t seed = 1; seed <= 50; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const World world = [=](glm::dvec2 p) -> std::uint32_t {
            const auto x = std::uint32_t(std::floor(p.x) + 1000),
                       y = std::uint32_t(std::floor(p.y) + 1000);
            std::uint32_t h = x * 2654435761u ^ y * 2246822519u ^ seed * 3266489917u;
            h ^= h >> 15;
            h *= 2246822519u;
            return (h >> 13) % 2;
        };
        glm::dvec2 b{51, 50.5};
        while (world(b) == world({50.5, 50.5})) b.x += 1;
        const Outline outline = trace(world, {50.5, 50.5}, b);
        for (const glm::dvec2 v : outline.vertices) {
            EXPECT_TRUE(v.x >= 0 && v.y >= 0 && v.x <= image.x && v.y <= image.y);
        }
    }
}

TEST(OutlineTracer, ASeedThatIsNoBracketAsksForNothing) {
    const double nan = std::nan("");
    const World half = [](glm::dvec2 p) { return p.x < 10 ? 1u : 2u; };
    Sample failed = at(half, {5, 5});
    failed.failed = true;
    const std::pair<Sample, Sample> seeds[] = {
        {at(half, {2, 2}), at(half, {4, 4})},
        {failed, at(half, {15, 5})},
        {at(half, {5, nan}), at(half, {15, 5})},
        {at(half, {5, 5}), at(half, {std::numeric_limits<double>::infinity(), 5})},
    };
    for (const auto& [a, b] : seeds) {
        OutlineTracer tracer(a, b, image);
        EXPECT_TRUE(tracer.done());
        EXPECT_FALSE(tracer.next());
        EXPECT_TRUE(tracer.outline().vertices.empty());
    }
}

TEST(OutlineTracer, MayBeDroppedAndMovedAtAnyPoint) {
    const World disc = [](glm::dvec2 p) { return glm::distance(p, {100, 100}) < 30 ? 1u : 0u; };
    for (int stop = 0; stop < 60; ++stop) {
        OutlineTracer tracer(at(disc, {100, 100}), at(disc, {140, 100}), image);
        for (int i = 0; i < stop && !tracer.done(); ++i) {
            const auto p = tracer.next();
            OutlineTracer moved(std::move(tracer));
            moved.accept(at(disc, *p));
            tracer = std::move(moved);
        }
    }
}

TEST(OutlineTracer, AThirdSurfaceInsideTheSeedGivesTheNearerOutline) {
    const World stripes = [](glm::dvec2 p) -> std::uint32_t {
        return p.y < 100 ? 1 : p.y < 102 ? 2 : 3;
    };
    const Outline outline = trace(stripes, {300, 98.5}, {300, 103.5});
    EXPECT_EQ(std::min(outline.left, outline.right), 1u);
    EXPECT_EQ(std::max(outline.left, outline.right), 2u);
    EXPECT_LE(worst(outline, [](glm::dvec2 p) { return std::abs(p.y - 100); }), promised);
}

TEST(OutlineTracer, TellsSidesApartByAnyIdentity) {
    OutlineOptions options;
    options.identity = [](const Sample& s) { return s.signature.lights; };
    const auto sample = [](glm::dvec2 p) {
        Sample s;
        s.position = p;
        s.surface = 5;
        s.signature.lights = p.x < 200.2 ? 1 : 2;
        return s;
    };
    OutlineTracer tracer(sample({199, 100}), sample({202, 100}), image, options);
    while (const auto p = tracer.next()) tracer.accept(sample(*p));
    EXPECT_EQ(tracer.outline().begin, OutlineEnd::border);
    EXPECT_LE(worst(tracer.outline(), [](glm::dvec2 p) { return std::abs(p.x - 200.2); }),
              promised);
}

TEST(Polyline, SimplifyKeepsWithinTolerance) {
    std::mt19937 random(5);  // seed 5
    for (int round = 0; round < 200; ++round) {
        Polyline line{{0, 0}};
        double heading = 0;
        for (int i = 0; i < 60; ++i) {
            heading += (double(random() % 2001) / 1000 - 1) * (round % 10) / 10;
            line.push_back(line.back() + glm::dvec2(std::cos(heading), std::sin(heading)));
        }
        for (const bool closed : {false, true}) {
            const Polyline simple = simplify(line, .25, closed);
            EXPECT_EQ(simple.front(), line.front());
            EXPECT_TRUE(closed || simple.back() == line.back());
            for (const glm::dvec2 p : line) {
                double nearest = 1e9;
                for (std::size_t i = 0; i + (closed ? 0 : 1) < simple.size(); ++i)
                    nearest = std::min(nearest, distance_to_segment(
                                                    p, simple[i], simple[(i + 1) % simple.size()]));
                EXPECT_LE(nearest, .25 + 1e-9);
            }
        }
    }
}

TEST(Polyline, ClipsExactly) {
    EXPECT_EQ(clip_to_border({5, 5}, {15, 5}, {10, 10}), glm::dvec2(10, 5));
    EXPECT_EQ(clip_to_border({5, 5}, {-5, -5}, {10, 10}).x, 0);
    EXPECT_EQ(clip_to_border({5, 5}, {8, 17}, {10, 10}).y, 10);
    EXPECT_EQ(clip_to_border({10, 5}, {11, 5}, {10, 10}), glm::dvec2(10, 5)) << "from the border";
}

}  // namespace
}  // namespace povpreview
