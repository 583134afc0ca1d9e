// SPDX-License-Identifier: AGPL-3.0-or-later
//
// The ladder of accuracy: what is learnt between rungs, and that a preview which began low ends at
// the truth.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <memory>
#include <random>

#include "core/colour.h"
#include "core/error.h"
#include "core/fixed_rung.h"
#include "core/ladder.h"
#include "core/mesh_previewer.h"
#include "core/rung_shift.h"
#include "core/session.h"
#include "tests/core/function_oracle.h"
#include "tests/core/rasteriser.h"

namespace povpreview {
namespace {

using namespace std::chrono_literals;
using glm::dvec2;
using glm::vec3;

constexpr double extent = 320;

RungLight shaded(const vec3& albedo, const vec3& illumination, const vec3& remainder = vec3(0)) {
    return {albedo * illumination + remainder, true, albedo, illumination, remainder};
}

float largest(const vec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

// ---- RungShift

TEST(RungShift, KnowsNothingBeforeItHasLearnt) {
    const RungShift shift(extent);
    const RungLight light = shaded(vec3(.5f), vec3(.2f));
    EXPECT_EQ(shift.apply({7, 9}, 1, light).colour, light.colour);
}

TEST(RungShift, WhatIsAddedEverywhereIsSoonAddedEverywhere) {
    RungShift shift(extent);
    std::mt19937 random(11);
    std::uniform_real_distribution<double> place(0, extent);
    const RungLight low = shaded(vec3(.6f), vec3(.1f)), high = shaded(vec3(.6f), vec3(.4f));
    for (int i = 0; i < 100; ++i) shift.learn({place(random), place(random)}, 1, low, high);
    for (int i = 0; i < 50; ++i) {
        const RungLight guess = shift.apply({place(random), place(random)}, 1, low);
        EXPECT_LT(largest(guess.colour - high.colour), .02f);
    }
}

TEST(RungShift, FollowsAShiftThatVariesSmoothly) {
    RungShift shift(extent);
    const auto gain = [](dvec2 p) { return vec3(float(.2 + .3 * p.x / extent), .1f, 0); };
    const RungLight low = shaded(vec3(.5f), vec3(.3f));
    for (int y = 8; y < extent; y += 16)
        for (int x = 8; x < extent; x += 16)
            shift.learn({x, y}, 1, low, shaded(vec3(.5f), low.illumination + gain({x, y})));
    for (double x = 30; x < extent - 30; x += 13) {
        const dvec2 p{x, 150};
        const RungLight guess = shift.apply(p, 1, low);
        EXPECT_LT(largest(guess.illumination - low.illumination - gain(p)), .02f) << x;
    }
}

TEST(RungShift, IsSmoothAlongASurface) {
    RungShift shift(extent);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> place(0, extent);
    const RungLight low = shaded(vec3(1), vec3(.2f));
    for (int i = 0; i < 400; ++i)
        shift.learn({place(random), place(random)}, 1, low,
                    shaded(vec3(1), vec3(random() % 2 ? .3f : .5f)));
    for (double x = 1; x < extent - 1; x += .25) {
        const vec3 here = shift.apply({x, 77}, 1, low).colour;
        const vec3 next = shift.apply({x + .25, 77}, 1, low).colour;
        EXPECT_LT(largest(here - next), .03f) << x;
    }
}

TEST(RungShift, AWhiteWallsGainDoesNotMakeABlackBoxBright) {
    RungShift shift(extent);
    const RungLight wall = shaded(vec3(.9f), vec3(0)), lit = shaded(vec3(.9f), vec3(.8f));
    for (int i = 0; i < 40; ++i) shift.learn({5. * i, 100}, 1, wall, lit);
    const RungLight box = shift.apply({100, 102}, 2, shaded(vec3(.02f), vec3(0)));
    EXPECT_GT(box.illumination.x, .4f);  // the light is shared
    EXPECT_LT(box.colour.x, .02f);
    // Nothing at all is known of the colour of what has no pigment.
    const RungLight sky{.colour = vec3(.3f)};
    EXPECT_EQ(shift.apply({100, 102}, 3, sky).colour, sky.colour);
}

TEST(RungShift, NoColourFallsBelowBlack) {
    RungShift shift(extent);
    for (int i = 0; i < 40; ++i)
        shift.learn({5. * i, 100}, 1, RungLight{.colour = vec3(1)}, RungLight{.colour = vec3(0)});
    EXPECT_EQ(shift.apply({100, 100}, 1, RungLight{.colour = vec3(.2f)}).colour, vec3(0));
}

// ---- the mesh previewer on a ladder

constexpr int width = 160, height = 120;

/// A still life whose lower rungs lack light: the lowest half of it all, the next one a bit.
FunctionImage dear_still_life() {
    FunctionImage image = images::still_life(width, height);
    const auto colour = image.colour;
    const auto dimmed = [colour](double by) {
        return
            [colour, by](dvec2 p) { return colour(p) * float(1 - by * (.5 + .5 * p.x / width)); };
    };
    image.lower = {{dimmed(.6), 20'000}, {dimmed(.1), 200'000}};
    image.full_ns = 4'000'000;
    image.albedo_ns = 4'000'000;
    return image;
}

Ladder three_rungs(bool target_ready) {
    return {{{"sketch"}, {"unprepared"}, {"target", target_ready}}};
}

double displayed_error(const Picture& picture, const FunctionImage& image) {
    const std::vector<vec3> shown = rasterise(picture);
    double sum = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const vec3 d = display_encoded(shown[std::size_t(y * width + x)]) -
                           display_encoded(image.colour({x + .5, y + .5}));
            sum += (std::abs(d.x) + std::abs(d.y) + std::abs(d.z)) / 3;
        }
    return sum / (width * height);
}

/// Advances until so many samples have come or nothing does any more.
void advance(Session& session, std::size_t full) {
    std::size_t before = 0;
    for (int idle = 0; session.counts().full < full && idle < 100;) {
        if (!session.advance(1ms)) return;
        idle = session.counts().full == before ? idle + 1 : 0;
        before = session.counts().full;
    }
}

class RisingPreview : public testing::TestWithParam<bool> {};

TEST_P(RisingPreview, EndsWithEveryPixelAtTheTargetTracedThereOnce) {
    const bool constraints = GetParam();
    const FunctionImage image = dear_still_life();
    MeshOptions options;
    options.constraints = options.detail = constraints;
    MeshPreviewer previewer(width, height, options, three_rungs(false));
    FunctionOracle oracle(image, 3);
    oracle.target_ready = false;
    Session session(previewer, oracle);
    advance(session, 3000);
    EXPECT_GT(previewer.statistics().below_target, 0u);
    EXPECT_EQ(previewer.validate(), "");
    oracle.target_ready = true;
    previewer.accept_ready(target_rung);
    while (session.advance(1ms)) {
    }
    ASSERT_TRUE(previewer.done());
    EXPECT_EQ(previewer.statistics().below_target, 0u);
    const Picture picture = previewer.picture(Overlay::none);
    std::map<std::pair<double, double>, int> at_target;
    for (const Request& r : oracle.asked)
        if (r.kind == RayKind::full && r.rung == target_rung)
            ++at_target[{r.position.x, r.position.y}];
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const auto i = std::size_t(y * width + x);
            ASSERT_TRUE(picture.known[i]) << x << ", " << y;
            ASSERT_EQ(picture.pixels[i], image.colour({x + .5, y + .5})) << x << ", " << y;
            ASSERT_EQ((at_target[{x + .5, y + .5}]), 1) << x << ", " << y;
        }
}

INSTANTIATE_TEST_SUITE_P(Constraints, RisingPreview, testing::Bool());

TEST(MeshPreviewerOnALadder, AsksForNothingThatIsNotReadyWhileThereIsElseToDo) {
    MeshPreviewer previewer(width, height, {}, three_rungs(false));
    FunctionOracle oracle(dear_still_life());
    oracle.target_ready = false;
    Session session(previewer, oracle);
    advance(session, 2500);
    EXPECT_GE(session.counts().full, 2500u);
    const Statistics statistics = previewer.statistics();
    ASSERT_EQ(statistics.rungs.size(), 3u);
    EXPECT_GT(statistics.rungs[0].samples, 100u);
    EXPECT_GT(statistics.rungs[1].samples, 100u);
    EXPECT_EQ(statistics.rungs[2].samples, 0u);
    EXPECT_GT(statistics.rungs[0].error, .02);
}

TEST(MeshPreviewerOnALadder, OldSamplesLookRightLongBeforeAllAreTracedAgain) {
    FunctionImage image = dear_still_life();
    // Smooth, so that what is wrong is the rung's light and not what lies between the samples.
    image.colour = [](dvec2 p) {
        return vec3(float(.4 + .2 * std::sin(p.x / 30) * std::cos(p.y / 25)));
    };
    image.surface = [](dvec2) { return 1u; };
    image.lower[1].colour = [colour = image.colour](dvec2 p) {
        return colour(p) * float(.8 - .3 * p.x / width);
    };
    MeshOptions options;
    options.constraints = options.detail = false;
    MeshPreviewer previewer(width, height, options, three_rungs(false));
    FunctionOracle oracle(image);
    oracle.target_ready = false;
    Session session(previewer, oracle);
    advance(session, 2500);
    const double before = displayed_error(previewer.picture(Overlay::none), image);
    const std::size_t low = previewer.statistics().below_target;
    oracle.target_ready = true;
    previewer.accept_ready(target_rung);
    advance(session, session.counts().full + 1200);
    EXPECT_GT(previewer.statistics().below_target, low / 2);
    EXPECT_LT(displayed_error(previewer.picture(Overlay::none), image), before / 3);
}

TEST(MeshPreviewerOnALadder, WaitsForRungsAndTracesAgainWhatHasBecomeBetter) {
    FunctionImage image = dear_still_life();
    const auto colour = image.colour;
    const auto light = std::make_shared<float>(.2f);
    image.lower[1].colour = [=](dvec2 p) { return colour(p) * *light; };
    MeshPreviewer previewer(width, height, {},
                            {{{"sketch"}, {"unprepared", false}, {"target", false}}});
    FunctionOracle oracle(image, 7);
    oracle.target_ready = false;
    Session session(previewer, oracle);
    const auto go_on = [&] {
        while (session.advance(1ms)) {
        }
        ASSERT_TRUE(previewer.waits());
    };
    const auto error = [&] {
        FunctionImage lit = image;
        lit.colour = image.lower[1].colour;
        return displayed_error(previewer.picture(Overlay::none), lit);
    };
    go_on();
    EXPECT_EQ(previewer.statistics().rungs[1].samples, 0u);
    for (const float step : {.2f, .6f, .9f}) {
        SCOPED_TRACE(step);
        *light = step;
        previewer.accept_ready(1);
        EXPECT_FALSE(previewer.done());
        go_on();
        EXPECT_LT(error(), .03);
        EXPECT_EQ(previewer.validate(), "");
    }
    oracle.target_ready = true;
    previewer.accept_ready(target_rung);
    while (session.advance(1ms)) {
    }
    EXPECT_TRUE(previewer.done());
    EXPECT_FALSE(previewer.waits());
    EXPECT_EQ(displayed_error(previewer.picture(Overlay::none), image), 0);
}

/// With too few samples for a trial, and with one that is all the same.
TEST(MeshPreviewerOnALadder, ClimbsToTheTargetHoweverLittleThereIsToSee) {
    for (const glm::ivec2 size : {glm::ivec2(1, 1), {2, 1}, {3, 2}, {40, 30}}) {
        FunctionImage image = images::constant(vec3(.5f));
        image.full_ns = 900'000'000;
        image.lower = {{image.colour, 1000}};
        MeshPreviewer previewer(size.x, size.y, {}, {{{"sketch"}, {"target"}}});
        FunctionOracle oracle(image);
        Session session(previewer, oracle);
        while (session.advance(1ms)) {
        }
        EXPECT_TRUE(previewer.done()) << size.x << " x " << size.y;
    }
}

TEST(MeshPreviewerOnALadder, ACheapTargetIsReachedAtOnceAndFillsALattice) {
    FunctionImage image = dear_still_life();
    image.lower = {{image.lower[0].colour, 2'000}};
    image.full_ns = 4'000;
    MeshPreviewer previewer(width, height, {}, {{{"sketch"}, {"target"}}});
    FunctionOracle oracle(image);
    Session session(previewer, oracle);
    while (session.advance(1ms)) {
    }
    ASSERT_TRUE(previewer.done());
    const Statistics statistics = previewer.statistics();
    EXPECT_LT(statistics.rungs[0].samples, std::size_t(width * height / 20));
    EXPECT_LT(statistics.vertices, std::size_t(width * height / 20));
    const Picture picture = previewer.picture(Overlay::none);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const auto i = std::size_t(y * width + x);
            ASSERT_TRUE(picture.known[i]) << x << ", " << y;
            ASSERT_EQ(picture.pixels[i], image.colour({x + .5, y + .5})) << x << ", " << y;
        }
}

TEST(MeshPreviewerOnALadder, DependsOnTheAnswersAloneNotOnTheirGrouping) {
    std::vector<Request> first;
    for (std::uint32_t seed : {0u, 1u, 2u}) {
        MeshPreviewer previewer(width, height, {}, three_rungs(true));
        FunctionOracle oracle(dear_still_life(), seed);
        Session session(previewer, oracle);
        session.limit_full(6000);
        while (session.advance(1ms)) {
        }
        if (seed == 0) first = oracle.asked;
        ASSERT_EQ(oracle.asked.size(), first.size());
        for (std::size_t i = 0; i < first.size(); ++i) {
            ASSERT_EQ(oracle.asked[i].position, first[i].position) << i;
            ASSERT_EQ(oracle.asked[i].rung, first[i].rung) << i;
        }
    }
}

TEST(MeshPreviewerOnALadder, SurvivesSamplesThatFailOnSomeRungs) {
    FunctionImage image = dear_still_life();
    const auto colour = image.colour;
    image.lower[0].colour = [colour](dvec2 p) {
        return std::fmod(p.x + p.y, 7) < 1 ? vec3(NAN) : colour(p);
    };
    image.fails = [](dvec2 p) { return std::fmod(p.x, 31) < 1; };
    MeshPreviewer previewer(width, height, {}, three_rungs(true));
    FunctionOracle oracle(image);
    Session session(previewer, oracle);
    while (session.advance(1ms)) {
    }
    EXPECT_TRUE(previewer.done());
    const Picture picture = previewer.picture(Overlay::none);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const dvec2 p{x + .5, y + .5};
            if (!image.fails(p)) {
                ASSERT_EQ(picture.pixels[std::size_t(y * width + x)], colour(p));
            }
        }
}

// ---- a fixed rung

TEST(FixedRung, AsksForItAndNothingElse) {
    FunctionOracle oracle(dear_still_life());
    FixedRung fixed(oracle, 1);
    MeshPreviewer previewer(width, height);
    Session session(previewer, fixed);
    session.limit_full(2000);
    while (session.advance(1ms)) {
    }
    for (const Request& r : oracle.asked) {
        if (r.kind == RayKind::full) {
            ASSERT_EQ(r.rung, 1);
        }
    }
    EXPECT_EQ(previewer.statistics().below_target, 0u);
    EXPECT_TRUE(previewer.statistics().rungs.empty());
}

TEST(Ladder, RungsAreNamedOrNumbered) {
    const Ladder ladder = three_rungs(true);
    EXPECT_EQ(rung_named(ladder, "sketch"), 0);
    EXPECT_EQ(rung_named(ladder, "1"), 1);
    EXPECT_EQ(rung_named(ladder, "2"), target_rung);
    EXPECT_EQ(rung_named(ladder, "target"), target_rung);
    for (const char* wrong : {"3", "-1", "", "sketchy", "1x"})
        EXPECT_THROW(rung_named(ladder, wrong), Error) << wrong;
}

}  // namespace
}  // namespace povpreview
