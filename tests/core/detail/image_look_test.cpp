// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/detail/image_look.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/packing.hpp>
#include <limits>
#include <numbers>
#include <random>

namespace povpreview {
namespace {

using Mapping = ImageLook::Mapping;
using Interpolation = ImageLook::Interpolation;

constexpr double pi = std::numbers::pi;
constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr std::uint16_t half_one = 0x3c00;

constexpr Mapping mappings[] = {Mapping::planar, Mapping::spherical, Mapping::cylindrical,
                                Mapping::toroidal, Mapping::uv};
constexpr Interpolation interpolations[] = {Interpolation::none, Interpolation::bilinear,
                                            Interpolation::bicubic,
                                            Interpolation::normalised_distance};

/// A scene of one image, in linear light.
template <typename Colour>  // of (column, row), row 0 on top
DrawableScene scene_of(int width, int height, const Colour& colour) {
    DrawableScene scene;
    ImageTexels& image = scene.images.emplace_back();
    image.width = static_cast<std::uint32_t>(width);
    image.height = static_cast<std::uint32_t>(height);
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column) {
            const glm::vec3 c = colour(column, row);
            image.texels.push_back(
                {glm::packHalf1x16(c.r), glm::packHalf1x16(c.g), glm::packHalf1x16(c.b), half_one});
        }
    return scene;
}

/// Red is the column, green the row; halves hold whole numbers to 2048 exactly.
DrawableScene numbered(int width, int height) {
    return scene_of(width, height, [](int x, int y) { return glm::vec3(x, y, 7); });
}

/// A row of grey texels.
DrawableScene row_of(const std::vector<float>& values) {
    return scene_of(static_cast<int>(values.size()), 1,
                    [&](int x, int) { return glm::vec3(values[static_cast<std::size_t>(x)]); });
}

ImageLook look_of(Mapping mapping, Interpolation interpolation = Interpolation::none,
                  bool once = false) {
    ImageLook look;
    look.mapping = mapping;
    look.interpolation = interpolation;
    look.once = once;
    return look;
}

std::optional<glm::vec3> at(const DrawableScene& scene, const ImageLook& look,
                            const glm::dvec3& point) {
    return image_albedo(scene, look, point, {});
}

/// Of a planar image over the unit square, at texels from its upper left corner.
glm::vec3 at_texel(const DrawableScene& scene, double x, double y, Interpolation interpolation,
                   bool once = false) {
    const ImageTexels& image = scene.images.front();
    const auto found = at(scene, look_of(Mapping::planar, interpolation, once),
                          {x / image.width, 1 - y / image.height, 0});
    EXPECT_TRUE(found) << x << " " << y;
    return found.value_or(glm::vec3(-1));
}

void expect_near(const std::optional<glm::vec3>& found, const glm::vec3& expected,
                 float tolerance = 1e-5f) {
    ASSERT_TRUE(found);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR((*found)[i], expected[i], tolerance) << "channel " << i;
}

/// The point that a mapping takes to shares of the image, rightwards and upwards: the surface the
/// mapping is made for, by its own parameters.
glm::dvec3 surface_point(Mapping mapping, double u, double v) {
    const glm::dvec3 out(std::cos(2 * pi * u), 0, std::sin(2 * pi * u)), up(0, 1, 0);
    switch (mapping) {
        case Mapping::spherical:
            return std::cos(pi * (v - .5)) * out + std::sin(pi * (v - .5)) * up;
        case Mapping::cylindrical:
            return out + v * up;
        case Mapping::toroidal:  // from the inside, by the lower half first
            return out + .25 * (-std::cos(2 * pi * v) * out - std::sin(2 * pi * v) * up);
        case Mapping::planar:
        case Mapping::uv:
            break;
    }
    return {u, v, .3};
}

TEST(ImageLook, EveryMappingFindsTheTexelOfItsOwnSurface) {
    constexpr int seed = 71;
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> share(0, 1), size(.1, 10);
    const DrawableScene scene = numbered(37, 19);
    for (const Mapping mapping : mappings)
        for (int i = 0; i < 2000; ++i) {
            const double u = share(random), v = share(random);
            glm::dvec3 p = surface_point(mapping, u, v);
            // Spherical and cylindrical images are cast outwards from a point and from an axis.
            if (mapping == Mapping::spherical) p *= size(random);
            if (mapping == Mapping::cylindrical) p *= glm::dvec3(2.5, 1, 2.5);
            const auto found =
                image_albedo(scene, look_of(mapping, Interpolation::none, i % 2 == 0), p, {u, v});
            ASSERT_TRUE(found) << int(mapping) << " " << u << " " << v;
            EXPECT_EQ(*found, glm::vec3(std::floor(37 * u), std::floor(19 * (1 - v)), 7))
                << int(mapping) << " " << u << " " << v;
        }
}

TEST(ImageLook, MappingsAtKnownPoints) {
    const DrawableScene scene = numbered(8, 8);
    const auto texel = [&](Mapping mapping, const glm::dvec3& p) {
        return glm::vec2(at(scene, look_of(mapping), p).value_or(glm::vec3(-1)));
    };
    // Around the y axis from x by z; a point on a border belongs to the texel right of and above
    // it.
    EXPECT_EQ(texel(Mapping::cylindrical, {1, .5, 0}), glm::vec2(0, 3));
    EXPECT_EQ(texel(Mapping::cylindrical, {0, .5, 1}), glm::vec2(2, 3));
    EXPECT_EQ(texel(Mapping::cylindrical, {-1, .5, 0}), glm::vec2(4, 3));
    EXPECT_EQ(texel(Mapping::cylindrical, {0, .5, -1}), glm::vec2(6, 3));
    EXPECT_EQ(texel(Mapping::cylindrical, {1, .5, -1e-3}), glm::vec2(7, 3));
    EXPECT_EQ(texel(Mapping::spherical, {0, -1, 0}), glm::vec2(0, 7));
    EXPECT_EQ(texel(Mapping::spherical, {2, 1.9, 2}), glm::vec2(1, 2));
    EXPECT_EQ(texel(Mapping::spherical, {1e-9, 1, 0}), glm::vec2(0, 0));
    EXPECT_EQ(texel(Mapping::toroidal, {.5, -1e-6, 0}), glm::vec2(0, 7));
    EXPECT_EQ(texel(Mapping::toroidal, {1, -.5, 0}), glm::vec2(0, 5));
    EXPECT_EQ(texel(Mapping::toroidal, {0, .1, 1.5}), glm::vec2(2, 3));
    EXPECT_EQ(texel(Mapping::toroidal, {1, .5, 0}), glm::vec2(0, 1));
    EXPECT_EQ(texel(Mapping::planar, {.3, .9, 1e6}), glm::vec2(2, 0));
    // Where the angle is none.
    for (const bool once : {false, true}) {
        EXPECT_FALSE(at(scene, look_of(Mapping::spherical, {}, once), {0, 0, 0}));
        EXPECT_FALSE(at(scene, look_of(Mapping::cylindrical, {}, once), {0, .5, 0}));
        EXPECT_FALSE(at(scene, look_of(Mapping::toroidal, {}, once), {0, .5, 0}));
        EXPECT_FALSE(at(scene, look_of(Mapping::toroidal, {}, once), {0, 0, 1}));
    }
}

TEST(ImageLook, GoesToThePigmentsSpaceFirst) {
    const DrawableScene scene = numbered(10, 10);
    for (const Mapping mapping : {Mapping::planar, Mapping::uv}) {
        ImageLook look = look_of(mapping);
        look.to_map = glm::dmat4x3(
            glm::scale(glm::translate(glm::dmat4(1), {.5, 0, 0}), glm::dvec3(.1, .1, 1)));
        const glm::dvec2 p(2.5, 3.2);  // at (.75, .32)
        const auto found = image_albedo(
            scene, look, mapping == Mapping::uv ? glm::dvec3(not_a_number) : glm::dvec3(p, 0),
            mapping == Mapping::uv ? p : glm::dvec2(not_a_number));
        expect_near(found, {7, 6, 7});
    }
}

TEST(ImageLook, RepeatsWithoutEnd) {
    const DrawableScene scene = numbered(5, 4);
    for (const Interpolation interpolation : interpolations)
        for (const double x : {.1, .33, .5, .97})
            for (const double y : {.05, .4, .88}) {
                const ImageLook look = look_of(Mapping::planar, interpolation);
                const glm::vec3 here = at(scene, look, {x, y, 0}).value();
                for (const glm::dvec3& tile :
                     {glm::dvec3(1, 0, 0), glm::dvec3(0, -1, 0), glm::dvec3(-64, 4096, 0)})
                    expect_near(at(scene, look, glm::dvec3(x, y, 0) + tile), here);
            }
}

TEST(ImageLook, BordersBelongToTheTexelRightAndAbove) {
    // As a wall at x = 0 has it, in each of its points.
    const DrawableScene scene = numbered(4, 4);
    for (int i = -8; i < 8; ++i) {
        const auto right = at(scene, look_of(Mapping::planar), {i / 4., .1, 0});
        const auto above = at(scene, look_of(Mapping::planar), {.1, i / 4., 0});
        expect_near(right, {(i + 8) % 4, 3, 7});
        expect_near(above, {0, 3 - (i + 8) % 4, 7});
    }
    // Also where rounding has it a little below the image's own border, which ends a `once` map.
    const double below = std::nextafter(1., 0.);
    expect_near(at(scene, look_of(Mapping::planar), {below, below, 0}), {0, 3, 7});
    expect_near(at(scene, look_of(Mapping::planar), {-1e-18, -1e-18, 0}), {0, 3, 7});
    const ImageLook once = look_of(Mapping::planar, Interpolation::none, true);
    EXPECT_FALSE(at(scene, once, {below, .5, 0}));
    EXPECT_FALSE(at(scene, once, {.5, below, 0}));
    expect_near(at(scene, once, {1, 1, 0}), {0, 3, 7});
    // As many texels that the border is nearer to the next one than doubles tell.
    const DrawableScene tall = numbered(1, 1 << 21);
    EXPECT_TRUE(at(tall, look_of(Mapping::planar), {0, 0, 0}));
}

TEST(ImageLook, OnceEndsAtTheUnitSquare) {
    const DrawableScene scene = numbered(4, 4);
    const auto drawn = [&](Mapping mapping, double x, double y, bool once = true) {
        return at(scene, look_of(mapping, Interpolation::bilinear, once), {x, y, .5}).has_value();
    };
    for (const double inside : {0., .001, .5, .999, 1.})
        for (const double outside : {-1e-6, 1 + 1e-6, -3.5, 1e9}) {
            EXPECT_TRUE(drawn(Mapping::planar, inside, inside));
            EXPECT_FALSE(drawn(Mapping::planar, outside, inside));
            EXPECT_FALSE(drawn(Mapping::planar, inside, outside));
            EXPECT_TRUE(drawn(Mapping::planar, outside, outside, false));
            EXPECT_TRUE(drawn(Mapping::cylindrical, outside, inside));
            EXPECT_FALSE(drawn(Mapping::cylindrical, inside, outside));
            EXPECT_TRUE(drawn(Mapping::cylindrical, inside, outside, false));
            EXPECT_TRUE(drawn(Mapping::spherical, outside, outside));
            EXPECT_TRUE(drawn(Mapping::toroidal, outside, outside));
        }
}

TEST(ImageLook, InterpolationsPassThroughTexelCentres) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> value(0, 1);
    const DrawableScene scene = scene_of(
        7, 5, [&](int, int) { return glm::vec3(value(random), value(random), value(random)); });
    const ImageTexels& image = scene.images.front();
    for (const Interpolation interpolation : interpolations)
        for (int y = 0; y < 5; ++y)
            for (int x = 0; x < 7; ++x)
                for (const bool once : {false, true}) {
                    const auto& t = image.texels[static_cast<std::size_t>(y * 7 + x)];
                    expect_near(at_texel(scene, x + .5, y + .5, interpolation, once),
                                {glm::unpackHalf1x16(t[0]), glm::unpackHalf1x16(t[1]),
                                 glm::unpackHalf1x16(t[2])});
                }
}

