// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/offscreen.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "core/colour.h"
#include "core/error.h"
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

/// The laws of drawing, for each maker of contexts.
class OffscreenTest : public testing::TestWithParam<Backend> {
   protected:
    Offscreen offscreen{open_offscreen(GetParam())};
};

INSTANTIATE_TEST_SUITE_P(Backends, OffscreenTest, testing::ValuesIn(backends()),
                         [](const testing::TestParamInfo<Backend>& backend) {
                             return backend.param == Backend::egl ? "egl" : "osmesa";
                         });

bool same_bits(const glm::vec3& a, const glm::vec3& b) {
    for (int c = 0; c < 3; ++c)
        if (std::bit_cast<std::uint32_t>(a[c]) != std::bit_cast<std::uint32_t>(b[c])) return false;
    return true;
}

/// Floats of all magnitudes and signs that a tracer may give; not the denormal ones, which software
/// renderers may flush to 0.
glm::vec3 wild_colour(int x, int y) {
    std::uint32_t noise = static_cast<std::uint32_t>(7919 * x + y) * 2654435769u + 1;
    glm::vec3 colour;
    for (int c = 0; c < 3; ++c) {
        noise = noise * 1664525u + 1013904223u;
        // any mantissa, an exponent from -32 to 31, any sign
        const std::uint32_t exponent = 95 + (noise >> 26);
        colour[c] = std::bit_cast<float>((noise & 0x807FFFFFu) | exponent << 23);
    }
    return colour;
}

constexpr auto always = [](int, int) { return true; };

TEST_P(OffscreenTest, KnownPixelsComeBackBitByBit) {
    // 1 x 1, a row, a column, odd sizes, and one across the border between tiles
    for (const auto& [width, height] :
         {std::pair{1, 1}, {7, 1}, {1, 7}, {3, 1000}, {333, 77}, {2500, 3}, {3, 2050}}) {
        Picture picture;
        picture.width = width;
        picture.height = height;
        fill_pixels(picture, wild_colour, always);
        const Image image = offscreen.render(picture, width, height);
        ASSERT_EQ(image.pixels.size(), picture.pixels.size());
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                ASSERT_TRUE(same_bits(image.at(x, y), wild_colour(x, y)))
                    << width << " x " << height << " at " << x << ", " << y;
    }
}

TEST_P(OffscreenTest, InfinitePixelsStayInfinite) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    Picture picture;
    picture.width = picture.height = 2;
    fill_pixels(
        picture, [](int x, int y) { return glm::vec3(x ? infinity : -infinity, y, 1); }, always);
    const Image image = offscreen.render(picture, 2, 2);
    EXPECT_EQ(image.at(1, 1), glm::vec3(infinity, 1, 1));
    EXPECT_EQ(image.at(0, 0), glm::vec3(-infinity, 0, 1));
}

/// The colour at `p` by barycentric coordinates, from areas in double precision; the last value
/// tells how far inside p is (negative: outside).
std::pair<glm::dvec3, double> barycentric(const Picture::Corner* corner, glm::dvec2 p) {
    const auto twice_area = [](glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
        return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    };
    const glm::dvec2 a = corner[0].position, b = corner[1].position, c = corner[2].position;
    const double all = twice_area(a, b, c);
    const double u = twice_area(p, b, c) / all, v = twice_area(a, p, c) / all, w = 1 - u - v;
    return {u * glm::dvec3(corner[0].colour) + v * glm::dvec3(corner[1].colour) +
                w * glm::dvec3(corner[2].colour),
            std::min({u, v, w})};
}

