// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/triangulation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <random>

#include "core/predicates.h"

namespace povpreview {
namespace {

using glm::dvec2;
__extension__ using Wide = __int128;

/// Links, orientation, areas and counts, by what the public interface shows; CGAL's own check of
/// the constrained Delaunay property; and that property again by our predicates.
testing::AssertionResult holds(const Triangulation& t, double area) {
    if (!t.sound()) return testing::AssertionFailure() << "CGAL finds it unsound";
    double sum = 0;
    std::string fault;
    t.for_each_face([&](VertexId a, VertexId b, VertexId c) {
        const dvec2 p = t.position(a), q = t.position(b), r = t.position(c);
        if (orientation(p, q, r) <= 0) fault = "a face is flat or turned over";
        sum += ((q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x)) / 2;
    });
    std::size_t constraints = 0;
    t.for_each_edge([&](VertexId a, VertexId b, bool constrained) {
        if (constrained) ++constraints;
        Triangulation::Edge edge{};
        if (!t.find_edge(a, b, edge)) fault = "an edge is not found";
        if (edge.constrained != constrained) fault = "an edge's constraint differs";
        if (constrained && (!t.on_constraint(a) || !t.on_constraint(b)))
            fault = "an end of a constraint does not know";
        if (!edge.left.valid() || !edge.right.valid()) return;
        if (orientation(t.position(a), t.position(b), t.position(edge.left)) <= 0)
            fault = "the left vertex is not left";
        if (!constrained && in_circle(t.position(a), t.position(b), t.position(edge.left),
                                      t.position(edge.right)) > 0)
            fault = "an edge is not Delaunay";
    });
    if (constraints != t.constraints()) fault = "constraints are miscounted";
    if (std::abs(sum - area) > 1e-9 * area) fault = "the faces do not add up to the rectangle";
    if (!fault.empty()) return testing::AssertionFailure() << fault;
    return testing::AssertionSuccess();
}

/// Every edge of the triangulation that the operation made has an end among the touched vertices.
using Edges = std::vector<std::tuple<VertexId, VertexId, bool>>;
Edges edges_of(const Triangulation& t) {
    Edges edges;
    t.for_each_edge([&](VertexId a, VertexId b, bool constrained) {
        edges.emplace_back(std::min(a, b), std::max(a, b), constrained);
    });
    std::sort(edges.begin(), edges.end());
    return edges;
}
testing::AssertionResult touched_all(const Edges& before, const Triangulation& t) {
    Edges fresh;
    const Edges after = edges_of(t);
    std::set_difference(after.begin(), after.end(), before.begin(), before.end(),
                        std::back_inserter(fresh));
    for (const auto& [a, b, constrained] : fresh) {
        const auto touched = t.touched();
        if (std::find(touched.begin(), touched.end(), a) == touched.end() &&
            std::find(touched.begin(), touched.end(), b) == touched.end())
            return testing::AssertionFailure()
                   << "edge " << a.value << "-" << b.value << (constrained ? " (constrained)" : "")
                   << " is new and not reported";
    }
    return testing::AssertionSuccess();
}

TEST(Triangulation, StartsAsTheRectangle) {
    Triangulation t({0, 0}, {8, 6});
    EXPECT_EQ(t.vertices(), 4u);
    EXPECT_EQ(t.faces(), 2u);
    EXPECT_TRUE(holds(t, 48));
}

TEST(Triangulation, FindsTheVertexThatIsThere) {
    Triangulation t({0, 0}, {8, 6});
    const auto first = t.insert({3, 2}, VertexId{0});
    EXPECT_TRUE(first.fresh);
    const auto second = t.insert({3, 2}, VertexId{2});
    EXPECT_FALSE(second.fresh);
    EXPECT_EQ(first.vertex, second.vertex);
    EXPECT_EQ(t.vertices(), 5u);
}

TEST(Triangulation, FanOnTheBorderEndsAtTheOutside) {
    Triangulation t({0, 0}, {8, 6});
    const VertexId v = t.insert({4, 0}, VertexId{0}).vertex;
    std::vector<Triangulation::Spoke> spokes;
    t.fan(v, spokes);
    ASSERT_GE(spokes.size(), 3u);
    for (std::size_t i = 0; i + 1 < spokes.size(); ++i) EXPECT_TRUE(spokes[i].face);
    EXPECT_FALSE(spokes.back().face);
    EXPECT_EQ(spokes.front().to, VertexId{1});
    EXPECT_EQ(spokes.back().to, VertexId{0});
}

TEST(Triangulation, CrossingConstraintsMeetInANewVertex) {
    Triangulation t({0, 0}, {9, 7});
    const VertexId a = t.insert({1, 1}, VertexId{0}).vertex, b = t.insert({8, 6}, a).vertex;
    const VertexId c = t.insert({1, 6}, a).vertex, d = t.insert({7.5, 1}, c).vertex;
    t.constrain(a, b);
    EXPECT_EQ(t.constraints(), 1u);
    const Edges before = edges_of(t);
    t.constrain(c, d);
    EXPECT_EQ(t.constraints(), 4u);
    EXPECT_EQ(t.vertices(), 9u);
    EXPECT_TRUE(holds(t, 63));
    EXPECT_TRUE(touched_all(before, t));
}

TEST(Triangulation, ConstraintRunsThroughVerticesOnIt) {
    Triangulation t({0, 0}, {8, 8});
    VertexId last{0};
    for (int i = 1; i < 8; ++i) last = t.insert({double(i), double(i)}, last).vertex;
    Edges before = edges_of(t);
    t.constrain(VertexId{0}, VertexId{2});
    EXPECT_EQ(t.constraints(), 8u);
    EXPECT_TRUE(touched_all(before, t));
    EXPECT_TRUE(holds(t, 64));
}

TEST(Triangulation, SplitsWhereTheMiddleIsRoundedOffTheEdge) {
    Triangulation t({0, 0}, {100, 100});
    const VertexId a = t.insert({.1, .3}, VertexId{0}).vertex;
    const VertexId b = t.insert({97.7, 31.9}, a).vertex;
    t.constrain(a, b);
    std::vector<std::pair<VertexId, VertexId>> queue{{a, b}};
    for (std::size_t i = 0; i < 200; ++i) {
        const auto [p, q] = queue[i];
        const auto split = t.split(p, q, (t.position(p) + t.position(q)) / 2.);
        ASSERT_TRUE(split.fresh);
        queue.emplace_back(p, split.vertex);
        queue.emplace_back(split.vertex, q);
        ASSERT_EQ(t.constraints(), i + 2);
        ASSERT_TRUE(holds(t, 10000));
    }
}

TEST(Triangulation, SplitAtAnOldVertexAddsNone) {
    Triangulation t({0, 0}, {10, 10});
    const VertexId a = t.insert({2, 5}, VertexId{0}).vertex;
    const VertexId b = t.insert({8, 5}, a).vertex;
    const VertexId c = t.insert({5, 5.25}, a).vertex;
    t.constrain(a, b);
    const auto split = t.split(a, b, {5, 5.25});
    EXPECT_FALSE(split.fresh);
    EXPECT_EQ(split.vertex, c);
    EXPECT_EQ(t.constraints(), 2u);
    EXPECT_TRUE(holds(t, 100));
}

/// Scripts of random operations on inputs that hurt: integer grids (collinear and cocircular
/// points), near-duplicates, and the same turned by 30 degrees so that nothing is round.
class RandomScript : public testing::TestWithParam<std::tuple<int, bool>> {};

TEST_P(RandomScript, KeepsEveryInvariant) {
    const auto [seed, turned] = GetParam();
    SCOPED_TRACE(testing::Message() << "seed " << seed << " turned " << turned);
    std::mt19937 random(static_cast<unsigned>(seed));
    const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
    Triangulation t({-20, -20}, {20, 20});
    std::vector<VertexId> vertices{VertexId{0}, VertexId{1}, VertexId{2}, VertexId{3}};
    const double c = turned ? std::cos(std::numbers::pi / 6) : 1, s = turned ? .5 : 0;
    for (int step = 0; step < 150; ++step) {
        const Edges before = edges_of(t);
        const auto pick = [&] {
            return vertices[static_cast<std::size_t>(below(static_cast<int>(vertices.size())))];
        };
        const int kind = below(10);
        if (kind < 6) {
            dvec2 p(below(17) - 8, below(17) - 8);
            if (kind == 5) p += 1e-9 * dvec2(below(3) - 1, below(3) - 1);  // near-duplicates
            const auto insertion = t.insert({c * p.x - s * p.y, s * p.x + c * p.y}, pick());
            if (insertion.fresh) vertices.push_back(insertion.vertex);
        } else if (kind < 8) {
            t.constrain(pick(), pick());
        } else {
            std::vector<std::pair<VertexId, VertexId>> constrained;
            t.for_each_edge([&](VertexId a, VertexId b, bool is) {
                if (is && glm::distance(t.position(a), t.position(b)) > .1)
                    constrained.emplace_back(a, b);
            });
            if (kind == 8 && !constrained.empty()) {
                const auto [a, b] = constrained[static_cast<std::size_t>(
                    below(static_cast<int>(constrained.size())))];
                t.split(a, b, (t.position(a) + t.position(b)) / 2.);
            } else {
                const VertexId v = pick();
                if (!t.on_constraint(v) && !t.on_border(v)) {
                    t.remove(v);
                    std::erase(vertices, v);
                }
            }
        }
        ASSERT_TRUE(holds(t, 1600)) << "step " << step << " kind " << kind;
        ASSERT_TRUE(touched_all(before, t)) << "step " << step << " kind " << kind;
    }
    EXPECT_GT(t.constraints(), 10u);
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomScript,
                         testing::Combine(testing::Range(1, 13), testing::Bool()));

TEST(Triangulation, DoesNotDependOnTheOrderOfInsertion) {
    // Points in general position have one Delaunay triangulation; so have cocircular ones here,
    // because ties are broken by position alone.
    std::vector<dvec2> points;
    for (int y = 1; y < 9; ++y)
        for (int x = 1; x < 9; ++x) points.emplace_back(x, y);
    const auto edges = [&](unsigned seed) {
        std::mt19937 random(seed);
        std::shuffle(points.begin(), points.end(), random);
        Triangulation t({0, 0}, {9, 9});
        for (dvec2 p : points) t.insert(p, VertexId{0});
        std::vector<std::array<double, 4>> found;
        t.for_each_edge([&](VertexId a, VertexId b, bool) {
            dvec2 p = t.position(a), q = t.position(b);
            if (std::tie(q.x, q.y) < std::tie(p.x, p.y)) std::swap(p, q);
            found.push_back({p.x, p.y, q.x, q.y});
        });
        std::sort(found.begin(), found.end());
        return found;
    };
    EXPECT_EQ(edges(1), edges(2));
}

TEST(Predicates, OrientationKeepsItsLawsOnNearTies) {
    std::mt19937 random(7);
    std::uniform_int_distribution<int> ulp(-2, 2);
    for (int i = 0; i < 2000; ++i) {
        // Points within some units in the last place of a line: a plain determinant errs here.
        const auto near_line = [&](double s) {
            return dvec2(.5 + s + ulp(random) * 0x1p-53, .5 + s + ulp(random) * 0x1p-53);
        };
        const dvec2 a = near_line(0), b = near_line(12), c = near_line(24);
        const int o = orientation(a, b, c);
        ASSERT_EQ(o, orientation(b, c, a));
        ASSERT_EQ(o, -orientation(b, a, c));
        // The exact determinant in 128-bit integers; coordinates are multiples of 2^-53.
        const auto exact = [](double v) { return static_cast<Wide>(std::ldexp(v, 53)); };
        const Wide det = (exact(b.x) - exact(a.x)) * (exact(c.y) - exact(a.y)) -
                         (exact(b.y) - exact(a.y)) * (exact(c.x) - exact(a.x));
        ASSERT_EQ(o, det > 0 ? 1 : det < 0 ? -1 : 0) << "i " << i;
    }
}

}  // namespace
}  // namespace povpreview
