// SPDX-License-Identifier: AGPL-3.0-or-later
// The previewers that ours is compared with: rview's blocks, POV-Ray's mosaic, bicubic.
#include <gtest/gtest.h>

#include <functional>
#include <glm/common.hpp>
#include <map>
#include <memory>
#include <set>
#include <string>

#include "core/bicubic.h"
#include "core/blocks.h"
#include "core/colour.h"
#include "core/mosaic.h"
#include "tests/core/function_oracle.h"

namespace povpreview {
namespace {

using Make = std::function<std::unique_ptr<Previewer>(int, int)>;
using Pixel = std::pair<int, int>;

Pixel pixel_of(glm::dvec2 p) { return {int(std::floor(p.x)), int(std::floor(p.y))}; }

/// Asks for up to `batch` samples at a time and answers them; stops after `limit` samples.
std::vector<Request> run(Previewer& previewer, const FunctionImage& image, std::size_t batch,
                         std::size_t limit = SIZE_MAX) {
    std::vector<Request> asked;
    while (!previewer.done() && asked.size() < limit) {
        const std::size_t first = asked.size();
        while (asked.size() < std::min(limit, first + batch)) {
            const auto request = previewer.next();
            if (!request) break;
            asked.push_back(*request);
        }
        if (asked.size() == first) {
            ADD_FAILURE() << "asks for nothing, yet is not done after " << first << " samples";
            break;
        }
        for (std::size_t i = first; i < asked.size(); ++i) previewer.accept(image.sample(asked[i]));
    }
    return asked;
}

class Baseline : public testing::TestWithParam<std::pair<const char*, Make>> {
   protected:
    std::unique_ptr<Previewer> make(int w, int h) const { return GetParam().second(w, h); }
};

TEST_P(Baseline, TracesEachPixelOnceAndEndsAsTheImage) {
    for (const glm::ivec2 size : {glm::ivec2(1, 1),
                                  {1, 7},
                                  {9, 1},
                                  {2, 2},
                                  {16, 16},
                                  {33, 31},
                                  {64, 48},
                                  {67, 129},
                                  {1, 300}}) {
        SCOPED_TRACE(std::to_string(size.x) + " x " + std::to_string(size.y));
        const FunctionImage image = images::still_life(size.x, size.y);
        const auto previewer = make(size.x, size.y);
        const std::vector<Request> asked = run(*previewer, image, 97);
        EXPECT_EQ(asked.size(), std::size_t(size.x * size.y));
        std::set<Pixel> pixels;
        for (const Request& r : asked) {
            EXPECT_EQ(r.position, glm::floor(r.position) + .5) << "not a pixel centre";
            EXPECT_EQ(r.kind, RayKind::full);
            pixels.insert(pixel_of(r.position));
        }
        EXPECT_EQ(pixels.size(), asked.size()) << "a pixel was traced twice";
        const Picture picture = previewer->picture(Overlay::none);
        ASSERT_EQ(picture.pixels.size(), asked.size());
        EXPECT_EQ(picture.known, std::vector<std::uint8_t>(asked.size(), 1));
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) {
                EXPECT_EQ(picture.pixels[std::size_t(y * size.x + x)],
                          image.colour({x + .5, y + .5}))
                    << "pixel " << x << ", " << y;
            }
        }
        EXPECT_EQ(previewer->statistics().filled, asked.size());
        EXPECT_FALSE(previewer->next());
    }
}

TEST_P(Baseline, AsksTheSameHoweverAnswersAreGrouped) {
    const FunctionImage image = images::still_life(70, 50);
    const auto one = make(70, 50), many = make(70, 50);
    const auto first = run(*one, image, 1), second = run(*many, image, 16384);
    ASSERT_EQ(first.size(), second.size());
    for (std::size_t i = 0; i < first.size(); ++i) {
        ASSERT_EQ(first[i].position, second[i].position) << "request " << i;
    }
}

TEST_P(Baseline, ShowsEverySampleAtItsOwnPixelAtAnyTime) {
    const FunctionImage image = images::still_life(50, 40);
    for (std::size_t limit = 1; limit < 2000; limit += limit / 3 + 1) {
        const auto previewer = make(50, 40);
        const auto asked = run(*previewer, image, 64, limit);
        const Picture picture = previewer->picture(Overlay::samples);
        ASSERT_EQ(picture.samples.size(), asked.size());
        for (const Request& r : asked) {
            const auto [x, y] = pixel_of(r.position);
            ASSERT_EQ(picture.pixels[std::size_t(y * 50 + x)], image.colour(r.position))
                << "pixel " << x << ", " << y << " after " << limit << " samples";
        }
    }
}

