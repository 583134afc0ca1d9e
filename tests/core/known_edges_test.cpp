// SPDX-License-Identifier: AGPL-3.0-or-later
//
// The mesh previewer with edges that are known without tracing.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/common.hpp>
#include <limits>
#include <random>

#include "core/edge_chains.h"
#include "core/mesh_previewer.h"
#include "core/session.h"
#include "tests/core/painted_cards.h"
#include "tests/core/rasteriser.h"

namespace povpreview {
namespace {

using namespace std::chrono_literals;
using glm::dvec2;
using glm::vec3;

void run(Previewer& previewer, SampleOracle& oracle, std::size_t limit) {
    Session session(previewer, oracle);
    session.limit_full(limit);
    while (session.advance(1ms)) {
    }
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

class KnownEdges : public testing::TestWithParam<unsigned> {};

TEST_P(KnownEdges, AreWorthAThirdOfTheErrorAtEqualSamples) {
    SCOPED_TRACE(testing::Message() << "seed " << GetParam());
    constexpr int width = 320, height = 240;
    const PaintedCards cards({width, height}, 60, GetParam());
    const FunctionImage image = cards.image();
    for (std::size_t samples : {1000u, 2000u, 6000u}) {
        double errors[2];
        for (bool known : {false, true}) {
            MeshPreviewer previewer(width, height);
            FunctionOracle oracle(image);
            if (known)
                previewer.accept_edges(
                    chain_edges(cards.fragments(GetParam() + 100), {width, height}));
            run(previewer, oracle, samples);
            errors[known] = displayed_error(previewer.picture(Overlay::none), image);
            EXPECT_EQ(previewer.validate(), "");
        }
        EXPECT_LT(errors[true], errors[false] / 3) << samples << " samples";
    }
}

/// Chains that come bit by bit, in any order, while samples are traced.
TEST_P(KnownEdges, MayComeAtAnyTime) {
    SCOPED_TRACE(testing::Message() << "seed " << GetParam());
    constexpr int width = 120, height = 90;
    const PaintedCards cards({width, height}, 25, GetParam(), .5);
    const FunctionImage image = cards.image();
    std::vector<ImageEdge> pieces = cards.fragments(GetParam() + 100);
    MeshPreviewer previewer(width, height);
    FunctionOracle oracle(image, GetParam());
    Session session(previewer, oracle);
    std::mt19937 random(GetParam());
    std::size_t most = 0;
    for (int round = 0; session.advance(1ms); ++round) {
        const std::size_t count = std::min<std::size_t>(pieces.size(), random() % 40);
        std::vector<ImageEdge> some(pieces.end() - static_cast<std::ptrdiff_t>(count),
                                    pieces.end());
        pieces.resize(pieces.size() - count);
        previewer.accept_edges(chain_edges(some, {width, height}));
        if (round < 60 || round % 64 == 0) {
            ASSERT_EQ(previewer.validate(), "") << "round " << round;
        }
        most = std::max(most, previewer.statistics().constraints);
    }
    EXPECT_TRUE(pieces.empty());
    EXPECT_GT(most, 100u);
    EXPECT_TRUE(previewer.done());
    EXPECT_EQ(displayed_error(previewer.picture(Overlay::none), image), 0);
    // Once all is filled, edges are of no use.
    previewer.accept_edges(chain_edges(cards.edges(), {width, height}));
    EXPECT_FALSE(previewer.next());
    EXPECT_TRUE(previewer.done());
}

INSTANTIATE_TEST_SUITE_P(Seeds, KnownEdges, testing::Range(1u, 5u));

TEST(KnownEdgesOf, EveryKindKeepItThroughSplitsAndCrossings) {
    constexpr int size = 200;
    const FunctionImage image = images::still_life(size, size);
    MeshPreviewer previewer(size, size);
    FunctionOracle oracle(image);
    previewer.accept_edges({{{{20, 60}, {180, 60.5}}, EdgeKind::geometric, 0, 4},
                            {{{100, 10}, {101, 190}}, EdgeKind::shadow, 7, 3},
                            {{{20, 20}, {180, 180}}, EdgeKind::reflection, 2, 2},
                            // On top of the first, in part, and beyond.
                            {{{100, 60.25}, {195, 60.546875}}, EdgeKind::shadow, 1, 1}});
    run(previewer, oracle, 3000);
    ASSERT_EQ(previewer.validate(), "");
    double lengths[edge_kinds] = {};
    std::size_t counts[edge_kinds] = {};
    for (const Picture::Line& line : previewer.picture(Overlay::edges).lines) {
        ASSERT_TRUE(line.constraint);
        lengths[std::size_t(line.kind)] += glm::distance(line.from, line.to);
        ++counts[std::size_t(line.kind)];
        if (line.kind == EdgeKind::shadow) {
            EXPECT_EQ(line.light, std::min(line.from.x, line.to.x) > 110 ? 1 : 7);
        }
        if (line.kind == EdgeKind::reflection) {
            EXPECT_EQ(line.light, 2);
        }
    }
    EXPECT_NEAR(lengths[0], 160, .1);
    EXPECT_NEAR(lengths[1], 180 + 15, .5);
    EXPECT_NEAR(lengths[2], 160 * std::sqrt(2), .5);
    EXPECT_GT(counts[0], 3u) << "split";
    const Statistics statistics = previewer.statistics();
    std::size_t sum = 0;
    for (std::size_t kind = 0; kind < edge_kinds; ++kind) {
        EXPECT_EQ(statistics.constraints_by_kind[kind], counts[kind]);
        sum += counts[kind];
    }
    EXPECT_EQ(statistics.constraints, sum);
}

TEST(KnownEdgesOf, NoVisibleJumpAttractNoSamples) {
    // Edges everywhere in an even image: samples stay as evenly spread as without.
    const FunctionImage image = images::constant(vec3(.4f));
    std::mt19937 random(3);
    std::uniform_real_distribution<double> place(0, 200);
    std::vector<ImageEdge> pieces;
    for (int i = 0; i < 12; ++i)
        pieces.push_back({{place(random), place(random)}, {place(random), place(random)}});
    MeshPreviewer previewer(200, 200);
    FunctionOracle oracle(image);
    previewer.accept_edges(chain_edges(pieces, {200, 200}));
    run(previewer, oracle, 1500);
    EXPECT_EQ(previewer.validate(), "");
    std::size_t beside = 0;
    for (const Request& request : oracle.asked)
        if (request.position - glm::floor(request.position) != dvec2(.5)) ++beside;
    EXPECT_LT(beside, oracle.asked.size() / 4);
}

TEST(KnownEdgesOf, OtherMethodsAreDropped) {
    const FunctionImage image = images::still_life(80, 60);
    MeshPreviewer plain(80, 60, {.constraints = false});
    FunctionOracle oracle(image);
    plain.accept_edges({{{{10, 10}, {70, 50}}, EdgeKind::geometric, 0, 4}});
    run(plain, oracle, 1000);
    EXPECT_EQ(plain.statistics().constraints, 0u);
}

/// Chains that no finder should give, but that one with a fault might.
TEST(KnownEdgesOf, HostileKindsDoNoHarm) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr int size = 60;
    const FunctionImage image = images::still_life(size, size);
    std::mt19937 random(12);
    std::uniform_real_distribution<double> unit(0, 1);
    std::vector<std::vector<EdgeChain>> sets(5);
    for (int i = 0; i < 1500; ++i) {
        const double a = i * .37;
        const auto anywhere = [&] { return dvec2(unit(random), unit(random)); };
        const auto add = [&](std::size_t set, std::vector<dvec2> line) {
            sets[set].push_back({std::move(line), EdgeKind(i % 4), 0, float(unit(random))});
        };
        add(0, {{5, 5}, {50, 40.5}});
        add(1, {dvec2(30), dvec2(30) + 25. * dvec2(std::cos(a), std::sin(a))});
        add(2, {dvec2(31) + anywhere(), dvec2(31) + anywhere(), dvec2(31) + anywhere()});
        add(3, {double(size) * anywhere(), double(size) * anywhere()});
        if (i < 20) {
            add(4, {{nan, 5}, {50, 40.5}});
            add(4, {{-20, -30}, {500, 40.5}});
            add(4, {{7, 7}});
            add(4, {});
            add(4, {{7, 7}, {7, 7}, {7, 7}});
            add(4, {{0, 0}, {size, 0}, {size, size}, {0, size}, {0, 0}});
            add(4, {{1e300, 3}, {INFINITY, 4}});
        }
    }
    for (std::size_t set = 0; set < sets.size(); ++set) {
        SCOPED_TRACE(testing::Message() << "set " << set);
        MeshPreviewer previewer(size, size);
        FunctionOracle oracle(image, 5);
        previewer.accept_edges(std::move(sets[set]));
        Session session(previewer, oracle);
        for (int round = 0; session.advance(1ms); ++round)
            if (round < 20 || round % 64 == 0) {
                ASSERT_EQ(previewer.validate(), "") << "round " << round;
            }
        EXPECT_TRUE(previewer.done());
        EXPECT_EQ(displayed_error(previewer.picture(Overlay::none), image), 0);
    }
}

}  // namespace
}  // namespace povpreview
