// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/mesh_previewer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <set>

#include "core/session.h"
#include "tests/core/function_oracle.h"
#include "tests/core/rasteriser.h"

namespace povpreview {
namespace {

using namespace std::chrono_literals;
using glm::dvec2;
using glm::vec3;

/// Runs to completion, or to a number of full rays.
Session::Counts run(Previewer& previewer, SampleOracle& oracle,
                    std::size_t limit = std::numeric_limits<std::size_t>::max()) {
    Session session(previewer, oracle);
    session.limit_full(limit);
    while (session.advance(1ms)) {
    }
    return session.counts();
}

/// Mean absolute error of displayed colour against the image itself at the pixel centres.
double displayed_error(const Picture& picture, const FunctionImage& image) {
    const std::vector<vec3> shown = rasterise(picture);
    double sum = 0;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const vec3 d = display_encoded(shown[static_cast<std::size_t>(y * picture.width + x)]) -
                           display_encoded(image.colour({x + .5, y + .5}));
            sum += (std::abs(d.x) + std::abs(d.y) + std::abs(d.z)) / 3;
        }
    return sum / (picture.width * picture.height);
}

testing::AssertionResult every_pixel_is_its_own(const Picture& picture,
                                                const FunctionImage& image) {
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const auto i = static_cast<std::size_t>(y * picture.width + x);
            if (!picture.known[i] || picture.pixels[i] != image.colour({x + .5, y + .5}))
                return testing::AssertionFailure() << "pixel " << x << ", " << y;
        }
    return testing::AssertionSuccess();
}

struct Case {
    const char* name;
    int width, height;
    FunctionImage image;
};
std::ostream& operator<<(std::ostream& out, const Case& c) { return out << c.name; }

class Completion : public testing::TestWithParam<std::tuple<Case, bool>> {};

TEST_P(Completion, ShowsEveryPixelsOwnSampleTracedOnce) {
    const auto& [c, constraints] = GetParam();
    MeshOptions options;
    options.constraints = constraints;
    MeshPreviewer previewer(c.width, c.height, options);
    FunctionOracle oracle(c.image, 5);
    const auto counts = run(previewer, oracle);
    ASSERT_TRUE(previewer.done());
    EXPECT_TRUE(every_pixel_is_its_own(previewer.picture(Overlay::none), c.image));
    const auto pixels = static_cast<std::size_t>(c.width) * static_cast<std::size_t>(c.height);
    EXPECT_EQ(previewer.statistics().filled, pixels);
    // One ray for each pixel; the rest is one-sided samples along constraints.
    std::multiset<std::pair<double, double>> centres;
    std::size_t others = 0;
    for (const Request& request : oracle.asked) {
        if (request.kind != RayKind::full) continue;
        const dvec2 offset = request.position - glm::floor(request.position);
        if (offset == dvec2(.5))
            centres.emplace(request.position.x, request.position.y);
        else
            ++others;
    }
    EXPECT_EQ(counts.full, centres.size() + others);
    EXPECT_EQ(std::set(centres.begin(), centres.end()).size(), pixels);
    EXPECT_LE(counts.full, pixels + pixels / 8 + 200);
    if (!constraints) {
        EXPECT_EQ(counts.full, pixels);
    }
    EXPECT_EQ(previewer.validate(), "");
}

INSTANTIATE_TEST_SUITE_P(
    Images, Completion,
    testing::Combine(testing::Values(Case{"1x1", 1, 1, images::constant({.1f, .2f, 3})},
                                     Case{"1x7", 1, 7, images::checker(2)},
                                     Case{"7x1", 7, 1, images::checker(2)},
                                     Case{"2x2", 2, 2, images::checker(1)},
                                     Case{"3x1000", 3, 1000, images::disc({1, 500}, 200)},
                                     Case{"17x9", 17, 9, images::disc({8, 4}, 3)},
                                     Case{"constant", 64, 48, images::constant(vec3(.5f))},
                                     Case{"checker", 120, 90, images::checker(7)},
                                     Case{"fine checker", 100, 100, images::checker(1)},
                                     Case{"still life", 200, 150, images::still_life(200, 150)}),
                     testing::Bool()));

TEST(MeshPreviewer, DependsOnTheAnswersAloneNotOnTheirGrouping) {
    const FunctionImage image = images::still_life(160, 120);
    std::vector<std::pair<double, double>> first;
    for (std::uint32_t seed : {0u, 1u, 2u, 3u}) {
        MeshPreviewer previewer(160, 120);
        FunctionOracle oracle(image, seed);
        run(previewer, oracle, 9000);
        std::vector<std::pair<double, double>> asked;
        for (const Request& r : oracle.asked) asked.emplace_back(r.position.x, r.position.y);
        if (seed == 0) first = asked;
        ASSERT_EQ(asked.size(), first.size());
        EXPECT_EQ(asked, first) << "grouping seed " << seed;
    }
}