TEST_P(OffscreenTest, TrianglesInterpolateInLinearLight) {
    Picture picture;
    picture.width = 64;
    picture.height = 48;
    picture.corners = {
        {{2.25f, 1.5f}, {1, 0, 0}}, {{61.5f, 20}, {0, 1, 0}}, {{10, 46.75f}, {0, 0, 1}}};
    // the last one in several tiles; there a part of the pixels is looked at, of all tiles
    for (const auto& [times, step] : {std::pair{1, 1}, {3, 1}, {8, 3}, {33, 7}}) {
        const Image image = offscreen.render(picture, 64 * times, 48 * times);
        int inside = 0, outside = 0;
        for (int y = 0; y < image.height; y += step) {
            for (int x = 0; x < image.width; x += step) {
                const auto [colour, depth] =
                    barycentric(picture.corners.data(), glm::dvec2(x + .5, y + .5) / double(times));
                if (depth > .01) {
                    ++inside;
                    for (int c = 0; c < 3; ++c)
                        ASSERT_NEAR(image.at(x, y)[c], colour[c], 1e-3) << x << ", " << y;
                } else if (depth < -.01) {
                    ++outside;
                    ASSERT_EQ(image.at(x, y), glm::vec3(0)) << x << ", " << y;
                }
            }
        }
        EXPECT_GT(inside * step * step, 64 * 48 * times * times / 4);
        EXPECT_GT(outside * step * step, 64 * 48 * times * times / 4);
    }
}

TEST_P(OffscreenTest, TrianglesAtPixelCentresGiveTheirCornersColours) {
    // Vertices sit on pixel centres wherever they may: their samples must show unchanged.
    Picture picture;
    picture.width = picture.height = 16;
    picture.corners = {{{.5f, .5f}, {.1f, .9f, 3}},     {{15.5f, .5f}, {.7f, .2f, 0}},
                       {{.5f, 15.5f}, {.3f, .3f, .3f}}, {{.5f, 15.5f}, {.3f, .3f, .3f}},
                       {{15.5f, .5f}, {.7f, .2f, 0}},   {{15.5f, 15.5f}, {.1f, 0, .4f}}};
    const Image image = offscreen.render(picture, 16, 16);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(image.at(0, 0)[c], picture.corners[0].colour[c], 1e-5);
}

TEST_P(OffscreenTest, AMeshHasNoCracks) {
    for (unsigned seed = 1; seed <= 5; ++seed) {
        const Picture picture =
            jittered_grid(97, 61, 31, 23, seed, [](glm::vec2) { return glm::vec3(1); });
        for (const int samples : {1, 4}) {
            const Image image = offscreen.render(picture, 301, 199, samples);
            for (const glm::vec3& colour : image.pixels)
                for (int c = 0; c < 3; ++c) ASSERT_NEAR(colour[c], 1, 1e-5) << "seed " << seed;
        }
    }
}

TEST_P(OffscreenTest, InterpolationNeverLeavesTheRangeOfTheCorners) {
    // Where a triangle covers part of a pixel, its colour must not be extrapolated.
    const Picture picture = jittered_grid(40, 30, 37, 29, 4, [](glm::vec2 p) {
        return glm::vec3(std::fmod(p.x, 2.f) < 1 ? 0 : 1, std::fmod(p.y, 2.f) < 1 ? 0 : 1, .5f);
    });
    for (const int samples : {1, 4}) {
        for (const glm::vec3& colour : offscreen.render(picture, 40, 30, samples).pixels) {
            for (int c = 0; c < 3; ++c) {
                ASSERT_GE(colour[c], -1e-3f);
                ASSERT_LE(colour[c], 1 + 1e-3f);
            }
        }
    }
}

TEST_P(OffscreenTest, KnownPixelsHideTrianglesAndOnlyThere) {
    Picture picture = jittered_grid(20, 10, 4, 4, 1, [](glm::vec2) { return glm::vec3(0, 1, 0); });
    const auto known = [](int x, int y) { return (x * 7 + y * 3) % 5 < 2; };
    fill_pixels(
        picture, [](int x, int) { return glm::vec3(1 + x, 0, 0); }, known);
    for (const int samples : {1, 4}) {
        for (const int times : {1, 5}) {
            const Image image = offscreen.render(picture, 20 * times, 10 * times, samples);
            for (int y = 0; y < image.height; ++y) {
                for (int x = 0; x < image.width; ++x) {
                    const glm::vec3 colour = image.at(x, y);
                    const glm::vec3 expected = known(x / times, y / times)
                                                   ? glm::vec3(1 + x / times, 0, 0)
                                                   : glm::vec3(0, 1, 0);
                    ASSERT_NEAR(glm::length(colour - expected), 0, 1e-5) << x << ", " << y;
                }
            }
        }
    }
}

