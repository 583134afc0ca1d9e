// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Pictures with detail as GL draws them, against the rule in double precision.
#include <gtest/gtest.h>

#include <functional>
#include <random>

#include "display/offscreen.h"
#include "tests/core/detail/shown_detail.h"
#include "tests/display/pictures.h"

namespace povpreview::test {
namespace {

std::vector<Backend> backends() {
#ifdef POVPREVIEW_HAVE_OSMESA
    return {Backend::egl, Backend::osmesa};
#else
    return {Backend::egl};
#endif
}

constexpr std::uint32_t unknown = DetailMap::unknown;
constexpr int width = 48, height = 36;

/// What is to be known of each pixel.
struct Known {
    std::function<std::uint32_t(int, int)> item = [](int, int) { return unknown; };
    std::function<std::optional<glm::vec3>(int, int)> albedo = [](int, int) {
        return std::nullopt;
    };
};

/// Items are numbered as they are, if each has a pixel and the first come first; here `items` say
/// so before any pixel is told.
std::shared_ptr<const DetailMap> detail_of(const Known& known, std::uint32_t items) {
    ItemNumbers numbers;
    for (std::uint32_t i = 0; i < items; ++i) numbers.of(i + 1);
    ItemBuffer buffer;
    buffer.width = width;
    buffer.height = height;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const std::uint32_t item = known.item(x, y);
            const auto albedo = known.albedo(x, y);
            buffer.surfaces.push_back(item == unknown ? ItemBuffer::unknown : item + 1);
            buffer.kinds.push_back(albedo ? Look::Kind::image : Look::Kind::plain);
            buffer.albedos.push_back(albedo.value_or(glm::vec3(0)));
        }
    auto detail = std::make_shared<DetailMap>(width, height);
    detail->accept(buffer, numbers);
    return detail;
}

/// Triangles with random light, of items 0 to `items` - 1, some of unknown; all shaded but few.
Picture random_light(std::uint32_t items, unsigned seed, bool one_item_a_triangle = false) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> unit(0, 1);
    const auto colour = [&] { return glm::vec3(unit(random), unit(random), unit(random)); };
    Picture picture = jittered_grid(width, height, 6, 5, seed, [&](glm::vec2) { return colour(); });
    std::uint32_t item = 0;
    for (std::size_t i = 0; i < picture.corners.size(); ++i) {
        if (i % 3 == 0 || !one_item_a_triangle) item = std::uint32_t(random() % (items + 1));
        picture.lights.push_back(
            {2.f * colour(), .3f * colour(), item == items ? unknown : item, random() % 8 != 0});
    }
    picture.first_anchors = {0};
    for (std::uint32_t i = 0; i < items; ++i) {
        // The first item has none.
        for (std::uint32_t n = 0; n < 3 * i; ++n)
            picture.anchors.push_back({{{width * unit(random), height * unit(random)}, colour()},
                                       {2.f * colour(), .3f * colour(), i, random() % 4 != 0}});
        picture.first_anchors.push_back(static_cast<std::uint32_t>(picture.anchors.size()));
    }
    return picture;
}

class DetailLayerTest : public testing::TestWithParam<Backend> {
   protected:
    static Offscreen& offscreen() {
        static Offscreen egl{open_offscreen(Backend::egl)};
        if (GetParam() == Backend::egl) return egl;
        static Offscreen osmesa{open_offscreen(GetParam())};
        return osmesa;
    }

    /// Holds each pixel well inside of a triangle against the rule; at least `least` of them, as a
    /// share. `slack`: absolute, and as a share of the colour.
    static void expect_rule(const Picture& picture, int times = 1, double slack = 2e-3,
                            double least = .6) {
        const Image image = offscreen().render(picture, width * times, height * times);
        const ShownDetail rule(picture);
        std::size_t compared = 0;
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x) {
                const glm::dvec2 position = glm::dvec2(x + .5, y + .5) / double(times);
                for (std::size_t t = 0; t < picture.corners.size(); t += 3) {
                    const glm::dvec3 w = weights_in(&picture.corners[t], position);
                    if (std::min({w.x, w.y, w.z}) < .02) continue;
                    ++compared;
                    const glm::dvec3 expected = rule.at(position, t);
                    for (int c = 0; c < 3; ++c)
                        ASSERT_NEAR(image.at(x, y)[c], expected[c],
                                    slack * (1 + std::fabs(expected[c])))
                            << "at " << x << ", " << y << " channel " << c << " of triangle " << t;
                }
            }
        EXPECT_GE(double(compared), least * double(image.pixels.size()));
    }
};

INSTANTIATE_TEST_SUITE_P(Backends, DetailLayerTest, testing::ValuesIn(backends()),
                         [](const testing::TestParamInfo<Backend>& backend) {
                             return backend.param == Backend::egl ? "egl" : "osmesa";
                         });

/// Patches of items, of which the last is not known.
std::function<std::uint32_t(int, int)> patches(std::uint32_t items) {
    return [items](int x, int y) {
        const auto i = static_cast<std::uint32_t>(x / 5 + 3 * (y / 4)) % (items + 1);
        return i == items ? unknown : i;
    };
}