TEST(ImageLook, InterpolationsKeepWhatTheyReproduce) {
    // Constants by all; straight lines by the bilinear one, parabolas by the bicubic one, away from
    // the borders.
    const DrawableScene flat = scene_of(6, 6, [](int, int) { return glm::vec3(.25, .5, .75); });
    const DrawableScene curved = scene_of(10, 10, [](int x, int y) {
        const float u = static_cast<float>(x) + .5f, v = static_cast<float>(y) + .5f;
        return glm::vec3(3 * u + 5 * v, 2 * u * u + v * v, u * v);
    });
    for (double x = 2.5; x < 7.5; x += .37)
        for (double y = 2.5; y < 7.5; y += .41) {
            for (const Interpolation interpolation : interpolations)
                expect_near(at_texel(flat, x - 2.4, y - 2.4, interpolation), {.25, .5, .75});
            EXPECT_NEAR(at_texel(curved, x, y, Interpolation::bilinear).r, 3 * x + 5 * y, 1e-4);
            EXPECT_NEAR(at_texel(curved, x, y, Interpolation::bilinear).b, x * y, 1e-4);
            const glm::vec3 smooth = at_texel(curved, x, y, Interpolation::bicubic);
            EXPECT_NEAR(smooth.r, 3 * x + 5 * y, 1e-4);
            EXPECT_NEAR(smooth.g, 2 * x * x + y * y, 2e-4);
            EXPECT_NEAR(smooth.b, x * y, 1e-4);
        }
}