TEST(MeshPreviewer, ErrorFallsWithSamples) {
    const FunctionImage image = images::still_life(320, 240);
    MeshPreviewer previewer(320, 240);
    FunctionOracle oracle(image, 9);
    Session session(previewer, oracle);
    double last = std::numeric_limits<double>::infinity();
    for (std::size_t goal : {1000u, 3000u, 9000u, 27000u, 76800u}) {
        while (session.counts().full < goal && session.advance(1ms)) {
        }
        const double error = displayed_error(previewer.picture(Overlay::none), image);
        EXPECT_LT(error, last) << goal << " samples";
        last = error;
    }
    while (session.advance(1ms)) {
    }
    EXPECT_EQ(displayed_error(previewer.picture(Overlay::none), image), 0);
}

TEST(MeshPreviewer, KeepsItsInvariantsAtEveryStep) {
    const FunctionImage image = images::still_life(96, 72);
    MeshPreviewer previewer(96, 72);
    FunctionOracle oracle(image, 4);
    Session session(previewer, oracle);
    int steps = 0;
    do {
        if (++steps % 4 == 0) {
            ASSERT_EQ(previewer.validate(), "") << "round " << steps;
        }
    } while (session.advance(1ms));
    EXPECT_GT(steps, 40);
}

TEST(MeshPreviewer, TrianglesCoverTheImageFromTheFirstAnswer) {
    for (const auto& [w, h] : {std::pair{40, 30}, {1, 7}, {5, 1}, {2, 2}}) {
        MeshPreviewer previewer(w, h);
        const auto request = previewer.next();
        ASSERT_TRUE(request);
        previewer.accept(images::constant(vec3(.25f)).sample(*request));
        Picture picture = previewer.picture(Overlay::none);
        picture.known.clear();
        for (const vec3& c : rasterise(picture)) EXPECT_NEAR(c.x, .25f, 1e-6);
    }
}

TEST(MeshPreviewer, WindowMayHoldThousandsBeforeTheFirstAnswer) {
    const FunctionImage image = images::still_life(320, 240);
    MeshPreviewer previewer(320, 240);
    std::deque<Request> outstanding;
    std::size_t most = 0, answered = 0;
    while (!previewer.done()) {
        while (outstanding.size() < 10000) {
            const auto request = previewer.next();
            if (!request) break;
            outstanding.push_back(*request);
        }
        most = std::max(most, outstanding.size());
        ASSERT_FALSE(outstanding.empty()) << "waits for nothing after " << answered;
        previewer.accept(image.sample(outstanding.front()));
        outstanding.pop_front();
        ++answered;
    }
    EXPECT_GE(most, 9000u);
    EXPECT_TRUE(every_pixel_is_its_own(previewer.picture(Overlay::none), image));
}

/// Failed and non-finite samples count, never become vertices, and leave no hole in the picture.
class Faulty : public testing::TestWithParam<bool> {};

TEST_P(Faulty, SamplesTakeTheirValueFromTheirNeighbours) {
    const bool fails = GetParam();
    FunctionImage image = images::constant({.4f, .5f, .6f});
    const auto bad = [](dvec2 p) { return std::fmod(p.x * 7 + p.y * 13, 11) < 2 || p.x < 1; };
    if (fails)
        image.fails = bad;
    else
        image.colour = [=](dvec2 p) {
            return bad(p) ? vec3(NAN, INFINITY, 0) : vec3(.4f, .5f, .6f);
        };
    MeshPreviewer previewer(80, 60);
    FunctionOracle oracle(image, 3);
    const auto counts = run(previewer, oracle);
    EXPECT_TRUE(previewer.done());
    EXPECT_EQ(counts.full, 4800u);
    EXPECT_EQ(counts.failed > 0, fails);
    EXPECT_LT(previewer.statistics().filled, 4800u);
    for (const vec3& c : rasterise(previewer.picture(Overlay::none))) {
        ASSERT_NEAR(c.x, .4f, 1e-5);
        ASSERT_NEAR(c.z, .6f, 1e-5);
    }
    EXPECT_EQ(previewer.validate(), "");
}

INSTANTIATE_TEST_SUITE_P(FailedOrNotFinite, Faulty, testing::Bool());