/// In bands, some rows without any.
std::optional<glm::vec3> banded_albedo(int x, int y) {
    if (y % 5 == 0) return std::nullopt;
    return glm::vec3(x % 4 / 4.f, x % 2, .25f + y % 3 / 4.f);
}

TEST_P(DetailLayerTest, PixelsTakeCornersOfTheirOwnItem) {
    for (unsigned seed = 1; seed <= 4; ++seed) {
        Picture picture = random_light(4, seed);
        picture.detail = detail_of({patches(4)}, 4);
        SCOPED_TRACE(seed);
        expect_rule(picture);
    }
}

TEST_P(DetailLayerTest, PixelsOfKnownAlbedoTakeLight) {
    for (const bool one_item_a_triangle : {false, true}) {
        Picture picture = random_light(3, 7, one_item_a_triangle);
        picture.detail = detail_of({patches(3), banded_albedo}, 3);
        SCOPED_TRACE(one_item_a_triangle);
        expect_rule(picture);
    }
}

TEST_P(DetailLayerTest, MagnifiedViewsShowEachPixelsOwnDetail) {
    Picture picture = random_light(3, 9);
    picture.detail = detail_of({patches(3), banded_albedo}, 3);
    for (const int times : {2, 5}) {
        SCOPED_TRACE(times);
        expect_rule(picture, times);
    }
}

TEST_P(DetailLayerTest, BlackAlbedoLeavesTheRemainder) {
    Picture picture = random_light(2, 11);
    for (Picture::Light& light : picture.lights) light.illumination *= 1e4f;
    picture.detail = detail_of({patches(2), [](int, int) { return glm::vec3(0); }}, 2);
    expect_rule(picture);
    const Image image = offscreen().render(picture, width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            ASSERT_LE(image.at(x, y).x, 1.01f) << "light where the surface is black";
}

TEST_P(DetailLayerTest, HugeLightStaysWhatItIs) {
    Picture picture = random_light(2, 13);
    for (std::size_t i = 0; i < picture.lights.size(); i += 2) picture.lights[i].remainder *= 3e7f;
    picture.detail = detail_of({patches(2), banded_albedo}, 2);
    expect_rule(picture);
}

TEST_P(DetailLayerTest, NothingKnownIsAsWithoutDetail) {
    Picture picture = random_light(3, 15);
    const Image plain = offscreen().render(picture, width, height);
    picture.detail = detail_of({}, 3);
    const Image image = offscreen().render(picture, width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < 3; ++c)
                ASSERT_NEAR(image.at(x, y)[c], plain.at(x, y)[c], 1e-5) << x << ", " << y;
    expect_rule(picture);
}

TEST_P(DetailLayerTest, ItemsWithoutCornersTakeTheirNearestAnchor) {
    // No corner is of item 3; every pixel is. Item 0 has no anchor, and item 4 none in the table.
    for (const std::uint32_t item : {0u, 3u, 4u}) {
        Picture picture = random_light(4, 17);
        for (Picture::Light& light : picture.lights)
            if (light.item == item) light.item = unknown;
        picture.detail = detail_of({[=](int, int) { return item; }, banded_albedo}, 5);
        SCOPED_TRACE(item);
        expect_rule(picture);
    }
}

TEST_P(DetailLayerTest, ManyItemsAndAnchors) {
    // More than a row of the tables that hold them.
    constexpr std::uint32_t items = 1500;
    Picture picture = random_light(3, 19);
    picture.anchors.clear();
    picture.first_anchors = {0};
    std::mt19937 random(19);
    for (std::uint32_t i = 0; i < items; ++i) {
        for (std::uint32_t n = 0; n < i % 3; ++n)
            picture.anchors.push_back(
                {{{float(random() % width), float(random() % height)},
                  glm::vec3(float(i) / items, .5f, float(n))},
                 {glm::vec3(2, float(i) / items, 1), glm::vec3(.1f), i, true}});
        picture.first_anchors.push_back(static_cast<std::uint32_t>(picture.anchors.size()));
    }
    picture.detail =
        detail_of({[](int x, int y) { return static_cast<std::uint32_t>(y * width + x) % items; },
                   banded_albedo},
                  items);
    expect_rule(picture);
}

TEST_P(DetailLayerTest, KnownPixelsHideTheDetail) {
    Picture picture = random_light(3, 21);
    picture.detail = detail_of({patches(3), banded_albedo}, 3);
    const auto colour = [](int x, int y) { return glm::vec3(x, y, 7); };
    fill_pixels(picture, colour, [](int x, int) { return x % 2 == 0; });
    const Image image = offscreen().render(picture, width, height);
    const Image expected = [&] {
        Picture bare = picture;
        bare.pixels.clear();
        bare.known.clear();
        return offscreen().render(bare, width, height);
    }();
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            ASSERT_EQ(image.at(x, y), x % 2 == 0 ? colour(x, y) : expected.at(x, y));
}

}  // namespace
}  // namespace povpreview::test
