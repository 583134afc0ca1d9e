// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/detail/edge_detail.h"

#include <gtest/gtest.h>

#include <array>
#include <functional>

#include "core/colour.h"
#include "core/edge_weight.h"
#include "core/mesh.h"

namespace povpreview::test {
namespace {

constexpr int width = 60, height = 40;

/// Items 0, 1 ... as told, by surfaces 1, 2 ...; 9 is none that is known.
DetailMap map_of(const std::function<std::uint32_t(int, int)>& item,
                 Look::Kind kind = Look::Kind::plain) {
    ItemNumbers numbers;
    for (std::uint32_t i = 1; i < 6; ++i) numbers.of(i);
    ItemBuffer drawn{width, height, {}, {}, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const std::uint32_t i = item(x, y);
            drawn.surfaces.push_back(i == 9 ? ItemBuffer::unknown : i + 1);
            drawn.kinds.push_back(kind);
            drawn.albedos.push_back(glm::vec3(.5f));
        }
    DetailMap map(width, height);
    map.accept(drawn, numbers);
    return map;
}

VertexSample sample_at(glm::dvec2 position, std::uint32_t item, glm::vec3 albedo,
                       glm::vec3 illumination, glm::vec3 remainder = glm::vec3(0)) {
    VertexSample sample;
    sample.position = position;
    sample.item = item;
    sample.state = VertexSample::State::known;
    sample.shaded = true;
    sample.albedo = albedo;
    sample.illumination = illumination;
    sample.remainder = remainder;
    sample.colour = albedo * illumination + remainder;
    sample.encoded = display_encoded(sample.colour);
    return sample;
}

const glm::vec3 dark(.05f), bright(.9f), sun(.8f, .7f, .6f);

TEST(DetailedDistance, IsThatOfColoursWhereNothingIsKnown) {
    const DetailMap nothing(width, height);
    const VertexSample p = sample_at({10.5, 10.5}, 1, dark, sun),
                       q = sample_at({30.5, 10.5}, 1, bright, sun);
    EXPECT_EQ(detailed_distance(nothing, p, q, .37f), .37f);
    VertexSample r = q;
    r.item = DetailMap::unknown;
    const DetailMap known = map_of([](int, int) { return 1u; }, Look::Kind::image);
    EXPECT_EQ(detailed_distance(known, p, r, .37f), .37f);
    EXPECT_EQ(detailed_distance(known, r, p, .37f), .37f);
}

TEST(DetailedDistance, IsThatOfLightAloneWhereTheAlbedoIsKnown) {
    const DetailMap known = map_of([](int, int) { return 1u; }, Look::Kind::image);
    const VertexSample p = sample_at({10.5, 10.5}, 1, dark, sun),
                       q = sample_at({30.5, 10.5}, 1, bright, sun),
                       shadow = sample_at({30.5, 10.5}, 1, bright, .1f * sun);
    const float colours = colour_distance(p.encoded, q.encoded);
    EXPECT_FLOAT_EQ(detailed_distance(known, p, q, colours), 0);
    EXPECT_GT(detailed_distance(known, p, shadow, .5f), .02f) << "a shadow is no texture";
    // Plain surfaces: what differs is not told by the albedo.
    const DetailMap plain = map_of([](int, int) { return 1u; });
    EXPECT_EQ(detailed_distance(plain, p, q, colours), colours);
    VertexSample unshaded = q;
    unshaded.shaded = false;
    EXPECT_EQ(detailed_distance(known, p, unshaded, colours), colours);
}

TEST(DetailedDistance, LittleIsLeftAcrossTheBorderOfKnownItems) {
    const DetailMap known = map_of([](int x, int) { return x < 20 ? 1u : 2u; });
    const VertexSample p = sample_at({10.5, 10.5}, 1, dark, sun),
                       q = sample_at({30.5, 10.5}, 2, bright, sun);
    const float left = detailed_distance(known, p, q, .4f);
    EXPECT_GT(left, 0);
    EXPECT_LT(left, .2f * .4f);
    EXPECT_FLOAT_EQ(detailed_distance(known, q, p, .4f), left);
    // Where a sample's own pixel is not known to show its item, nothing keeps the colours apart.
    const VertexSample elsewhere = sample_at({12.5, 10.5}, 2, bright, sun);
    EXPECT_EQ(detailed_distance(known, p, elsewhere, .4f), .4f);
}

TEST(LightDistance, IsSymmetricAndTakesNoHeedOfTexture) {
    const VertexSample p = sample_at({1, 1}, 1, dark, sun), q = sample_at({9, 1}, 1, bright, sun),
                       r = sample_at({9, 1}, 1, bright, .3f * sun, glm::vec3(.1f));
    EXPECT_FLOAT_EQ(light_distance(p, q), 0);
    EXPECT_FLOAT_EQ(light_distance(p, r), light_distance(r, p));
    EXPECT_GT(light_distance(p, r), .01f);
    // On black, light does not show.
    const VertexSample s = sample_at({1, 1}, 1, glm::vec3(0), sun),
                       t = sample_at({1, 1}, 1, glm::vec3(0), 50.f * sun);
    EXPECT_FLOAT_EQ(light_distance(s, t), 0);
}

constexpr std::array<std::uint32_t, 2> ends{0, 1};

TEST(StrayPixel, IsInTheMiddleOfTheLongestStretchOfAnotherItem) {
    // 0 . . . 2 2 . . . 3 3 3 3 3 3 3 . . 1
    const DetailMap map = map_of([](int x, int) {
        if (x < 8) return 0u;
        if (x < 12) return 2u;
        if (x < 20) return 0u;
        return x < 34 ? 3u : 1u;
    });
    for (const bool turned : {false, true}) {
        const glm::dvec2 p(2.5, 10.5), q(42.5, 10.5);
        const auto stray = stray_pixel(map, turned ? q : p, turned ? p : q, ends);
        ASSERT_TRUE(stray);
        EXPECT_EQ(*stray / width, 10u);
        EXPECT_EQ(map.item(*stray), 3u);
        EXPECT_NEAR(double(*stray % width), 26.5, 1.6);
    }
}

TEST(StrayPixel, NeedsAStretchThatIsKnownAndLongEnough) {
    const auto with = [](int from, int to, std::uint32_t item) {
        return map_of([=](int x, int) { return x >= from && x < to ? item : 0u; });
    };
    const glm::dvec2 p(2.5, 10.5), q(22.5, 10.5);
    EXPECT_TRUE(stray_pixel(with(8, 14, 2), p, q, ends));
    EXPECT_FALSE(stray_pixel(with(8, 14, 1), p, q, ends)) << "an end's own";
    EXPECT_FALSE(stray_pixel(with(8, 14, 9), p, q, ends)) << "not known";
    EXPECT_FALSE(stray_pixel(with(8, 10, 2), p, q, ends)) << "two pixels";
    EXPECT_FALSE(stray_pixel(with(0, 60, 0), p, q, ends));
    EXPECT_FALSE(stray_pixel(with(0, 60, 2), p, {6.5, 10.5}, ends)) << "a short edge";
}

TEST(StrayPixel, ChecksItsLineInEveryDirection) {
    // A disc of another item right in the middle of the image.
    const DetailMap map = map_of([](int x, int y) {
        const double dx = x - 30., dy = y - 20.;
        return dx * dx + dy * dy < 36 ? 2u : 0u;
    });
    for (int i = 0; i < 24; ++i) {
        const double angle = i * .2617993878;
        const glm::dvec2 away(17 * std::cos(angle), 17 * std::sin(angle)), middle(30.5, 20.5);
        const auto stray = stray_pixel(map, middle - away, middle + away, ends);
        ASSERT_TRUE(stray) << i;
        EXPECT_EQ(map.item(*stray), 2u);
        EXPECT_LE(std::hypot(double(*stray % width) - 30, double(*stray / width) - 20.), 2.5);
        // Past the disc.
        const glm::dvec2 beside(-away.y / 17 * 9, away.x / 17 * 9);
        EXPECT_FALSE(stray_pixel(map, middle + beside - away, middle + beside + away, ends)) << i;
    }
}

}  // namespace
}  // namespace povpreview::test
