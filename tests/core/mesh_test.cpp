// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>
#include <random>

#include "core/chain_insertion.h"
#include "core/corner_colours.h"

namespace povpreview {
namespace {

using glm::dvec2;
using glm::vec3;

Sample shown(vec3 colour) {
    Sample sample;
    sample.colour = colour;
    sample.surface = 1;
    return sample;
}

VertexId add(Mesh& mesh, dvec2 p, vec3 colour) {
    const VertexId v = mesh.insert(p, VertexId{0}).vertex;
    mesh.answer(mesh.promise(v, p), shown(colour));
    return v;
}

/// Promises and answers every sample that is missing around constraints, by a function.
template <class Colour>
void answer_sides(Mesh& mesh, Colour colour) {
    std::vector<Mesh::MissingSide> missing;
    for (std::uint32_t i = 0; i < mesh.triangulation().vertex_ids(); ++i) {
        const VertexId v{i};
        if (!mesh.triangulation().alive(v)) continue;
        mesh.missing_sides(v, missing);
        for (const Mesh::MissingSide& side : missing)
            if (const auto sample = mesh.promise_side(v, side.side))
                mesh.answer(*sample, shown(colour(mesh.sample(*sample).position)));
    }
}

TEST(Wedge, HoldsWhatLiesBetweenItsRays) {
    const Wedge right{{0, 0}, {1, 0}, {0, 1}, false};
    EXPECT_TRUE(right.contains({1, 1}));
    EXPECT_FALSE(right.contains({-1, 1}));
    EXPECT_FALSE(right.contains({1, 0})) << "a ray belongs to no side";
    EXPECT_NEAR(right.angle(), std::numbers::pi / 2, 1e-12);
    const Wedge reflex{{0, 0}, {0, 1}, {1, 0}, false};
    EXPECT_TRUE(reflex.contains({-1, -1}));
    EXPECT_FALSE(reflex.contains({1, 1}));
    EXPECT_NEAR(reflex.angle(), 3 * std::numbers::pi / 2, 1e-12);
    const Wedge half{{0, 0}, {1, 0}, {-2, 0}, false};
    EXPECT_TRUE(half.contains({0, 1}));
    EXPECT_FALSE(half.contains({0, -1}));
}

TEST(Wedge, BisectorLiesInsideHoweverThin) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> turn(0, 2 * std::numbers::pi), thin(-7, .75);
    for (int i = 0; i < 500; ++i) {
        const double a = turn(random), angle = std::pow(10, thin(random));
        const dvec2 c(100 * turn(random), 90);
        const Wedge w{c, c + dvec2(std::cos(a), std::sin(a)),
                      c + 3. * dvec2(std::cos(a + angle), std::sin(a + angle)), false};
        EXPECT_TRUE(w.contains(c + w.bisector())) << "angle " << angle << " seed 3 number " << i;
    }
}

TEST(Mesh, ValuesJumpAcrossAConstraintAndNowhereElse) {
    Mesh mesh(40, 30);
    const auto truth = [](dvec2 p) { return p.x + .3 * p.y < 20 ? vec3(1, 0, 0) : vec3(0, 0, 1); };
    for (dvec2 p : {dvec2(0, 0), {40, 0}, {40, 30}, {0, 30}, {7, 9}, {33, 14}, {9, 25}, {30, 25}})
        add(mesh, p, truth(p));
    const VertexId a = mesh.insert({20, 0}, VertexId{0}).vertex;
    const VertexId b = mesh.insert({11, 30}, VertexId{0}).vertex;
    mesh.constrain(a, b);
    answer_sides(mesh, truth);
    ASSERT_EQ(mesh.validate(), "");
    const CornerColours colours(mesh);
    mesh.triangulation().for_each_face([&](VertexId p, VertexId q, VertexId r) {
        const auto& t = mesh.triangulation();
        const vec3 colour = truth((t.position(p) + t.position(q) + t.position(r)) / 3.);
        EXPECT_EQ(colours.at(p, q), colour);
        EXPECT_EQ(colours.at(q, r), colour);
        EXPECT_EQ(colours.at(r, p), colour);
    });
    EXPECT_FLOAT_EQ(mesh.contrast(a, b).value(), 0) << "each side is of one colour";
}

TEST(Wedge, ClearanceIsTheDistanceFromTheNearerRay) {
    const Wedge right{{0, 0}, {3, 0}, {0, 2}, false};
    EXPECT_NEAR(right.clearance({1, .5}), .5, 1e-12);
    EXPECT_NEAR(right.clearance({.25, 7}), .25, 1e-12);
    const Wedge reflex{{0, 0}, {0, 2}, {3, 0}, false};
    EXPECT_NEAR(reflex.clearance({-3, -4}), 5, 1e-12) << "beyond the ends of both rays";
    EXPECT_EQ((Wedge{{0, 0}, {3, 0}, {3, 0}, true}.clearance({1, 1})), 0);
}

TEST(Mesh, OfSeveralSamplesOnOneSideTheClearestIsShown) {
    Mesh mesh(40, 40);
    for (dvec2 p : {dvec2(0, 0), {0, 40}, {40, 0}, {40, 40}}) add(mesh, p, vec3(0, 0, 0));
    const VertexId top = mesh.insert({20, 5}, VertexId{0}).vertex;
    const VertexId v = mesh.insert({20, 20}, VertexId{0}).vertex;
    const VertexId bottom = mesh.insert({20, 35}, VertexId{0}).vertex;
    mesh.constrain(top, v);
    mesh.constrain(v, bottom);
    const SampleId clear = mesh.promise(v, {20.4, 20});
    const SampleId close = mesh.promise(v, {20.01, 18.5});  // of a thin sector that is no more
    mesh.answer(clear, shown({1, 0, 0}));
    mesh.answer(close, shown({0, 1, 0}));
    answer_sides(mesh, [](dvec2) { return vec3(0, 0, 1); });
    EXPECT_EQ(mesh.validate(), "");
    for (const VertexId to : {top, bottom})
        EXPECT_EQ(mesh.corner(v, to, to == top), clear) << "towards x = 40";
}

TEST(Mesh, UnknownCornersNeverTakeColourFromAcross) {
    Mesh mesh(40, 40);
    for (dvec2 p : {dvec2(0, 0), {0, 40}, {5, 20}}) add(mesh, p, vec3(1, 0, 0));
    for (dvec2 p : {dvec2(40, 0), {40, 40}, {35, 20}}) add(mesh, p, vec3(0, 0, 1));
    const VertexId top = mesh.insert({20, 0}, VertexId{0}).vertex;
    const VertexId bottom = mesh.insert({20, 40}, VertexId{0}).vertex;
    mesh.constrain(top, bottom);
    const VertexId middle = mesh.split(top, bottom, {20, 20}).vertex;
    const CornerColours colours(mesh);
    for (VertexId v : {top, middle, bottom}) {
        std::vector<Triangulation::Spoke> fan;
        mesh.triangulation().fan(v, fan);
        for (std::size_t i = 0; i < fan.size(); ++i) {
            if (!fan[i].face) continue;
            const VertexId next = fan[(i + 1) % fan.size()].to;
            const dvec2 centre =
                (mesh.triangulation().position(v) + mesh.triangulation().position(fan[i].to) +
                 mesh.triangulation().position(next)) /
                3.;
            EXPECT_EQ(colours.at(v, fan[i].to), centre.x < 20 ? vec3(1, 0, 0) : vec3(0, 0, 1));
        }
    }
}

std::vector<VertexId> insert_chain(
    Mesh& mesh, std::vector<dvec2> vertices, bool closed,
    const std::function<void(VertexId)>& removed = [](VertexId) {},
    EdgeKind kind = EdgeKind::traced) {
    const auto size = static_cast<int>(mesh.triangulation().position(VertexId{2}).x);
    if (closed) vertices.push_back(vertices.front());
    ChainInsertion insertion(mesh, {size, size}, removed);
    insertion.insert(vertices, {kind, 0});
    return insertion.finish();
}
std::vector<dvec2> circle(dvec2 centre, double radius, int n, double phase = 0) {
    std::vector<dvec2> points;
    for (int i = 0; i < n; ++i) {
        const double a = 2 * std::numbers::pi * i / n + phase;
        points.push_back(centre + radius * dvec2(std::cos(a), std::sin(a)));
    }
    return points;
}

Mesh pixel_grid(int side, int step) {
    Mesh mesh(side, side);
    for (int y = 0; y <= side; y += step)
        for (int x = 0; x <= side; x += step) {
            const dvec2 p(x + (x > 0 && x < side ? .5 : 0), y + (y > 0 && y < side ? .5 : 0));
            add(mesh, p, vec3(.5f));
        }
    return mesh;
}

double shortest_edge_inside(const Mesh& mesh) {
    double least = 1e9;
    mesh.triangulation().for_each_edge([&](VertexId a, VertexId b, bool) {
        least = std::min(least, glm::distance(mesh.triangulation().position(a),
                                              mesh.triangulation().position(b)));
    });
    return least;
}

TEST(InsertChain, MakesAClosedChainAndClearsItsSurroundings) {
    Mesh mesh = pixel_grid(64, 2);
    const std::size_t before = mesh.triangulation().vertices();
    std::size_t removed = 0;
    insert_chain(mesh, circle({31, 33}, 20, 24), true, [&](VertexId) { ++removed; });
    EXPECT_EQ(mesh.triangulation().constraints(), 24u);
    EXPECT_EQ(mesh.triangulation().vertices(), before - removed + 24);
    EXPECT_GT(removed, 10u);
    answer_sides(mesh, [](dvec2) { return vec3(.5f); });
    EXPECT_EQ(mesh.validate(), "");
    mesh.triangulation().for_each_edge([&](VertexId a, VertexId b, bool constrained) {
        if (!constrained) return;
        for (std::uint32_t i = 0; i < mesh.triangulation().vertex_ids(); ++i) {
            const VertexId v{i};
            if (!mesh.triangulation().alive(v) || mesh.triangulation().on_constraint(v)) continue;
            const dvec2 p = mesh.triangulation().position(a), q = mesh.triangulation().position(b);
            const dvec2 d = q - p, r = mesh.triangulation().position(v) - p;
            const double along = glm::dot(r, d) / glm::dot(d, d);
            if (along < 0 || along > 1) continue;
            EXPECT_GE(std::abs(d.x * r.y - d.y * r.x) / glm::length(d),
                      traced_chain.clearance - 1e-9);
        }
    });
}

TEST(InsertChain, ASecondTraceOfTheSameOutlineFallsOnTheFirst) {
    Mesh mesh = pixel_grid(64, 4);
    insert_chain(mesh, circle({31, 33}, 20, 40), true);
    const std::size_t once = mesh.triangulation().constraints();
    // The same circle by other points, .1 pixels off.
    insert_chain(mesh, circle({31.1, 33}, 20, 37, .05), true);
    answer_sides(mesh, [](dvec2) { return vec3(.5f); });
    EXPECT_EQ(mesh.validate(), "");
    // Points on old edges split them; nothing runs beside them.
    EXPECT_LE(mesh.triangulation().constraints(), once + 37);
    EXPECT_GT(shortest_edge_inside(mesh), .2);
}

/// Chains of all kinds on top of each other: crossing, touching, along the border, twice.
class ChainScript : public testing::TestWithParam<unsigned> {};

TEST_P(ChainScript, KeepsEveryInvariant) {
    std::mt19937 random(GetParam());
    SCOPED_TRACE(testing::Message() << "seed " << GetParam());
    std::uniform_real_distribution<double> place(-.3, 64.3), size(1, 30);
    Mesh mesh = pixel_grid(64, 4);
    for (int step = 0; step < 12; ++step) {
        std::vector<dvec2> points;
        bool closed = false;
        if (step % 3 == 0) {
            points = circle({place(random), place(random)}, size(random), 3 + int(random() % 20));
            for (dvec2& p : points) p = glm::clamp(p, dvec2(0), dvec2(64));
            closed = true;
        } else {
            for (int i = 0; i < 2 + int(random() % 5); ++i) {
                dvec2 p = glm::clamp(dvec2(place(random), place(random)), dvec2(0), dvec2(64));
                if (step % 3 == 2) p = glm::floor(p);  // collinear and shared points
                points.push_back(p);
            }
        }
        insert_chain(
            mesh, points, closed, [](VertexId) {}, step % 2 ? EdgeKind::shadow : EdgeKind::traced);
        answer_sides(mesh, [](dvec2 p) { return vec3(float(p.x) / 64, float(p.y) / 64, 0); });
        ASSERT_EQ(mesh.validate(), "") << "step " << step;
    }
    EXPECT_GT(mesh.triangulation().constraints(), 20u);
}

INSTANTIATE_TEST_SUITE_P(Seeds, ChainScript, testing::Range(1u, 16u));

}  // namespace
}  // namespace povpreview