TEST(MeshPreviewer, EndsWhereEverySampleFails) {
    FunctionImage image = images::constant(vec3(1));
    image.fails = [](dvec2) { return true; };
    MeshPreviewer previewer(30, 20);
    FunctionOracle oracle(image);
    run(previewer, oracle);
    EXPECT_TRUE(previewer.done());
    for (const vec3& c : rasterise(previewer.picture(Overlay::none))) ASSERT_EQ(c, vec3(0));
}

TEST(MeshPreviewer, FillsSquaresWhereSamplesAreDense) {
    // Noise in one corner, nothing elsewhere: that corner's squares are filled first.
    const FunctionImage image{[](dvec2 p) {
        const double noise = std::sin(p.x * 12.9898 + p.y * 78.233) * 43758.5453;
        return p.x < 64 && p.y < 64 ? vec3(static_cast<float>(noise - std::floor(noise)))
                                    : vec3(.5f);
    }};
    MeshPreviewer previewer(256, 256);
    FunctionOracle oracle(image);
    run(previewer, oracle, 6000);
    const Picture picture = previewer.picture(Overlay::none);
    std::size_t noisy = 0, blank = 0;
    for (std::size_t i = 0; i < picture.known.size(); ++i)
        if (picture.known[i]) ++(i % 256 < 64 && i / 256 < 64 ? noisy : blank);
    EXPECT_GT(noisy, 3000u);
    EXPECT_LT(blank, 600u);
}

TEST(MeshPreviewer, TracedOutlinesBecomeConstraintsAndPayForThemselves) {
    const FunctionImage image = images::disc({160, 120}, 70);
    constexpr int samples = 4000;  // the outline's hundred probes wait for one another
    double errors[2];
    for (bool constraints : {false, true}) {
        MeshOptions options;
        options.constraints = constraints;
        MeshPreviewer previewer(320, 240, options);
        FunctionOracle oracle(image);
        const auto counts = run(previewer, oracle, samples);
        errors[constraints] = displayed_error(previewer.picture(Overlay::none), image);
        EXPECT_EQ(previewer.validate(), "");
        if (!constraints) {
            EXPECT_EQ(counts.probe, 0u);
            EXPECT_EQ(previewer.statistics().constraints, 0u);
            continue;
        }
        // The budget: a share of the pixels in advance and a share of the full rays.
        EXPECT_LE(static_cast<double>(counts.probe),
                  options.outline_floor * 320 * 240 + options.outline_share * samples + 1);
        EXPECT_GT(previewer.statistics().constraints, 10u);
        // Every constraint keeps to the circle, and the chain goes all around.
        double length = 0;
        for (const auto& line : previewer.picture(Overlay::edges).lines) {
            EXPECT_TRUE(line.constraint);
            EXPECT_NEAR(glm::distance(line.from, glm::vec2(160, 120)), 70, .6);
            length += glm::distance(line.from, line.to);
        }
        EXPECT_NEAR(length, 2 * 3.14159265 * 70, 4);
    }
    EXPECT_LT(errors[true], errors[false] / 3);
}

TEST(MeshPreviewer, WrongOutlinesCostSamplesNeverAPixel) {
    // Surfaces that have nothing to do with the colours, of every pattern, and chaotic ones.
    FunctionImage image = images::still_life(150, 110);
    image.surface = [](dvec2 p) {
        if (p.x < 50) return static_cast<std::uint32_t>(std::floor(p.y / 9));
        if (p.x < 100) return static_cast<std::uint32_t>(std::hypot(p.x - 75, p.y - 50) / 6);
        return static_cast<std::uint32_t>(std::abs(std::sin(p.x * 31 + p.y * 57)) * 1e6) % 3;
    };
    MeshPreviewer previewer(150, 110);
    FunctionOracle oracle(image, 6);
    Session session(previewer, oracle);
    for (int round = 0; session.advance(1ms); ++round)
        if (round % 16 == 0) {
            ASSERT_EQ(previewer.validate(), "") << "round " << round;
        }
    EXPECT_TRUE(previewer.done());
    EXPECT_TRUE(every_pixel_is_its_own(previewer.picture(Overlay::none), image));
    EXPECT_GT(session.counts().probe, 100u);
    EXPECT_LT(session.counts().full, 150u * 110u * 9 / 8);
}

TEST(Session, StopsAtTheLimitOfFullRays) {
    MeshPreviewer previewer(100, 100);
    FunctionOracle oracle(images::checker(9), 8);
    EXPECT_EQ(run(previewer, oracle, 1234).full, 1234u);
}

