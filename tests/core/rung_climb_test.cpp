// SPDX-License-Identifier: AGPL-3.0-or-later
//
// The ladder of accuracy: when the next rung is tried out and climbed.
#include "core/rung_climb.h"

#include <gtest/gtest.h>

namespace povpreview {
namespace {

using glm::vec3;

constexpr std::size_t pixels = 128 * 300;  // a picture stands on 300 samples

Sample traced(Rung rung, std::uint32_t cost_ns) {
    return {.position = {}, .kind = RayKind::full, .rung = rung, .cost_ns = cost_ns};
}

/// Has all trials answered that are asked for.
void try_next(RungClimb& climb, std::uint32_t cost_ns) {
    while (climb.take_trial(false)) climb.learn(traced(climb.next(), cost_ns));
}

TEST(RungClimb, WithOneRungThereIsNothingToClimb) {
    RungClimb climb({}, pixels, 100);
    EXPECT_TRUE(climb.at_target());
    EXPECT_EQ(climb.current(), target_rung);
    EXPECT_FALSE(climb.take_trial(false));
    EXPECT_FALSE(climb.climb());
}

TEST(RungClimb, StaysLowUntilThePictureStandsWhereTheNextRungIsDear) {
    RungClimb climb({{{"sketch"}, {"target"}}}, pixels, 100);
    EXPECT_EQ(climb.current(), 0);
    int low = 0;
    for (; low < 100; ++low) climb.learn(traced(0, 10'000));
    EXPECT_FALSE(climb.climb());
    try_next(climb, 4'000'000);
    for (; !climb.climb(); ++low) {
        ASSERT_LT(low, 1000);
        climb.learn(traced(0, 10'000));
    }
    EXPECT_EQ(low, 300);
    EXPECT_TRUE(climb.at_target());
    EXPECT_FALSE(climb.standings()[0].dropped);
}

TEST(RungClimb, LeavesALowRungThatHasTakenATwentiethOfWhatIsToCome) {
    RungClimb climb({{{"sketch"}, {"target"}}}, pixels, 100);
    int low = 0;
    for (; low < 100; ++low) climb.learn(traced(0, 250'000));
    try_next(climb, 4'000'000);
    for (; !climb.climb(); ++low) {
        ASSERT_LT(low, 1000);
        climb.learn(traced(0, 250'000));
    }
    EXPECT_EQ(low, 241);  // 300 of the target take 1.2 s
    EXPECT_FALSE(climb.standings()[0].dropped);
}

TEST(RungClimb, DropsARungThatGainsNothing) {
    for (const std::uint32_t cost :
         {15'000u, 500'000u, 1'900'000u}) {  // not cheaper; cheaper, but all is quick
        RungClimb climb({{{"sketch"}, {"target"}}}, pixels, 100);
        for (int i = 0; i < 100; ++i) climb.learn(traced(0, 10'000));
        try_next(climb, cost);
        EXPECT_TRUE(climb.climb());
        EXPECT_TRUE(climb.standings()[0].dropped);
        EXPECT_EQ(climb.standings()[0].samples, 100u);
    }
}

/// Trials asked for before the first picture is there, as many as are then.
std::size_t try_early(RungClimb& climb, std::uint32_t cost_ns) {
    std::size_t trials = 0;
    // All that may be asked for is, before any answer comes.
    for (std::size_t asked = 0;; trials += asked, asked = 0) {
        while (climb.take_trial(true)) ++asked;
        if (asked == 0) return trials;
        for (std::size_t i = 0; i < asked; ++i) climb.learn(traced(climb.next(), cost_ns));
    }
}

TEST(RungClimb, BeforeTheFirstPictureItTriesOutFewDearSamples) {
    RungClimb climb({{{"sketch"}, {"target"}}}, pixels, 100);
    for (int i = 0; i < 30; ++i) climb.learn(traced(0, 10'000));
    EXPECT_EQ(try_early(climb, 4'000'000), 2u);
    EXPECT_TRUE(climb.seems_dear());
    EXPECT_TRUE(climb.undecided());
    EXPECT_FALSE(climb.climb());
    EXPECT_TRUE(climb.take_trial(false));
}

TEST(RungClimb, BeforeTheFirstPictureItLeavesARungThatGainsNothing) {
    for (const std::uint32_t cost : {15'000u, 500'000u}) {
        RungClimb climb({{{"sketch"}, {"target"}}}, pixels, 100);
        for (int i = 0; i < 30; ++i) climb.learn(traced(0, 10'000));
        EXPECT_GE(try_early(climb, cost), 2u);
        EXPECT_FALSE(climb.seems_dear());
        EXPECT_FALSE(climb.undecided());
        EXPECT_TRUE(climb.climb());
    }
}

TEST(RungClimb, TwoCheapSamplesTellEnough) {
    RungClimb climb({{{"sketch"}, {"target"}}}, pixels, 100);
    for (int i = 0; i < 30; ++i) climb.learn(traced(0, 10'000));
    for (const std::uint32_t cost : {5'000u, 19'000u}) {
        EXPECT_TRUE(climb.undecided());
        ASSERT_TRUE(climb.take_trial(true));
        climb.learn(traced(target_rung, cost));
    }
    EXPECT_FALSE(climb.undecided());
}

TEST(RungClimb, SkipsNoReadyRungAndWaitsForTheTarget) {
    RungClimb climb({{{"sketch"}, {"unprepared"}, {"target", false}}}, pixels, 100);
    for (int i = 0; i < 400; ++i) climb.learn(traced(0, 10'000));
    EXPECT_EQ(climb.next(), 1);
    try_next(climb, 3'000'000);
    ASSERT_TRUE(climb.climb());
    EXPECT_EQ(climb.current(), 1);
    for (int i = 0; i < 4000; ++i) climb.learn(traced(1, 3'000'000));
    EXPECT_FALSE(climb.take_trial(false));
    EXPECT_FALSE(climb.climb());
    climb.ready(target_rung);
    EXPECT_EQ(climb.next(), target_rung);
    try_next(climb, 50'000);
    EXPECT_TRUE(climb.climb());
    EXPECT_TRUE(climb.at_target());
}

TEST(RungClimb, MeasuresTheDisplayedDifference) {
    RungClimb climb({{{"sketch"}, {"target"}}}, pixels, 100);
    EXPECT_LT(climb.standings()[0].error, 0);
    climb.compare(0, vec3(0), vec3(1));
    climb.compare(0, vec3(1), vec3(1));
    EXPECT_DOUBLE_EQ(climb.standings()[0].error, .5);
}

}  // namespace
}  // namespace povpreview
