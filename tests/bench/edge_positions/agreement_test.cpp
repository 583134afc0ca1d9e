// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/bench/edge_positions/agreement.h"

#include <gtest/gtest.h>

namespace povpreview {
namespace {

constexpr int scale = 4, side = 40;

/// Black left of a slanting line and `right` right of it, four times as fine as the picture.
///
///      line through (18, 0) and (22, 40)
///
Image half_plane(float right) {
    Image fine(side * scale, side * scale);
    for (int y = 0; y < fine.height; ++y)
        for (int x = 0; x < fine.width; ++x)
            if ((x + .5) / scale > 18 + (y + .5) / scale / 10) fine.at(x, y) = glm::vec3(right);
    return fine;
}

EdgeChain line(double shift) {
    EdgeChain chain;
    chain.vertices = {{18 + shift, 0}, {22 + shift, side}};
    return chain;
}

struct Agreement {
    JumpsFound jumps;
    ConstraintsPlaced placed;
};

Agreement measure(const Image& fine, const std::vector<EdgeChain>& chains) {
    NearSegments all({side, side});
    for (const EdgeChain& chain : chains) all.add(chain);
    const std::vector<glm::dvec2> jumps = strong_jumps(fine, scale);
    return {find_jumps(jumps, all), place_constraints(chains, all, jumps, fine, scale)};
}

TEST(EdgePositions, ALineInItsPlaceIsFoundThroughout) {
    const Agreement a = measure(half_plane(.5f), {line(0)});
    EXPECT_GT(a.jumps.jumps, std::size_t(side * scale));
    EXPECT_EQ(a.jumps.found, a.jumps.jumps);
    EXPECT_EQ(a.placed.share(), 1);
    EXPECT_NEAR(a.placed.on, a.placed.length(), 1e-9);
    EXPECT_NEAR(a.placed.length(), std::hypot(4, side), 1e-9);
}

TEST(EdgePositions, ToleranceIsHalfAPixel) {
    EXPECT_GT(measure(half_plane(.5f), {line(.3)}).jumps.share(), .99);
    EXPECT_LT(measure(half_plane(.5f), {line(.7)}).jumps.share(), .01);
    EXPECT_GT(measure(half_plane(.5f), {line(.3)}).placed.on, 39);
    EXPECT_GT(measure(half_plane(.5f), {line(.75)}).placed.off, 39);
    EXPECT_GT(measure(half_plane(.5f), {line(-.75)}).placed.off, 39);
    EXPECT_LT(measure(half_plane(.5f), {line(.75)}).placed.share(), .03);
}

TEST(EdgePositions, WhereNothingChangesAConstraintIsEven) {
    const Agreement a = measure(half_plane(.5f), {line(0), line(5)});
    EXPECT_NEAR(a.placed.even, a.placed.length() / 2, .5);
    EXPECT_EQ(a.placed.share(), 1);
}

TEST(EdgePositions, AJumpThatBelongsToAnotherConstraintIsNotMissed) {
    const Agreement a = measure(half_plane(.5f), {line(0), line(.8)});
    EXPECT_GT(a.placed.beside, 39);
    EXPECT_LT(a.placed.off, 1);
}

TEST(EdgePositions, WeakJumpsDoNotCount) {
    const Agreement a = measure(half_plane(float(strong_jump) * .9f), {});
    EXPECT_EQ(a.jumps.jumps, 0u);
    EXPECT_GT(measure(half_plane(float(strong_jump) * 1.1f), {}).jumps.jumps, 0u);
}

TEST(EdgePositions, SmoothShadingHasNoJumpAndNoContrastThatCounts) {
    Image fine(side * scale, side * scale);
    for (int y = 0; y < fine.height; ++y)
        for (int x = 0; x < fine.width; ++x)
            fine.at(x, y) = glm::vec3(float(x) / float(fine.width));  // .025 for each pixel
    const Agreement a = measure(fine, {line(0)});
    EXPECT_EQ(a.jumps.jumps, 0u);
    EXPECT_NEAR(a.placed.even, a.placed.length(), 1e-9);
}

TEST(EdgePositions, WithoutConstraintsEveryJumpIsMissed) {
    const Agreement a = measure(half_plane(1), {});
    EXPECT_EQ(a.jumps.found, 0u);
    EXPECT_EQ(a.jumps.missed.size(), a.jumps.jumps);
}

}  // namespace
}  // namespace povpreview