TEST(ImageLook, InterpolationsByHand) {
    const DrawableScene step = row_of({0, 0, 1, 1, 0, 0, 8, 0});
    const auto grey = [](const DrawableScene& scene, double x, Interpolation interpolation,
                         double y = .5) { return at_texel(scene, x, y, interpolation).r; };
    EXPECT_FLOAT_EQ(grey(step, 1.9, Interpolation::none), 0);
    EXPECT_FLOAT_EQ(grey(step, 2.1, Interpolation::none), 1);
    EXPECT_NEAR(grey(step, 1.75, Interpolation::bilinear), .25, 1e-6);
    // Catmull and Rom's weights halfway are -1/16, 9/16, 9/16, -1/16; at a quarter -9/128, 111/128,
    // 29/128, -3/128.
    EXPECT_NEAR(grey(step, 2, Interpolation::bicubic), .5, 1e-6);
    EXPECT_NEAR(grey(step, 3, Interpolation::bicubic), 9 / 8., 1e-6);
    EXPECT_NEAR(grey(step, 1.75, Interpolation::bicubic), 26 / 128., 1e-6);
    EXPECT_NEAR(grey(step, 6, Interpolation::bicubic), 8 * 9 / 16., 1e-5);
    EXPECT_NEAR(grey(step, 5, Interpolation::bicubic), -9 / 16., 1e-5) << "below black";

    //  1 . 2    distances of the point a quarter right of and down from the first: squared
    //   +       2/16, 10/16, 10/16, 18/16
    //  3   9
    const DrawableScene four =
        scene_of(2, 2, [](int x, int y) { return glm::vec3(y == 0 ? 1 + x : 3 + 6 * x); });
    const double near = 16 / 2., aside = 16 / 10., far = 16 / 18.;
    EXPECT_NEAR(grey(four, .75, Interpolation::normalised_distance, .75),
                (1 * near + 2 * aside + 3 * aside + 9 * far) / (near + 2 * aside + far), 1e-5);
    EXPECT_NEAR(grey(four, .75, Interpolation::bilinear, .75),
                (9 * 1 + 3 * 2 + 3 * 3 + 1 * 9) / 16., 1e-5);
}