TEST_P(Baseline, CoversTheWholePictureFromTheFirstLevelOn) {
    const auto previewer = make(64, 64);
    const FunctionImage image = images::constant({.25f, .5f, .75f});
    run(*previewer, image, 64, 9);  // a 3 x 3 lattice; more than the others' first 1 or 4
    for (const glm::vec3& pixel : previewer->picture(Overlay::none).pixels) {
        EXPECT_NEAR(pixel.x, .25f, 2e-6);
        EXPECT_NEAR(pixel.y, .5f, 2e-6);
        EXPECT_NEAR(pixel.z, .75f, 2e-6);
    }
}

TEST_P(Baseline, SurvivesColoursThatAreNoNumbers) {
    const float nan = std::nanf(""), inf = std::numeric_limits<float>::infinity();
    const FunctionImage image{[=](glm::dvec2 p) {
        if (p.x < 10) return glm::vec3(nan, inf, -inf);
        return glm::vec3(p.y < 10 ? 1e30f : -3.f);
    }};
    const auto previewer = make(40, 40);
    EXPECT_EQ(run(*previewer, image, 50).size(), 1600u);
    EXPECT_TRUE(previewer->done());
}

INSTANTIATE_TEST_SUITE_P(
    All, Baseline,
    testing::Values(std::pair<const char*, Make>{"blocks",
                                                 [](int w, int h) -> std::unique_ptr<Previewer> {
                                                     return std::make_unique<Blocks>(w, h);
                                                 }},
                    std::pair<const char*, Make>{"mosaic",
                                                 [](int w, int h) -> std::unique_ptr<Previewer> {
                                                     return std::make_unique<Mosaic>(w, h);
                                                 }},
                    std::pair<const char*, Make>{"bicubic",
                                                 [](int w, int h) -> std::unique_ptr<Previewer> {
                                                     return std::make_unique<Bicubic>(w, h);
                                                 }}),
    [](const auto& test) { return std::string(test.param.first); });

/// Sizes of the squares of equal colour, where every pixel of the image has a colour of its own.
FunctionImage every_pixel_different() {
    return {[](glm::dvec2 p) {
        return glm::vec3(float(std::floor(p.x)), float(std::floor(p.y)), 1.f);
    }};
}

TEST(Mosaic, WalksTilesAndLeavesOutWhatItHas) {
    Mosaic mosaic(40, 8, 4);
    const auto asked = run(mosaic, images::constant({1, 1, 1}), 16384);
    // First level: tile (0, 0) has 8 x 2 blocks of 4 pixels, tile (32, 0) 2 x 2.
    std::vector<Pixel> expected;
    for (int y : {0, 4}) {
        for (int x = 0; x < 32; x += 4) expected.push_back({x, y});
    }
    for (int y : {0, 4}) {
        for (int x : {32, 36}) expected.push_back({x, y});
    }
    // Second level begins with the first block of 2 that is not a corner of one of 4.
    for (int x = 2; x < 32; x += 4) expected.push_back({x, 0});
    for (int x = 0; x < 32; x += 2) expected.push_back({x, 2});
    ASSERT_GT(asked.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_EQ(pixel_of(asked[i].position), expected[i]) << "request " << i;
    }
}

TEST(Mosaic, WaitsForALevelsEnd) {
    Mosaic mosaic(16, 16, 8);
    for (int i = 0; i < 4; ++i) EXPECT_TRUE(mosaic.next());
    EXPECT_FALSE(mosaic.next());
    for (int i = 0; i < 4; ++i) mosaic.accept(Sample{});
    for (int i = 0; i < 12; ++i) EXPECT_TRUE(mosaic.next());
    EXPECT_FALSE(mosaic.next());
}

TEST(Mosaic, ShowsUpperLeftPixels) {
    Mosaic mosaic(10, 10, 8);
    run(mosaic, every_pixel_different(), 100, 4);
    const Picture picture = mosaic.picture(Overlay::none);
    for (int y = 0; y < 10; ++y) {
        for (int x = 0; x < 10; ++x) {
            EXPECT_EQ(picture.pixels[std::size_t(10 * y + x)],
                      glm::vec3(float(x / 8 * 8), float(y / 8 * 8), 1.f));
        }
    }
}

TEST(Blocks, SplitsUniformlyDownToEightPixelsThenStopsWhereNothingDiffers) {
    // 32 x 32: 1 + 3 + 12 = 16 blocks of 8 pixels. A flat image has no more differences, so the
    // rest is uniform again: 3 x 16 samples for blocks of 4, and so on.
    Blocks blocks(32, 32);
    const auto asked = run(blocks, images::constant({.5f, .5f, .5f}), 1, 64);
    std::map<Pixel, int> per_eight, per_four;
    for (std::size_t i = 0; i < 64; ++i) {
        const auto [x, y] = pixel_of(asked[i].position);
        if (i < 16) ++per_eight[{x / 8, y / 8}];
        ++per_four[{x / 4, y / 4}];
    }
    EXPECT_EQ(per_eight.size(), 16u) << "one sample in each block of 8 pixels";
    EXPECT_EQ(per_four.size(), 64u) << "then one in each block of 4";
}

