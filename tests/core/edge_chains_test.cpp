// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/edge_chains.h"

#include <gtest/gtest.h>

#include <cmath>
#include <ctime>
#include <glm/geometric.hpp>
#include <limits>
#include <random>

#include "core/polyline.h"
#include "tests/core/painted_cards.h"

namespace povpreview {
namespace {

using glm::dvec2;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
/// How far a piece may be from a chain: see chain_edges().
constexpr double reach = 2 * chain_snap + chain_flatness;

/// What this process has computed for: other work on the machine does not count.
double computing_s() { return double(std::clock()) / CLOCKS_PER_SEC; }

ImageEdge piece(dvec2 from, dvec2 to, EdgeKind kind = EdgeKind::geometric, std::uint16_t light = 0,
                float importance = 1) {
    return {from, to, kind, light, importance};
}

double distance_to(const std::vector<EdgeChain>& chains, dvec2 p) {
    double least = 1e9;
    for (const EdgeChain& chain : chains)
        for (std::size_t i = 1; i < chain.vertices.size(); ++i)
            least =
                std::min(least, distance_to_segment(p, chain.vertices[i - 1], chain.vertices[i]));
    return least;
}
double distance_to(const std::vector<ImageEdge>& pieces, dvec2 p) {
    double least = 1e9;
    for (const ImageEdge& e : pieces) least = std::min(least, distance_to_segment(p, e.from, e.to));
    return least;
}

/// Every point of the pieces is near a chain and the other way round.
void expect_same_edges(const std::vector<ImageEdge>& pieces, const std::vector<EdgeChain>& chains,
                       dvec2 size) {
    const auto inside = [&](dvec2 p) {
        return p.x > reach && p.y > reach && p.x < size.x - reach && p.y < size.y - reach;
    };
    for (const ImageEdge& e : pieces) {
        if (glm::distance(e.from, e.to) < chain_snap) continue;  // may have become a point
        for (double t : {0., .3, .7, 1.}) {
            const dvec2 p = e.from + t * (e.to - e.from);
            if (!inside(p)) continue;
            ASSERT_LE(distance_to(chains, p), reach + 1e-9) << "a piece at " << p.x << ", " << p.y;
        }
    }
    for (const EdgeChain& chain : chains)
        for (std::size_t i = 1; i < chain.vertices.size(); ++i)
            for (double t : {0., .3, .7, 1.}) {
                const dvec2 p = glm::mix(chain.vertices[i - 1], chain.vertices[i], t);
                ASSERT_LE(distance_to(pieces, p), reach + 1e-9)
                    << "a chain at " << p.x << ", " << p.y;
            }
}

void expect_well_formed(const std::vector<EdgeChain>& chains, dvec2 size) {
    for (std::size_t i = 0; i < chains.size(); ++i) {
        const EdgeChain& chain = chains[i];
        ASSERT_GE(chain.vertices.size(), 2u);
        ASSERT_TRUE(i == 0 || chain.weight <= chains[i - 1].weight);
        for (std::size_t k = 0; k < chain.vertices.size(); ++k) {
            const dvec2 p = chain.vertices[k];
            ASSERT_TRUE(p.x >= 0 && p.y >= 0 && p.x <= size.x && p.y <= size.y);
            ASSERT_TRUE(k == 0 || p != chain.vertices[k - 1]);
        }
    }
}

std::size_t count_vertices(const std::vector<EdgeChain>& chains) {
    std::size_t count = 0;
    for (const EdgeChain& chain : chains) count += chain.vertices.size();
    return count;
}

TEST(ChainEdges, FragmentsOfOneLineBecomeOneChainOfTwoVertices) {
    const dvec2 a(10.3, 20.7), b(180.1, 77.9);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> place(0, 1);
    std::vector<ImageEdge> pieces{piece(a, a + .6 * (b - a)), piece(b, a + .4 * (b - a))};
    for (int i = 0; i < 200; ++i)
        pieces.push_back(piece(a + place(random) * (b - a), a + place(random) * (b - a)));
    const auto chains = chain_edges(pieces, {200, 100});
    ASSERT_EQ(chains.size(), 1u);
    ASSERT_EQ(chains[0].vertices.size(), 2u);
    EXPECT_LT(
        std::min(glm::distance(chains[0].vertices[0], a), glm::distance(chains[0].vertices[0], b)),
        chain_snap);
    EXPECT_NEAR(chains[0].weight, glm::distance(a, b), 2 * chain_snap) << "counted once";
}

TEST(ChainEdges, LinesRunStraightOnThroughTheEndsOfOthers) {
    std::vector<ImageEdge> pieces;
    for (int i = 0; i < 10; ++i) {
        pieces.push_back(piece({10 + 10. * i, 50}, {20 + 10. * i, 50}));
        if (i < 9) pieces.push_back(piece({20 + 10. * i, 50}, {25 + 10. * i, 80}));
    }
    const auto chains = chain_edges(pieces, {200, 100});
    ASSERT_EQ(chains.size(), 10u);
    EXPECT_EQ(chains[0].vertices.size(), 2u);
    EXPECT_NEAR(glm::distance(chains[0].vertices[0], chains[0].vertices[1]), 100, 1e-9);
}

TEST(ChainEdges, KindsAndLightsAreNotMixed) {
    const std::vector<ImageEdge> pieces{piece({10, 10}, {20, 10}, EdgeKind::geometric),
                                        piece({20, 10}, {30, 10}, EdgeKind::shadow),
                                        piece({30, 10}, {40, 10}, EdgeKind::shadow, 1),
                                        piece({40, 10}, {50, 10}, EdgeKind::reflection)};
    const auto chains = chain_edges(pieces, {100, 100});
    ASSERT_EQ(chains.size(), 4u);
    for (const ImageEdge& p : pieces)
        EXPECT_EQ(std::count_if(
                      chains.begin(), chains.end(),
                      [&](const EdgeChain& c) { return c.kind == p.kind && c.light == p.light; }),
                  1);
    // Where two coincide, the shadow is hidden by the surface's border.
    const auto one = chain_edges({piece({10, 10}, {60, 10}, EdgeKind::shadow),
                                  piece({60, 10}, {10, 10}, EdgeKind::geometric)},
                                 {100, 100});
    ASSERT_EQ(one.size(), 1u);
    EXPECT_EQ(one[0].kind, EdgeKind::geometric);
}

TEST(ChainEdges, RoundThingsBecomeClosedChainsOfFewVertices) {
    std::vector<ImageEdge> pieces;
    const auto at = [](int i) {
        const double a = 2 * std::numbers::pi * i / 400;
        return dvec2(100, 100) + 60. * dvec2(std::cos(a), std::sin(a));
    };
    for (int i = 0; i < 400; ++i) pieces.push_back(piece(at(i), at(i + 1)));
    const auto chains = chain_edges(pieces, {200, 200});
    ASSERT_EQ(chains.size(), 1u);
    EXPECT_EQ(chains[0].vertices.front(), chains[0].vertices.back());
    EXPECT_LT(chains[0].vertices.size(), 70u);
    EXPECT_GT(chains[0].vertices.size(), 20u);
    expect_same_edges(pieces, chains, {200, 200});
}

TEST(ChainEdges, ARingKeepsItsCorners) {
    const std::vector<ImageEdge> pieces{piece({55, 20}, {90, 20}), piece({90, 20}, {90, 70}),
                                        piece({20, 20}, {55, 20}), piece({20, 70}, {20, 20}),
                                        piece({90, 70}, {20, 70})};
    const auto chains = chain_edges(pieces, {100, 100});
    ASSERT_EQ(chains.size(), 1u);
    EXPECT_EQ(chains[0].vertices.size(), 5u) << "four corners, the first of them twice";
}

TEST(ChainEdges, ClipsToTheImageAndDropsItsBorder) {
    const auto chains = chain_edges(
        {piece({-50, 50}, {150, 50}), piece({-10, 5}, {-10, 90}), piece({0, 10}, {0, 90}),
         piece({.1, 10}, {.1, 90}), piece({20, 100}, {30, 99.9}), piece({-5, 110}, {110, -5})},
        {100, 100});
    expect_well_formed(chains, {100, 100});
    ASSERT_EQ(chains.size(), 2u);
    EXPECT_NEAR(chains[1].weight, 100, 1e-4);
}

TEST(ChainEdges, WhatIsNoNumberIsDropped) {
    const double infinity = std::numeric_limits<double>::infinity();
    const auto chains = chain_edges(
        {piece({nan, 50}, {150, 50}), piece({10, 50}, {50, nan}), piece({10, 50}, {infinity, 50}),
         piece({10, 20}, {40, 20}, EdgeKind::shadow, 0, static_cast<float>(nan)),
         piece({10, 20}, {40, 20}, EdgeKind::shadow, 0, -1), piece({10, 80}, {40, 80}),
         piece({30, 30}, {30, 30}), piece({-1e300, -1e300}, {1e300, 1e300})},
        {100, 100});
    expect_well_formed(chains, {100, 100});
    EXPECT_GE(chains.size(), 1u);
    EXPECT_LT(distance_to(chains, {25, 80}), .01);
}

class CardFragments : public testing::TestWithParam<unsigned> {};

TEST_P(CardFragments, BecomeFewChainsInTheSamePlaces) {
    SCOPED_TRACE(testing::Message() << "seed " << GetParam());
    const dvec2 size(320, 240);
    const PaintedCards cards(size, 60, GetParam());
    std::vector<ImageEdge> pieces = cards.fragments(GetParam() + 100);
    const auto chains = chain_edges(pieces, {320, 240});
    expect_well_formed(chains, size);
    expect_same_edges(pieces, chains, size);
    EXPECT_LT(chains.size(), cards.edges().size());
    // Up to what two straight lines have in common, fragments make no difference.
    const auto whole = chain_edges(cards.edges(), {320, 240});
    EXPECT_LT(count_vertices(chains), count_vertices(whole) * 5 / 4);

    const auto again = chain_edges(pieces, {320, 240});
    ASSERT_EQ(again.size(), chains.size());
    for (std::size_t i = 0; i < chains.size(); ++i) {
        EXPECT_EQ(again[i].vertices, chains[i].vertices);
        EXPECT_EQ(again[i].weight, chains[i].weight);
    }
}

INSTANTIATE_TEST_SUITE_P(Seeds, CardFragments, testing::Range(1u, 6u));

TEST(ChainEdges, ManyPiecesTakeLittleTime) {
    // A hundred thousand, of the lengths that pieces of cluttered scenes have.
    std::mt19937 random(11);
    std::uniform_real_distribution<double> x(0, 640), y(0, 480), step(-6, 6);
    std::vector<ImageEdge> pieces;
    for (int i = 0; i < 100'000; ++i) {
        const dvec2 p(x(random), y(random));
        pieces.push_back(piece(p, p + dvec2(step(random), step(random))));
    }
    const double begin = computing_s();
    const auto chains = chain_edges(pieces, {640, 480});
    EXPECT_LT(computing_s() - begin, 5) << "a tenth of it in a release build";
    expect_well_formed(chains, {640, 480});
}

/// Pieces that a broken scene may give: each must end, and soon.
TEST(ChainEdges, HostilePiecesEndSoon) {
    std::mt19937 random(12);
    std::uniform_real_distribution<double> unit(0, 1);
    std::vector<ImageEdge> in_a_pixel, through_a_point, everywhere, zigzag;
    for (int i = 0; i < 50'000; ++i) {
        in_a_pixel.push_back(piece(dvec2(50) + dvec2(unit(random), unit(random)),
                                   dvec2(50) + dvec2(unit(random), unit(random))));
        const dvec2 d(std::cos(i * .01), std::sin(i * .01));
        through_a_point.push_back(piece(dvec2(50) + 40. * d, dvec2(50) - 40. * d));
        everywhere.push_back(piece(100. * dvec2(unit(random), unit(random)),
                                   100. * dvec2(unit(random), unit(random))));
        zigzag.push_back(piece({i * .002, i % 2 ? 99 : 1}, {(i + 1) * .002, i % 2 ? 1 : 99}));
    }
    const double begin = computing_s();
    for (const auto* pieces : {&in_a_pixel, &through_a_point, &everywhere, &zigzag})
        expect_well_formed(chain_edges(*pieces, {100, 100}), {100, 100});
    EXPECT_LT(computing_s() - begin, 20);
    EXPECT_LE(chain_edges(in_a_pixel, {100, 100}).size(), 100u);
}

}  // namespace
}  // namespace povpreview