TEST_P(OffscreenTest, AMagnifiedEdgeStaysCrisp) {
    const Picture picture = step_edge(40, 30, 18.3f, 21.9f);
    for (const int samples : {1, 4}) {
        const Image image = offscreen.render(picture, 320, 240, samples);
        for (int y = 0; y < image.height; ++y) {
            int between = 0;
            for (int x = 0; x < image.width; ++x) {
                const float value = image.at(x, y).x;
                if (value > .01f && value < .99f) ++between;
                const double edge = 8 * (18.3 + (21.9 - 18.3) * (y + .5) / 240);
                if (std::abs(x + .5 - edge) > 1.5) {
                    ASSERT_NEAR(value, x > edge, 1e-5);
                }
            }
            ASSERT_LE(between, samples == 1 ? 0 : 1) << "row " << y;
        }
    }
}

TEST_P(OffscreenTest, MultisamplingAveragesCoverageInLinearLight) {
    const Picture picture = step_edge(50, 40, 10.2f, 37.4f);
    const Image rough = offscreen.render(picture, 50, 40, 1);
    const Image smooth = offscreen.render(picture, 50, 40, 4);
    int between = 0;
    double covered = 0;
    for (const glm::vec3& colour : rough.pixels) ASSERT_TRUE(colour.x == 0 || colour.x == 1);
    for (const glm::vec3& colour : smooth.pixels) {
        if (colour.x > .1f && colour.x < .9f) ++between;
        covered += colour.x;
    }
    EXPECT_GE(between, 30);  // about one in each of 40 rows
    const double exact = 50 * 40 - 40 * (10.2 + 37.4) / 2;
    EXPECT_NEAR(covered, exact, .02 * exact);
}

TEST_P(OffscreenTest, LightsBeyondADisplayHaveSmoothRimsInItsRange) {
    Picture picture = step_edge(50, 40, 10.2f, 37.4f);
    for (auto& corner : picture.corners) corner.colour *= 100;
    fill_pixels(
        picture, [](int, int y) { return glm::vec3(y % 2 ? 7 : -7); },
        [](int x, int) { return x == 0; });
    const Image image = offscreen.render(picture, 50, 40, 4, Overlay::none, Range::display);
    int between = 0;
    for (int y = 0; y < 40; ++y) {
        ASSERT_EQ(image.at(0, y), glm::vec3(y % 2));
        for (int x = 1; x < 50; ++x) {
            ASSERT_TRUE(image.at(x, y).x >= 0 && image.at(x, y).x <= 1);
            between += image.at(x, y).x > .1f && image.at(x, y).x < .9f;
        }
    }
    EXPECT_GE(between, 30);  // about one in each of 40 rows
}

TEST_P(OffscreenTest, MoreSamplesThanThereAreIsNoError) {
    const Picture picture = step_edge(20, 20, 5, 15);
    EXPECT_EQ(offscreen.render(picture, 20, 20, 64).pixels.size(), 400u);
}

TEST_P(OffscreenTest, SizesOutOfReachAreErrors) {
    const Picture picture = step_edge(4, 4, 1, 2);
    for (const auto& [width, height] :
         {std::pair{0, 4}, {4, 0}, {-1, 4}, {65536, 1}, {1, 1 << 30}, {40000, 40000}}) {
        try {
            offscreen.render(picture, width, height);
            ADD_FAILURE() << width << " x " << height << " was drawn";
        } catch (const Error& error) {
            EXPECT_EQ(error.exit(), Exit::usage);
            EXPECT_NE(std::string(error.what()).find(std::to_string(width)), std::string::npos)
                << error.what();
        }
    }
    EXPECT_EQ(offscreen.render(picture, 4, 4).pixels.size(), 16u) << "it goes on afterwards";
}

TEST_P(OffscreenTest, APictureWiderThanATextureIsDrawn) {
    Picture picture;
    picture.width = 40000;
    picture.height = 2;
    fill_pixels(
        picture, [](int x, int y) { return glm::vec3(x, y, 1); }, always);
    const Image image = offscreen.render(picture, 40000, 2);
    for (const int x : {0, 2047, 2048, 4095, 4096, 16383, 16384, 32768, 39999})
        EXPECT_EQ(image.at(x, 1), glm::vec3(x, 1, 1));
}