TEST(ImageLook, AtItsBordersOnceTakesTheSameSideOthersTheOpposite) {
    const DrawableScene row = row_of({8, 0, 0, 0, 0, 4});
    const auto grey = [&](double x, Interpolation interpolation, bool once) {
        return at_texel(row, x, .5, interpolation, once).r;
    };
    EXPECT_NEAR(grey(.25, Interpolation::bilinear, true), 8, 1e-5);
    EXPECT_NEAR(grey(.25, Interpolation::bilinear, false), .75 * 8 + .25 * 4, 1e-5);
    EXPECT_NEAR(grey(5.75, Interpolation::bilinear, true), 4, 1e-5);
    EXPECT_NEAR(grey(5.75, Interpolation::bilinear, false), .75 * 4 + .25 * 8, 1e-5);
    EXPECT_NEAR(grey(1, Interpolation::bicubic, true), (-1 + 9) / 16. * 8, 1e-5);
    EXPECT_NEAR(grey(1, Interpolation::bicubic, false), 9 / 16. * 8 - 4 / 16., 1e-5);
    // An image of one texel is its own neighbour.
    const DrawableScene one = row_of({.5f});
    for (const Interpolation interpolation : interpolations)
        for (const double x : {0., .3, .99})
            for (const bool once : {false, true})
                EXPECT_NEAR(at_texel(one, x, x / 2, interpolation, once).g, .5, 1e-6);
}

TEST(ImageLook, DecodesEveryHalf) {
    DrawableScene scene = numbered(1, 1);
    for (std::uint32_t bits = 0; bits < 0x10000; ++bits) {
        const auto half = static_cast<std::uint16_t>(bits);
        scene.images.front().texels = {{half, half_one, 0, half_one}};
        const float value = glm::unpackHalf1x16(half);
        const auto found = at(scene, look_of(Mapping::planar), {.5, .5, 0});
        ASSERT_EQ(found.has_value(), std::isfinite(value)) << bits;
        if (!found) continue;
        ASSERT_EQ(*found, glm::vec3(value, 1, 0)) << bits;
    }
}

