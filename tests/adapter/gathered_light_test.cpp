// SPDX-License-Identifier: AGPL-3.0-or-later
#include "backend/oracle/gathered_light.h"

#include <gtest/gtest.h>

#include <limits>

namespace povpreview::tracer {
namespace {

constexpr Point up{0, 1, 0}, down{0, -1, 0}, right{1, 0, 0};

TEST(GatheredLight, IsBlackBeforeAnythingIsGathered) {
    const GatheredLight light;
    EXPECT_EQ(light.guess({1, 2, 3}, up).r, 0);
}

TEST(GatheredLight, OneLightIsTheGuessEverywhere) {
    GatheredLight light;
    light.add({1, 2, 3}, up, 1, {.5f, .25f, 2});
    for (const Point& place : {Point{1, 2, 3}, {1.1, 2, 3}, {1e6, -1e30, 3}})
        for (const Point& normal : {up, down, right, Point{.6, .8, 0}}) {
            const Rgb guess = light.guess(place, normal);
            EXPECT_FLOAT_EQ(guess.r, .5f);
            EXPECT_FLOAT_EQ(guess.g, .25f);
            EXPECT_FLOAT_EQ(guess.b, 2);
        }
}

TEST(GatheredLight, WhatIsNearAndFacesTheSameWayCounts) {
    GatheredLight light;
    for (double at = 0; at < 4; at += .25) {
        light.add({at, 0, 0}, up, 1, {1, 1, 1});          // a bright floor ...
        light.add({at, 0, 0}, down, 1, {0, 0, 0});        // ... its dark lower side
        light.add({at + 100, 0, 0}, up, 1, {.2f, 0, 0});  // and a dim floor far away
    }
    EXPECT_GT(light.guess({2.1, 0, 0}, up).r, .95f);
    EXPECT_LT(light.guess({2.1, 0, 0}, down).r, .05f);
    EXPECT_NEAR(light.guess({102.1, 0, 0}, up).r, .2f, .05f);
    // Nothing faces this way: the mean of all.
    EXPECT_NEAR(light.guess({2.1, 0, 0}, right).r, .4f, 1e-5f);
    // A normal between two directions: some of both.
    const float between = light.guess({2.1, 0, 0}, {.6, .8, 0}).r;
    EXPECT_GT(between, .4f);
    EXPECT_LT(between, 1);
}

TEST(GatheredLight, ChangesLittleOverLittleDistance) {
    GatheredLight light;
    for (int i = 0; i < 100; ++i) light.add({i * .37, 0, i * i * .01}, up, .5, {i % 7 / 7.f, 0, 0});
    float before = light.guess({0, 0, 0}, up).r;
    for (double x = 0; x < 30; x += 1e-3) {
        const float now = light.guess({x, 0, x}, up).r;
        ASSERT_NEAR(now, before, .05f) << x;
        before = now;
    }
}

TEST(GatheredLight, PlacesThatAreNoNumbersAreHarmless) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    GatheredLight light;
    light.add({nan, 1, 1}, {nan, nan, nan}, nan, {1, 1, 1});
    light.add({1, 1, 1}, up, 1, {1, 1, 1});
    EXPECT_FLOAT_EQ(light.guess({nan, 1, 1}, up).r, 1);
    EXPECT_FLOAT_EQ(light.guess({1, 1, 1}, {nan, nan, nan}).r, 1);
}

}  // namespace
}  // namespace povpreview::tracer