TEST(Blocks, SplitsBesideAJumpFirst) {
    // Two halves: blocks of 8 beside the jump at x = 32 differ from their neighbours; after the
    // 64 uniform samples the next ones lie in these two columns of blocks.
    const FunctionImage halves{[](glm::dvec2 p) { return glm::vec3(p.x < 32 ? .2f : .8f); }};
    Blocks blocks(64, 64);
    const auto asked = run(blocks, halves, 16384, 64 + 2 * 8 * 3);
    for (std::size_t i = 64; i < asked.size(); ++i) {
        EXPECT_GE(asked[i].position.x, 24);
        EXPECT_LT(asked[i].position.x, 40);
    }
}

TEST(Blocks, AGradientBelowFifteenPercentIsNoDifference) {
    // From one block of 8 to the next 14 %, 16 %; only the second is a reason to split.
    for (const auto& [step, splits] : {std::pair{1.14, false}, std::pair{1.16, true}}) {
        const FunctionImage stairs{[step = step](glm::dvec2 p) {
            return glm::vec3(float(.01 * std::pow(step, std::floor(p.y / 32))));
        }};
        Blocks blocks(64, 64);
        const auto asked = run(blocks, stairs, 1, 64 + 2 * 8 * 3);
        bool only_beside_the_step = true;
        for (std::size_t i = 64; i < asked.size(); ++i) {
            const double y = asked[i].position.y;
            only_beside_the_step = only_beside_the_step && y >= 24 && y < 40;
        }
        EXPECT_EQ(only_beside_the_step, splits) << "step " << step;
    }
}

TEST(Blocks, ASeedGivesItsOwnPositions) {
    Blocks a(64, 64, 1), b(64, 64, 1), c(64, 64, 2);
    const FunctionImage image = images::checker(7);
    const auto first = run(a, image, 50), same = run(b, image, 50), other = run(c, image, 50);
    int different = 0;
    for (std::size_t i = 0; i < first.size(); ++i) {
        EXPECT_EQ(first[i].position, same[i].position);
        different += first[i].position != other[i].position;
    }
    EXPECT_GT(different, 1000);
}

TEST(CubicLattice, ReproducesStraightLinesOnUnevenLattices) {
    const std::vector<int> lattice{0, 4, 8, 12, 13}, places{0, 1, 2, 3, 4, 5, 6, 7, 9, 11, 12, 13};
    const auto weights = cubic_weights(lattice, places);
    for (std::size_t i = 0; i < places.size(); ++i) {
        float sum = 0, value = 0;
        for (std::size_t k = 0; k < 4; ++k) {
            sum += weights[i].weights[k];
            value += weights[i].weights[k] * float(3 * lattice[weights[i].points[k]] - 5);
        }
        EXPECT_NEAR(sum, 1, 1e-6);
        EXPECT_NEAR(value, 3 * places[i] - 5, 1e-5);
    }
}

TEST(CubicLattice, HasCatmullAndRomsWeightsInTheMiddle) {
    const std::vector<int> lattice{0, 2, 4, 6}, places{3};
    const auto weights = cubic_weights(lattice, places).front().weights;
    EXPECT_NEAR(weights[0], -1. / 16, 1e-7);
    EXPECT_NEAR(weights[1], 9. / 16, 1e-7);
    EXPECT_NEAR(weights[2], 9. / 16, 1e-7);
    EXPECT_NEAR(weights[3], -1. / 16, 1e-7);
}

TEST(Bicubic, ASmoothImageIsAlmostRightFromTheFirstLevel) {
    // A cosine of amplitude 1/4 and period 256 pixels, in encoded colour. Between points h = 32
    // apart, Catmull and Rom's cubic is off by 9/384 h^4 times the fourth derivative at most (1/384
    // as every Hermite cubic, 1/48 from its tangents): here .25 (2 pi / 8)^4 9/384 = .00223.
    const FunctionImage image{[](glm::dvec2 p) {
        const double wave = .5 + .25 * std::cos(p.x * 6.28318530718 / 256);
        return glm::vec3(decode_srgb(float(wave)));
    }};
    Bicubic bicubic(257, 65);
    run(bicubic, image, 64, 9 * 3);
    const Picture picture = bicubic.picture(Overlay::none);
    float worst = 0;
    for (int x = 32; x < 224; ++x) {  // the end pieces have one-sided tangents
        const float truth = encode_srgb(image.colour({x + .5, 32.5}).x);
        worst = std::max(
            worst, std::abs(encode_srgb(picture.pixels[std::size_t(32 * 257 + x)].x) - truth));
    }
    EXPECT_NEAR(worst, .00223, 2e-5);
}

}  // namespace
}  // namespace povpreview