TEST(Session, GoesOnWhereTheLimitIsRaised) {
    const FunctionImage image = images::still_life(100, 80);
    MeshPreviewer previewer(100, 80);
    FunctionOracle oracle(image, 8);
    Session session(previewer, oracle);
    for (std::size_t limit = 500; limit < 20000; limit += 500) {
        session.limit_full(limit);
        while (session.advance(1ms)) {
        }
        ASSERT_LE(session.counts().full, limit);
    }
    EXPECT_TRUE(previewer.done());
}

TEST(Session, PausesAndGoesOn) {
    MeshPreviewer previewer(100, 80);
    FunctionOracle oracle(images::still_life(100, 80), 8);
    Session session(previewer, oracle);
    session.pause_at(700);
    while (session.advance(1ms)) {
    }
    EXPECT_TRUE(session.paused());
    EXPECT_EQ(session.counts().full, 700u);
    session.pause_at(SIZE_MAX);
    EXPECT_FALSE(session.paused());
    while (session.advance(1ms)) {
    }
    EXPECT_TRUE(previewer.done());
}

TEST(EdgeWeight, IsThePapersWhereAskedFor) {
    // Section 2: |v1 - v2| + .3 dr^2 + .59 dg^2 + .11 db^2.
    EXPECT_FLOAT_EQ(colour_distance({1, 0, 0}, {0, 0, 0}), .3f);
    EXPECT_FLOAT_EQ(colour_distance({0, .5f, 0}, {0, 0, 1}), .59f * .25f + .11f);
    EXPECT_FLOAT_EQ(edge_weight(WeightKind::paper, .25f, .3f), .55f);
    EXPECT_FLOAT_EQ(edge_weight(WeightKind::area, .5f, .25f), .25f * (.02f + .5f));
}

TEST(RefinementHeap, GivesTheHeaviestFirstAndBreaksTiesByVertex) {
    RefinementHeap heap;
    heap.push(VertexId{5}, VertexId{2}, 1);
    heap.push(VertexId{1}, VertexId{9}, 1);
    heap.push(VertexId{3}, VertexId{4}, 2);
    EXPECT_EQ(heap.pop()->a, VertexId{3});
    EXPECT_EQ(heap.pop()->a, VertexId{1});
    const auto last = heap.pop();
    EXPECT_EQ(last->a, VertexId{2});
    EXPECT_EQ(last->b, VertexId{5});
    EXPECT_FALSE(heap.pop());
}

/// All that is asked for when rays cost so much, until 2,000 full samples.
std::vector<Request> asked_at_cost(std::uint32_t full_ns, bool by_cost) {
    FunctionImage image = images::still_life(160, 120);
    image.full_ns = full_ns;
    image.albedo_ns = full_ns / 20;
    MeshOptions options;
    options.by_cost = by_cost;
    MeshPreviewer previewer(160, 120, options);
    FunctionOracle oracle(image, 7);
    run(previewer, oracle, 2000);
    return oracle.asked;
}
bool equal(const std::vector<Request>& p, const std::vector<Request>& q) {
    return std::equal(p.begin(), p.end(), q.begin(), q.end(),
                      [](const Request& a, const Request& b) {
                          return a.position == b.position && a.kind == b.kind;
                      });
}

TEST(Costs, AreToldBesideOurOwnWorkByAllThreads) {
    constexpr std::size_t pixels = 640 * 480;
    EXPECT_FALSE(plan_by_cost(60e3, pixels, 2).lattice);
    EXPECT_TRUE(plan_by_cost(60e3, pixels, 8).lattice);
    for (const double ns : {1e3, 5e3, 20e3, 60e3, 300e3}) {
        const CostPlan two = plan_by_cost(ns, pixels, 2), eight = plan_by_cost(4 * ns, pixels, 8);
        EXPECT_EQ(two.lattice, eight.lattice) << ns;
        EXPECT_EQ(two.outlines, eight.outlines) << ns;
        EXPECT_EQ(two.edges, eight.edges) << ns;
        EXPECT_EQ(two.vertex_budget, eight.vertex_budget) << ns;
    }
    EXPECT_GT(albedo_price(1e3, 60e3, 8), albedo_price(1e3, 60e3, 2));
}

TEST(Costs, DecideNothingWhereTheyShallNot) {
    EXPECT_TRUE(equal(asked_at_cost(10, false), asked_at_cost(1'000'000, false)));
    EXPECT_FALSE(equal(asked_at_cost(10, true), asked_at_cost(1'000'000, true)));
}

}  // namespace
}  // namespace povpreview
