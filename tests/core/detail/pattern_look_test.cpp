// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/detail/pattern_look.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <glm/common.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <random>

#include "core/detail/item_painter.h"
#include "tests/core/detail/item_scene.h"

namespace povpreview {
namespace {

using Kind = PatternLook::Kind;
constexpr Kind kinds[] = {Kind::checker, Kind::brick, Kind::hexagon};

/// Its colours are the numbers 0, 1, 2.
PatternLook numbered(Kind kind) {
    PatternLook look;
    look.kind = kind;
    for (std::size_t i = 0; i < 3; ++i) look.colours[i] = glm::vec3(static_cast<float>(i));
    return look;
}
int number(const PatternLook& look, const glm::dvec3& point) {
    const auto albedo = pattern_albedo(look, point, point);
    return albedo ? static_cast<int>(albedo->r) : -1;
}

class Points {
   public:
    glm::dvec3 next(double size = 50) { return {size * one_(), size * one_(), size * one_()}; }

   private:
    std::mt19937 random_{2};  // fixed seed
    std::function<double()> one_ = [this] {
        return std::uniform_real_distribution<double>(-1, 1)(random_);
    };
};

TEST(Checkers, ChangeFromCubeToCube) {
    const PatternLook look = numbered(Kind::checker);
    EXPECT_EQ(number(look, {.5, .5, .5}), 0);
    EXPECT_EQ(number(look, {-.5, .5, .5}), 1);
    Points points;
    for (int i = 0; i < 1000; ++i) {
        const glm::dvec3 p = points.next(), centre = glm::floor(p) + .5;
        EXPECT_EQ(number(look, p), number(look, centre));
        for (glm::length_t axis = 0; axis < 3; ++axis) {
            glm::dvec3 beside = centre;
            beside[axis] += 1;
            EXPECT_EQ(number(look, beside), 1 - number(look, centre));
        }
    }
}

TEST(Checkers, InABorderAreOfOneColourOnEitherSideOfRounding) {
    const PatternLook look = numbered(Kind::checker);
    for (const double rounding : {-1e-13, 0., 1e-13}) {
        EXPECT_EQ(number(look, {.5, rounding, .5}), 0);
        EXPECT_EQ(number(look, {.5, 1 + rounding, .5}), 1);
    }
}

TEST(Bricks, AreOfTheirSizeWithMortarBetween) {
    PatternLook look = numbered(Kind::brick);
    look.brick_size = {6, 2, 3};
    look.mortar = .25;
    // Between the joints in depth: a brick ends before its size is full, and the next course is
    // moved by half a brick.
    const double depth = -2.5;
    EXPECT_EQ(number(look, {1, -.1, depth}), 0) << "under the course";
    for (const double y : {.1, 1.7}) {
        EXPECT_EQ(number(look, {-.1, y, depth}), 0);
        EXPECT_EQ(number(look, {.1, y, depth}), 1);
        EXPECT_EQ(number(look, {5.7, y, depth}), 1);
        EXPECT_EQ(number(look, {5.8, y, depth}), 0);
    }
    EXPECT_EQ(number(look, {1, 1.8, depth}), 0);
    EXPECT_EQ(number(look, {2.9, 3, depth}), 0);
    EXPECT_EQ(number(look, {3.1, 3, depth}), 1);
    EXPECT_EQ(number(look, {-.1, 3, depth}), 1);
    // Across the wall it is the other way round.
    EXPECT_EQ(number(look, {1, 1, 1.4}), 0);
    EXPECT_EQ(number(look, {1, 3, 1.4}), 1);
    EXPECT_EQ(number(look, {1, 1, -.1}), 1);
    EXPECT_EQ(number(look, {1, 3, -.1}), 0);
}

TEST(Bricks, TakeTheirShareOfSpace) {
    PatternLook look = numbered(Kind::brick);
    look.mortar = .4;
    const glm::dvec3 clear = 1. - look.mortar / look.brick_size;
    Points points;
    int bricks = 0;
    constexpr int all = 200000;
    for (int i = 0; i < all; ++i) bricks += number(look, points.next(1000)) == 1;
    EXPECT_NEAR(double(bricks) / all, clear.x * clear.y * clear.z, .005);
}

TEST(Bricks, RepeatEveryTwoCourses) {
    const PatternLook look = numbered(Kind::brick);
    Points points;
    for (int i = 0; i < 2000; ++i) {
        const glm::dvec3 p = points.next();
        EXPECT_EQ(number(look, p), number(look, p + glm::dvec3(8, 6, 4.5)));
        // One course up everything is moved by half a brick, along and across.
        EXPECT_EQ(number(look, p), number(look, p + glm::dvec3(4, 3, 2.25)));
    }
}

/// The hexagon that a point lies in, by the nearest of their centres: rows along z, sqrt(3) apart
/// in a column, columns 1.5 apart.
int hexagon_of(const glm::dvec3& p) {
    double nearest = 1e9;
    int result = -1;
    for (int column = 0; column < 12; ++column)
        for (int row = -1; row < 12; ++row) {
            const double x = 1.5 * column, z = std::sqrt(3.) * (row + .5 * (column % 2));
            const double distance = std::hypot(x - p.x, z - p.z);
            if (distance >= nearest) continue;
            nearest = distance;
            // Colours go 0 1 2 upwards; the column beside begins with the third half a step up.
            result = (row + (column % 2 == 0 ? 0 : 2)) % 3;
            if (result < 0) result += 3;
        }
    return result;
}

TEST(Hexagons, AreWhatIsNearestToTheirCentres) {
    const PatternLook look = numbered(Kind::hexagon);
    Points points;
    int wrong = 0;
    for (int i = 0; i < 20000; ++i) {
        const glm::dvec3 p = glm::abs(points.next(10));
        wrong += number(look, p) != hexagon_of(p);
    }
    // POV-Ray knows the root of three to nine digits.
    EXPECT_LE(wrong, 1);
}

TEST(Hexagons, AreMirroredAcrossAndEndlessUpwards) {
    const PatternLook look = numbered(Kind::hexagon);
    Points points;
    const double period = 6 * .866025404;
    for (int i = 0; i < 2000; ++i) {
        const glm::dvec3 p = points.next();
        EXPECT_EQ(number(look, p), number(look, {-p.x, p.y, p.z}));
        EXPECT_EQ(number(look, p), number(look, {p.x, p.y + 7.3, p.z}));
        EXPECT_EQ(number(look, p), number(look, {p.x, p.y, p.z - 20 * period}));
    }
}

TEST(Patterns, LieWhereTheirTransformationPutsThem) {
    const glm::dmat4 placed =
        glm::rotate(glm::translate(glm::dmat4(1), glm::dvec3(1, 2, 3)), .7, glm::dvec3(1, 1, 0)) *
        glm::scale(glm::dmat4(1), glm::dvec3(2, .3, 1));
    for (const Kind kind : kinds) {
        const PatternLook look = numbered(kind);
        PatternLook moved = look;
        moved.to_pattern = glm::dmat4x3(glm::inverse(placed));
        Points points;
        for (int i = 0; i < 1000; ++i) {
            const glm::dvec3 p = points.next();
            EXPECT_EQ(number(moved, glm::dvec3(placed * glm::dvec4(p, 1))), number(look, p));
        }
    }
}

TEST(Patterns, OfNumbersThatMakeNoSenseHaveNoAlbedo) {
    constexpr double infinite = std::numeric_limits<double>::infinity(),
                     not_a_number = std::numeric_limits<double>::quiet_NaN();
    for (const Kind kind : kinds) {
        const PatternLook look = numbered(kind);
        for (const double bad : {infinite, -infinite, not_a_number, 1e10})
            for (glm::length_t axis = 0; axis < 3; ++axis) {
                glm::dvec3 point(.1);
                point[axis] = bad;
                EXPECT_EQ(number(look, point), -1);
                PatternLook moved = look;
                moved.to_pattern[3][axis] = bad;
                EXPECT_EQ(number(moved, glm::dvec3(.1)), -1);
            }
        PatternLook black = look;
        black.colours.fill(glm::vec3(1, std::numeric_limits<float>::quiet_NaN(), 1));
        EXPECT_EQ(number(black, glm::dvec3(.1)), -1);
    }
    PatternLook bricks = numbered(Kind::brick);
    for (const double bad : {1e300, infinite, not_a_number}) {
        PatternLook look = bricks;
        look.mortar = bad;
        EXPECT_EQ(number(look, glm::dvec3(.1)), -1) << bad;
    }
    for (const double bad : {0., 1e-300, not_a_number}) {
        PatternLook look = bricks;
        look.brick_size.y = bad;
        EXPECT_EQ(number(look, glm::dvec3(.1)), -1) << bad;
    }
    bricks.kind = Kind{3};
    EXPECT_EQ(number(bricks, glm::dvec3(.1)), -1);
}

/// A checkered plane and ball, seen aslant.
ItemBuffer painted(double height, std::size_t& on_pattern) {
    test::ItemScene made(test::look_at({1, height + 2, -5}, {0, height, 0}), 120, 90);
    made.scene.looks.push_back({Look::Kind::pattern, {}, numbered(Kind::checker)});
    made.material = 1;
    made.plane({0, 1, 0}, {0, height, 0});
    made.sphere({0, height + .9, 0}, .8);
    ItemBuffer buffer = paint_items(made.scene);
    on_pattern = 0;
    const ItemBuffer expected = made.expected();
    for (std::size_t i = 0; i < buffer.kinds.size(); ++i) {
        if (buffer.kinds[i] != Look::Kind::pattern) continue;
        ++on_pattern;
        EXPECT_EQ(buffer.surfaces[i], expected.surfaces[i]);
    }
    return buffer;
}

TEST(ItemPatterns, HaveTheirAlbedoAtEveryPixel) {
    std::size_t on_pattern;
    const ItemBuffer buffer = painted(0, on_pattern);
    std::size_t ones = 0;
    for (std::size_t i = 0; i < buffer.kinds.size(); ++i)
        ones += buffer.kinds[i] == Look::Kind::pattern && buffer.albedos[i].r == 1;
    EXPECT_GT(on_pattern, 7000U);
    EXPECT_NEAR(double(ones) / double(on_pattern), .5, .1);
    EXPECT_EQ(std::count(buffer.kinds.begin(), buffer.kinds.end(), Look::Kind::traced), 0);
}

TEST(ItemPatterns, AreLeftToRaysWhereRoundingDecides) {
    std::size_t on_pattern;
    const ItemBuffer buffer = painted(-1e-10, on_pattern);
    EXPECT_GT(on_pattern, 200U) << "the ball";
    EXPECT_LT(on_pattern, 3000U);
    EXPECT_GT(std::count(buffer.kinds.begin(), buffer.kinds.end(), Look::Kind::traced), 4000);
}

}  // namespace
}  // namespace povpreview
