// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/error_meter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>

#include "core/colour.h"

namespace povpreview {
namespace {

constexpr int width = 96, height = 80;

using Texel = std::array<int, 3>;  // 8-bit sRGB
using Pattern = std::function<Texel(int, int)>;
using Colours = std::vector<glm::vec3>;

Colours image(const Pattern& of) {
    Colours result;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const Texel t = of(x, y);
            result.emplace_back(float(t[0]) / 255, float(t[1]) / 255, float(t[2]) / 255);
        }
    return result;
}

Colours decoded(Colours colours) {
    for (glm::vec3& c : colours) c = {decode_srgb(c.x), decode_srgb(c.y), decode_srgb(c.z)};
    return colours;
}

// The patterns of expected_errors.py.

int hashed(int x, int y, int c) {
    std::uint32_t h =
        std::uint32_t(x) * 73856093u ^ std::uint32_t(y) * 19349663u ^ std::uint32_t(c) * 83492791u;
    h = (h ^ (h >> 13)) * 1274126177u;
    return int(h >> 16 & 255);
}
Texel gradient(int x, int y) {
    return {x * 255 / (width - 1), y * 255 / (height - 1), (x + y) * 255 / (width + height - 2)};
}
Texel tiles(int x, int y) {
    return (x / 12 + y / 10) % 2 ? Texel{230, 40, 30} : Texel{20, 60, 200};
}
Texel disc(int x, int y) {
    const bool inside = (x - 47) * (x - 47) + (y - 40) * (y - 40) < 900;
    return inside ? Texel{250, 240, 200} : Texel{30, 35, 60};
}
Texel noisy_gradient(int x, int y) {
    Texel t = gradient(x, y);
    for (int c = 0; c < 3; ++c) {
        const int noise = (hashed(x, y, c) - 128) * 24;
        // Rounded down, as Python divides.
        t[c] = std::clamp(t[c] + int(std::floor(double(noise) / 128)), 0, 255);
    }
    return t;
}
Texel blocks_of_tiles(int x, int y) { return tiles(x / 8 * 8, y / 8 * 8); }
Texel shifted_disc(int x, int y) { return disc(x - 3, y); }
Texel grey_disc(int x, int y) {
    const Texel t = disc(x, y);
    const int grey = (t[0] + t[1] + t[2]) / 3;
    return {grey, grey, grey};
}

struct Expected {
    const char* name;
    double psnr, ssim, flip;  // by expected_errors.py
    Pattern reference, test;
};

TEST(ErrorMeter, AgreesWithOthers) {
    const std::vector<Expected> pairs{
        {"noisy gradient", 25.44709, 0.504072, 0.116990, gradient, noisy_gradient},
        {"blocks of tiles", 8.60234, 0.332092, 0.429575, tiles, blocks_of_tiles},
        {"disc shifted", 15.85068, 0.741578, 0.147375, disc, shifted_disc},
        {"disc without colour", 23.65614, 0.995849, 0.314555, disc, grey_disc},
        {"green against blue", 1.76091, 0.374473, 1.000000,
         [](int, int) {
             return Texel{0, 255, 0};
         },
         [](int, int) {
             return Texel{0, 0, 255};
         }}};
    for (const Expected& pair : pairs) {
        const ErrorMeter meter(image(pair.reference), width, height);
        const ImageErrors errors = meter.measure(decoded(image(pair.test)));
        EXPECT_NEAR(errors.psnr, pair.psnr, 2e-4) << pair.name;
        EXPECT_NEAR(errors.ssim, pair.ssim, 2e-4) << pair.name;
        EXPECT_NEAR(errors.flip, pair.flip, 2e-4) << pair.name;
    }
}

TEST(ErrorMeter, EqualImagesHaveNoError) {
    for (const Pattern& pattern : {Pattern(gradient), Pattern(tiles), Pattern(disc)}) {
        Colours linear = decoded(image(pattern)), encoded;
        for (const glm::vec3& c : linear) encoded.push_back(display_encoded(c));
        const ImageErrors errors = ErrorMeter(encoded, width, height).measure(linear);
        EXPECT_EQ(errors.l1, 0);
        EXPECT_TRUE(std::isinf(errors.psnr));
        EXPECT_NEAR(errors.ssim, 1, 1e-6);
        EXPECT_NEAR(errors.flip, 0, 1e-6);
        EXPECT_EQ(errors.edge_l1, 0);
    }
}

TEST(ErrorMeter, FlipAndSsimDoNotCareWhichImageIsTheReference) {
    const Colours a = image(tiles), b = image(blocks_of_tiles);
    const ImageErrors ab = ErrorMeter(a, width, height).measure(decoded(b)),
                      ba = ErrorMeter(b, width, height).measure(decoded(a));
    EXPECT_NEAR(ab.flip, ba.flip, 1e-5);
    EXPECT_NEAR(ab.ssim, ba.ssim, 1e-5);
    EXPECT_NEAR(ab.psnr, ba.psnr, 1e-3);
}

TEST(ErrorMeter, EdgesAreWhereNeighboursDiffer) {
    // Black left of x = 50, white from there on.
    const auto step = image([](int x, int) { return x < 50 ? Texel{} : Texel{255, 255, 255}; });
    const ErrorMeter meter(step, width, height);
    for (int x = 0; x < width; ++x)
        EXPECT_EQ(meter.near_edges()[7 * width + x], x >= 48 && x < 52) << x;

    // An error beside the edges is none at them, and the other way round.
    Colours far = decoded(step), at = far;
    for (int y = 0; y < height; ++y) {
        far[y * width + 20] = glm::vec3(1);
        at[y * width + 49] = glm::vec3(1);
    }
    EXPECT_EQ(meter.measure(far).edge_l1, 0);
    EXPECT_NEAR(meter.measure(far).l1, 1. / width, 1e-9);
    EXPECT_NEAR(meter.measure(at).edge_l1, 1. / 4, 1e-9);
}

TEST(ErrorMeter, AnImageWithoutEdgesHasNoErrorAtThem) {
    const auto grey = image([](int, int) { return Texel{128, 128, 128}; });
    const ImageErrors errors = ErrorMeter(grey, width, height).measure(Colours(grey.size()));
    EXPECT_GT(errors.l1, .4);
    EXPECT_EQ(errors.edge_l1, 0);
}

TEST(ErrorMeter, WhatIsNotFiniteIsBad) {
    const float nan = std::nanf(""), inf = std::numeric_limits<float>::infinity();
    const Colours reference = image(gradient);
    const ErrorMeter meter(reference, width, height);
    Colours broken = decoded(reference);
    const double sound = meter.measure(broken).flip;
    for (int i = 0; i < 400; ++i)
        broken[i * 3] = i % 2 ? glm::vec3(nan) : glm::vec3(inf, -inf, nan);
    const ImageErrors errors = meter.measure(broken);
    EXPECT_GT(errors.flip, sound + .01);
    EXPECT_LT(errors.ssim, .99);
    for (const double value :
         {errors.l1, errors.rmse, errors.psnr, errors.ssim, errors.flip, errors.edge_l1})
        EXPECT_TRUE(std::isfinite(value));

    // And in the reference, as an EXR may bring it.
    Colours broken_reference = reference;
    for (int i = 0; i < 400; ++i) broken_reference[i * 3] = glm::vec3(nan, inf, -inf);
    const ImageErrors against =
        ErrorMeter(broken_reference, width, height).measure(decoded(reference));
    EXPECT_GT(against.flip, .01);
    EXPECT_TRUE(std::isfinite(against.ssim));
}

TEST(ErrorMeter, MeasuresTheSmallestImages) {
    for (const auto& [w, h] : {std::pair(1, 1), std::pair(2, 5), std::pair(30, 3)}) {
        const Colours black(std::size_t(w) * h, glm::vec3(0)), white(black.size(), glm::vec3(1));
        const ErrorMeter meter(black, w, h);
        EXPECT_NEAR(meter.measure(black).ssim, 1, 1e-6);
        EXPECT_EQ(meter.measure(black).flip, 0);
        EXPECT_LT(meter.measure(white).ssim, .01);
        EXPECT_GT(meter.measure(white).flip, .9);
    }
    EXPECT_EQ(ErrorMeter({}, 0, 0).measure({}).l1, 0);
}

}  // namespace
}  // namespace povpreview