TEST_P(OffscreenTest, NotANumberStaysInItsTriangle) {
    Picture picture = step_edge(16, 16, 8, 8);
    picture.corners[0].colour = glm::vec3(std::numeric_limits<float>::quiet_NaN());
    const Image image = offscreen.render(picture, 16, 16, 4);
    for (int y = 0; y < 16; ++y)
        for (int x = 9; x < 16; ++x) ASSERT_EQ(image.at(x, y), glm::vec3(1));
}

TEST_P(OffscreenTest, AnEmptyPictureIsBlack) {
    Picture picture;
    picture.width = 5;
    picture.height = 3;
    for (const glm::vec3& colour : offscreen.render(picture, 10, 6, 4).pixels)
        ASSERT_EQ(colour, glm::vec3(0));
}

TEST_P(OffscreenTest, NothingOfAnEarlierPictureIsLeft) {
    Picture full = step_edge(8, 8, 2, 6);
    fill_pixels(
        full, [](int, int) { return glm::vec3(2); }, [](int x, int) { return x == 3; });
    const Image before = offscreen.render(full, 8, 8);
    Picture other = step_edge(5, 9, 1, 2);
    offscreen.render(other, 31, 17, 4);
    EXPECT_EQ(offscreen.render(full, 8, 8).pixels, before.pixels);
}

/// Triangles of any size and place, overlapping.
Picture random_triangles(unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> x(-10, 330), y(-10, 250), spread(-30, 30), shade(0, 1);
    Picture picture;
    picture.width = 320;
    picture.height = 240;
    for (int triangle = 0; triangle < 2000; ++triangle) {
        const glm::vec2 middle(x(random), y(random));
        for (int corner = 0; corner < 3; ++corner)
            picture.corners.push_back({middle + glm::vec2(spread(random), spread(random)),
                                       {shade(random), shade(random), shade(random)}});
    }
    return picture;
}

TEST(OffscreenBackends, AgreeOnRandomTriangles) {
    if (backends().size() < 2) GTEST_SKIP() << "built without OSMesa";
    Offscreen egl(open_offscreen(Backend::egl)), osmesa(open_offscreen(Backend::osmesa));
    const Picture picture = random_triangles(42);
    for (const int samples : {1, 4}) {
        const Image a = egl.render(picture, 640, 480, samples);
        const Image b = osmesa.render(picture, 640, 480, samples);
        std::size_t different = 0, lit = 0;
        for (std::size_t i = 0; i < a.pixels.size(); ++i) {
            const glm::vec3 apart =
                glm::abs(display_encoded(a.pixels[i]) - display_encoded(b.pixels[i]));
            different += std::max({apart.x, apart.y, apart.z}) > 2 / 255.f;
            lit += a.pixels[i] != glm::vec3(0);
        }
        EXPECT_LE(different, a.pixels.size() / 1000) << samples << " samples, seed 42";
        EXPECT_GT(lit, a.pixels.size() / 2);
    }
}

TEST(OffscreenBackends, LiveSideBySide) {
    if (backends().size() < 2) GTEST_SKIP() << "built without OSMesa";
    const Picture picture = random_triangles(7);
    const Image alone = Offscreen(open_offscreen(Backend::egl)).render(picture, 200, 150);
    Offscreen first(open_offscreen(Backend::egl)), second(open_offscreen(Backend::osmesa));
    auto third = std::make_unique<Offscreen>(open_offscreen(Backend::egl));
    for (int round = 0; round < 3; ++round) {
        for (Offscreen* offscreen : {&first, &second, third.get()}) {
            if (!offscreen) continue;
            const Image image = offscreen->render(picture, 200, 150);
            std::size_t different = 0;
            for (std::size_t i = 0; i < image.pixels.size(); ++i)
                different += glm::length(image.pixels[i] - alone.pixels[i]) > .01f;
            EXPECT_LE(different, image.pixels.size() / 1000) << "round " << round;
        }
        third.reset();  // one that dies must not take others with it
    }
}

}  // namespace
}  // namespace povpreview::test