TEST(ImageLook, WorkingGammaGoesAfterInterpolation) {
    DrawableScene scene = row_of({0, 1});
    scene.working_gamma = 2.2f;
    const double found = at_texel(scene, 1, .5, Interpolation::bilinear).r;
    EXPECT_NEAR(found, std::pow(.5, 2.2), 1e-6);
}

TEST(ImageLook, OnlyOpaqueTexelsAreDrawn) {
    DrawableScene scene = numbered(2, 1);
    scene.images.front().texels[1][3] = glm::packHalf1x16(.5f);
    const auto drawn = [&](double x, Interpolation interpolation) {
        return at(scene, look_of(Mapping::planar, interpolation, true), {x, .5, 0}).has_value();
    };
    for (const Interpolation interpolation : interpolations)
        EXPECT_FALSE(drawn(.75, interpolation));
    EXPECT_TRUE(drawn(.49, Interpolation::none));
    EXPECT_TRUE(drawn(.2, Interpolation::bilinear));
    EXPECT_FALSE(drawn(.45, Interpolation::bilinear));
}

TEST(ImageLook, ImagesThatAreNotOnes) {
    const ImageLook planar = look_of(Mapping::planar, Interpolation::bicubic);
    const glm::dvec3 p(.5, .5, 0);
    DrawableScene scene = numbered(3, 3);
    ASSERT_TRUE(at(scene, planar, p));
    ImageLook missing = planar;
    missing.image = 1;
    EXPECT_FALSE(at(scene, missing, p));
    EXPECT_FALSE(at({}, planar, p));

    ImageTexels& image = scene.images.front();
    image.texels.pop_back();
    EXPECT_FALSE(at(scene, planar, p)) << "too few texels";
    image.width = image.height = 0xffffffff;
    EXPECT_FALSE(at(scene, planar, p));
    image.width = 0;
    EXPECT_FALSE(at(scene, planar, p));
    image.texels.clear();
    EXPECT_FALSE(at(scene, planar, p)) << "empty";

    ImageLook odd = planar;
    odd.mapping = static_cast<Mapping>(77);
    EXPECT_FALSE(at(numbered(2, 2), odd, p));
    odd = planar;
    odd.interpolation = static_cast<Interpolation>(77);
    EXPECT_FALSE(at(numbered(2, 2), odd, p));
    DrawableScene gammas = numbered(2, 2);
    for (const double gamma : {0., -1., not_a_number, infinite, 1e30}) {
        gammas.working_gamma = static_cast<float>(gamma);
        EXPECT_FALSE(at(gammas, planar, p)) << gamma;
    }
}

TEST(ImageLook, AnyPointGivesAFiniteColourOrNothing) {
    const DrawableScene scene = numbered(3, 2);
    const double hostile[] = {0.,
                              -0.,
                              1.,
                              -1.,
                              .5,
                              5e-324,
                              -5e-324,
                              1e-17,
                              -1e-17,
                              1e17,
                              1e200,
                              -1e308,
                              infinite,
                              -infinite,
                              not_a_number,
                              std::nextafter(1., 0.),
                              std::nextafter(1., 2.)};
    for (const Mapping mapping : mappings)
        for (const Interpolation interpolation : interpolations)
            for (const bool once : {false, true}) {
                const ImageLook look = look_of(mapping, interpolation, once);
                for (const double x : hostile)
                    for (const double y : hostile)
                        for (const double z : hostile) {
                            const auto found = image_albedo(scene, look, {x, y, z}, {x, y});
                            if (!found) continue;
                            // Within the image's range and what bicubic weights add to it.
                            for (int i = 0; i < 3; ++i) {
                                ASSERT_GE((*found)[i], -1) << x << " " << y << " " << z;
                                ASSERT_LE((*found)[i], 12) << x << " " << y << " " << z;
                            }
                            ASSERT_TRUE(std::isfinite(x) && std::isfinite(y));
                        }
            }
    ImageLook broken = look_of(Mapping::spherical);
    broken.to_map[3].x = not_a_number;
    EXPECT_FALSE(at(scene, broken, {1, 2, 3}));
}

}  // namespace
}  // namespace povpreview
