// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/item_painter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <functional>
#include <glm/gtc/packing.hpp>
#include <random>

#include "core/error.h"
#include "display/image_file.h"
#include "tests/display/item_scene.h"

namespace povpreview::test {
namespace {

std::vector<Backend> backends() {
#ifdef POVPREVIEW_HAVE_OSMESA
    return {Backend::egl, Backend::osmesa};
#else
    return {Backend::egl};
#endif
}

/// One painter a backend for all tests: it takes its time to be made.
ItemPainter& painter_of(Backend backend) {
    static const std::unique_ptr<GlContext> contexts[] = {
        open_offscreen(Backend::egl),
        backends().size() > 1 ? open_offscreen(Backend::osmesa) : nullptr};
    static std::unique_ptr<ItemPainter> painters[2];
    const std::size_t i = backend == Backend::osmesa;
    if (!painters[i]) painters[i] = std::make_unique<ItemPainter>(*contexts[i]);
    return *painters[i];
}

/// Where POVPREVIEW_ITEM_PICTURES names a folder, buffers are written there, in false colour.
void write_picture(const ItemBuffer& buffer, const std::string& name) {
    const char* folder = std::getenv("POVPREVIEW_ITEM_PICTURES");
    if (!folder) return;
    Image image(buffer.width, buffer.height), albedo(buffer.width, buffer.height);
    for (std::size_t i = 0; i < buffer.surfaces.size(); ++i) {
        const std::uint32_t surface = buffer.surfaces[i];
        std::mt19937 noise(surface);
        for (int c = 0; c < 3; ++c) image.pixels[i][c] = static_cast<float>(noise() % 256) / 255.f;
        if (surface == ItemBuffer::background) image.pixels[i] = glm::vec3(0);
        if (surface == ItemBuffer::unknown) image.pixels[i] = glm::vec3(1, 1, 1);
        if (!buffer.albedos.empty()) albedo.pixels[i] = buffer.albedos[i];
    }
    write_image(image, std::string(folder) + "/" + name + ".png");
    if (!buffer.albedos.empty())
        write_image(albedo, std::string(folder) + "/" + name + "_albedo.png");
}

/// How a painted buffer compares with one by rays.
struct Agreement {
    std::size_t inner = 0;        ///< pixels whose eight neighbours show the same surface
    std::size_t inner_wrong = 0;  ///< of those
    std::size_t beyond_edge = 0;  ///< other pixels: those that show none of the surfaces around
    std::size_t unknown = 0;      ///< that need not be, anywhere
    std::size_t kinds_wrong = 0, albedos_wrong = 0;  ///< where the surface is right and inner
    std::size_t seen = 0;                            ///< pixels that show a surface
    std::string first_wrong;
};

Agreement compare(const ItemBuffer& painted, const ItemBuffer& expected, float albedo_slack) {
    Agreement result;
    EXPECT_EQ(painted.surfaces.size(), expected.surfaces.size());
    for (int y = 0; y < expected.height; ++y) {
        for (int x = 0; x < expected.width; ++x) {
            const auto at = static_cast<std::size_t>(y * expected.width + x);
            const std::uint32_t surface = expected.surfaces[at];
            bool inner = true, near = false;
            for (int j = std::max(y - 1, 0); j <= std::min(y + 1, expected.height - 1); ++j)
                for (int i = std::max(x - 1, 0); i <= std::min(x + 1, expected.width - 1); ++i) {
                    const std::uint32_t other =
                        expected.surfaces[static_cast<std::size_t>(j * expected.width + i)];
                    inner = inner && other == surface;
                    near = near || other == painted.surfaces[at];
                }
            const bool right = painted.surfaces[at] == surface;
            result.seen += surface != ItemBuffer::background && surface != ItemBuffer::unknown;
            result.unknown += !right && painted.surfaces[at] == ItemBuffer::unknown;
            result.inner += inner;
            const auto note = [&](const std::string& what) {
                if (result.first_wrong.empty())
                    result.first_wrong =
                        what + " at " + std::to_string(x) + ", " + std::to_string(y) + ": " +
                        std::to_string(painted.surfaces[at]) + " for " + std::to_string(surface);
            };
            if (inner && !right) ++result.inner_wrong, note("inner");
            if (!inner && !near && painted.surfaces[at] != ItemBuffer::unknown)
                ++result.beyond_edge, note("beyond");
            if (!inner || !right) continue;
            if (painted.kinds[at] != expected.kinds[at]) ++result.kinds_wrong, note("kind");
            if (expected.kinds[at] != Look::Kind::image) continue;
            if (painted.albedos.empty() ||
                !(glm::length(glm::vec3(painted.albedos[at] - expected.albedos[at])) <=
                  albedo_slack))
                ++result.albedos_wrong, note("albedo");
        }
    }
    return result;
}

class ItemPainterTest : public testing::TestWithParam<Backend> {
   protected:
    /// Paints the scene and holds it against rays. `shown`: pixels that must show something.
    Agreement expect_right(const ItemScene& made, const std::string& name,
                           std::size_t shown = 100) {
        const ItemBuffer painted = painter_of(GetParam()).paint(made.scene);
        if (GetParam() == Backend::egl) write_picture(painted, name);
        const Agreement agreement = compare(painted, made.expected(), .02f);
        EXPECT_GE(agreement.seen, shown) << name << ": the test shows nothing";
        EXPECT_LE(agreement.inner_wrong * 1000, agreement.inner) << name << agreement.first_wrong;
        EXPECT_LE(agreement.beyond_edge * 2000, painted.surfaces.size())
            << name << agreement.first_wrong;
        EXPECT_LE(agreement.unknown * 1000, painted.surfaces.size()) << name;
        EXPECT_LE(agreement.kinds_wrong * 1000, agreement.inner) << name << agreement.first_wrong;
        EXPECT_LE(agreement.albedos_wrong * 500, agreement.inner) << name << agreement.first_wrong;
        return agreement;
    }
};

INSTANTIATE_TEST_SUITE_P(Backends, ItemPainterTest, testing::ValuesIn(backends()),
                         [](const testing::TestParamInfo<Backend>& backend) {
                             return backend.param == Backend::egl ? "egl" : "osmesa";
                         });

constexpr int width = 160, height = 120;

TEST_P(ItemPainterTest, PolygonsHideEachOther) {
    ItemScene made(look_at({3, 2, -5}, {0, 0, 0}), width, height);
    made.box({-1, -1, -1}, {1, 1, 1});
    made.box({-.5, -.5, -3}, {.2, .3, 3});
    made.face({{-9, -1.2, -9}, {9, -1.2, -9}, {9, -1.2, 9}, {-9, -1.2, 9}});
    expect_right(made, "polygons", 9000);
}

TEST_P(ItemPainterTest, SpheresOfAllSizes) {
    ItemScene made(look_at({3, 2, -5}, {0, 0, 0}), width, height);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> place(-2, 2), radius(.02, .5);
    for (int i = 0; i < 60; ++i)
        made.sphere({place(random), place(random), place(random)}, radius(random));
    made.ellipsoid({{.3, .9, 0}, {-.9, .3, .1}, {0, 0, .2}, {.5, 0, -2}});
    expect_right(made, "spheres", 5000);
}

/// One of every solid, standing around.
void add_solids(ItemScene& made, const glm::dvec3& at, double size) {
    const auto place = [&](double x, double y, double z) {
        return at + size * glm::dvec3(x, y, z);
    };
    made.cylinder(place(-2, -1, 0), place(-1.4, .9, .4), .35 * size);
    made.cone(place(-.7, -1, 0), .5 * size, place(-.6, .8, -.2), .1 * size);
    made.cone(place(.4, -1, .2), .3 * size, place(.4, .9, .2), .31 * size);
    made.torus(place(1.5, .3, 0), {.3, 1, -.8}, .6 * size, .22 * size);
    made.torus(place(1.4, -.9, -.4), {.2, 1, -.3}, .7 * size, .02 * size);
    // A paraboloid and a saddle, cut off by spheres.
    const auto cut_quadric = [&](const glm::dvec3& centre, std::array<double, 10> coefficients) {
        const auto quadric = static_cast<int>(
            made.solid(Solid::Kind::quadric, frame_along({.2, 1, .4}, centre, .5 * size, .5 * size),
                       coefficients));
        const auto cutter = static_cast<int>(made.sphere_solid(centre, .6 * size));
        made.piece(static_cast<std::uint32_t>(quadric), {cutter});
        made.piece(static_cast<std::uint32_t>(cutter), {quadric});
        made.object({centre - .6 * size, centre + .6 * size});
    };
    cut_quadric(place(-1.5, 1.6, 0), {1, 1, 0, 0, 0, 0, 0, 0, -1, -.5});
    cut_quadric(place(0, 1.6, 0), {1, -1, 0, .3, 0, 0, 0, 0, -1, 0});
    cut_quadric(place(1.5, 1.6, 0), {1, 2, -1.5, .4, -.3, .2, .1, .2, -.1, -.2});
    cut_quadric(place(3, 1.6, 0), {1, 0, 0, 0, 0, 0, .2, 0, 0, -.3});
    cut_quadric(place(3, 0, 0), {0, 0, 0, 1, 0, 0, 0, 0, .5, -.1});
}

TEST_P(ItemPainterTest, EverySolid) {
    ItemScene made(look_at({1, 2, -6}, {.4, .4, 0}), width, height);
    add_solids(made, {0, 0, 0}, 1);
    expect_right(made, "solids", 3500);
}

TEST_P(ItemPainterTest, EverySolidAtEveryScale) {
    for (const double size : {1e-6, 1e6}) {
        for (const double away : {0., 50.}) {
            const glm::dvec3 at = away * size * glm::dvec3(30, 5, -20);
            ItemScene made(
                look_at(at + size * glm::dvec3(1, 2, -6), at + size * glm::dvec3(.4, .4, 0)), width,
                height);
            add_solids(made, at, size);
            made.sphere(at + size * glm::dvec3(-.7, 1.2, -1), .2 * size);
            made.box(at - .3 * size, at + .2 * size);
            SCOPED_TRACE(std::to_string(size) + " times, " + std::to_string(away) + " away");
            expect_right(made, "scale", 3500);
        }
    }
}

TEST_P(ItemPainterTest, TelephotoViewsFromFarAway) {
    const glm::dvec3 from(2e4, 1e4, -3e4);
    ItemScene made(look_at(from, {.4, .4, 0}, 8 / glm::length(from)), width, height);
    add_solids(made, {0, 0, 0}, 1);
    for (int i = 0; i < 5; ++i) made.sphere({i - 2., 2.3, .2 * i}, .3);
    made.box({-.2, -2, -.2}, {.2, -1.2, .2});
    expect_right(made, "telephoto", 3500);
}

TEST_P(ItemPainterTest, OrthographicViews) {
    ItemScene made(look_at({1, 2, -3}, {.4, .4, 0}, 8), width, height);
    made.pose.orthographic = true;
    made.scene.polygons.camera = made.pose.straight(width, height);
    add_solids(made, {0, 0, 0}, 1);
    made.sphere({-.7, 1.2, -1}, .3);
    made.sphere({0, 1.5, -3}, .9);  // half of it behind the plane of the eye
    made.sphere({2, 2, -9}, .9);    // all of it
    made.box({-2.5, -1, 1}, {2, 1, 2});
    made.box({-3, -1.5, -9}, {-2, -1, 1});
    made.face({{-90, -1.2, -90}, {90, -1.2, -90}, {90, -1.2, 90}, {-90, -1.2, 90}});
    made.plane({0, 1, 0}, {0, -1.5, 0});
    made.scene.unknown.push_back({{2.5, -.5, -1}, {3, .5, 1}});
    expect_right(made, "orthographic", 3500);
}

TEST_P(ItemPainterTest, TheEyeInTheMidstOfThings) {
    // Inside of a box, a sphere, a cylinder along the view, a cone and a torus, one after the
    // other.
    const CameraPose pose = look_at({.1, .2, -.3}, {1, .1, .6});
    for (int kind = 0; kind < 6; ++kind) {
        ItemScene made(pose, width, height);
        made.box({1, -1, 0}, {2, .1, 2});
        if (kind == 0) made.box({-3, -2, -3}, {3, 2, 3});
        if (kind == 1) made.sphere({.5, 0, 0}, 3);
        if (kind == 2) made.cylinder({-2, -.5, -2}, {5, 1, 4}, 1.7);
        if (kind == 3) made.cone({-3, 0, -2}, 3, {6, 1, 4}, .5);
        if (kind == 4) made.torus({.1, .2, .5}, {0, 1, 0}, 1, .9);
        if (kind == 5) made.ellipsoid({{40, 0, 0}, {0, .6, .1}, {0, 0, 40}, {0, 0, 0}});
        // and things that go past it on both sides
        made.cylinder({-50, -.9, -50}, {50, -.9, 50}, .05);
        made.box({-50, -.8, -40}, {-49.8, -.75, 1e6});
        made.face({{-1e5, -.97, -1e5}, {1e5, -.97, -1e5}, {1e5, -.97, 1e5}, {-1e5, -.97, 1e5}});
        SCOPED_TRACE(kind);
        expect_right(made, "inside" + std::to_string(kind), 15000);
    }
}

TEST_P(ItemPainterTest, WhatIsBehindTheEyeIsNotSeen) {
    ItemScene made(look_at({0, 0, 0}, {0, 0, 1}), width, height);
    add_solids(made, {0, 0, -8}, 1);
    for (int i = 0; i < 9; ++i) made.sphere({i - 4., 0, -3}, .5);
    made.box({-1, -1, -4}, {1, 1, -2});
    made.plane({0, 0, -1}, {0, 0, -1});
    made.scene.unknown.push_back({{-1, -1, -4}, {1, 1, -2}});
    made.sphere({0, 0, 5}, 1);
    expect_right(made, "behind", 900);
}

TEST_P(ItemPainterTest, EndlessPlanesReachTheHorizon) {
    ItemScene made(look_at({1, 1.5, -4}, {0, 1.2, 4}), width, height);
    const double far = 1e7;  // a floor, as a polygon, under it one, as a half space
    made.face({{-far, 0, -far}, {far, 0, -far}, {far, 0, far}, {-far, 0, far}});
    made.plane({0, 1, 0}, {0, -.5, 0});
    made.plane({.1, -1, 0}, {0, 400, 0});
    made.box({-1, -.1, 0}, {1, 1, 1});
    made.box({-4e5, -1e4, 1e6}, {4e5, 9e4, 2e6});
    made.sphere({2, .3, 1}, .5);
    made.cylinder({-2, .4, 0}, {-2, .4, 2000}, .4);
    const auto quadric =
        made.solid(Solid::Kind::quadric, frame_along({0, 1, 0}, {-2, .5, 60}, 1, 1),
                   {1, 1, 0, 0, 0, 0, 0, 0, 5, 0});
    made.piece(quadric);
    made.object(everywhere);
    expect_right(made, "horizon", 15000);
}

TEST_P(ItemPainterTest, ThinThingsFarAway) {
    ItemScene made(look_at({0, 3, -1000}, {0, 0, 0}, .5), width, height);
    std::mt19937 random(8);
    std::uniform_real_distribution<double> place(-200, 200);
    for (int i = 0; i < 25; ++i) {
        const auto point = [&] { return glm::dvec3(place(random), place(random), place(random)); };
        made.cylinder(point(), point(), 3.5);
        made.cone(point(), 5, point(), 1);
    }
    made.torus({0, 0, 0}, {.1, .2, 1}, 150, 4);
    expect_right(made, "thin", 3000);
}

TEST_P(ItemPainterTest, SolidGeometryOfRandomKind) {
    for (unsigned seed = 1; seed <= 8; ++seed) {
        ItemScene made(look_at({1, 2, -5}, {0, 0, 0}), width, height);
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> place(-1, 1), radius(.4, 1.2);
        const auto point = [&] { return glm::dvec3(place(random), place(random), place(random)); };
        std::vector<std::uint32_t> solids;
        for (int i = 0; i < 7; ++i) {
            switch (random() % 5) {
                case 0:
                    solids.push_back(made.sphere_solid(point(), radius(random)));
                    break;
                case 1:
                    solids.push_back(made.cylinder_solid(point(), point(), radius(random)));
                    break;
                case 2:
                    solids.push_back(made.half_space(point(), .3 * point()));
                    break;
                case 3:
                    solids.push_back(made.solid(Solid::Kind::cone,
                                                frame_along(point(), point(), radius(random), 1)));
                    break;
                case 4:
                    solids.push_back(made.solid(Solid::Kind::torus,
                                                frame_along(point(), point(), radius(random), .7),
                                                {.4}));
                    break;
            }
        }
        // A random tree over the other solids, cut off by a sphere so that all has an end.
        const auto hull = static_cast<int>(made.sphere_solid({0, 0, 0}, 1.6));
        for (const std::uint32_t solid : solids) {
            std::vector<ConditionStep> steps;
            int depth = 0;
            for (const std::uint32_t other : solids) {
                if (other == solid) continue;
                steps.push_back(static_cast<int>(other));
                ++depth;
                if (random() % 2) steps.push_back(condition_not);
                while (depth > 1 && random() % 2) {
                    steps.push_back(random() % 2 ? condition_and : condition_or);
                    if (random() % 4 == 0) steps.push_back(condition_not);
                    --depth;
                }
            }
            for (; depth > 1; --depth) steps.push_back(condition_or);
            steps.push_back(hull);
            steps.push_back(condition_and);
            made.piece(solid, steps);
        }
        made.piece(static_cast<std::uint32_t>(hull),
                   {static_cast<int>(solids[0]), static_cast<int>(solids[1]), condition_not,
                    condition_or, condition_not});
        made.object({glm::dvec3(-1.6), glm::dvec3(1.6)});
        SCOPED_TRACE("seed " + std::to_string(seed));
        expect_right(made, "csg" + std::to_string(seed), 500);
    }
}

TEST_P(ItemPainterTest, WhatIsBehindAnUnknownBoxIsUnknown) {
    ItemScene made(look_at({3, 2, -5}, {0, 0, 0}), width, height);
    made.box({-1, -1, -1}, {1, 1, 1});
    made.sphere({1.5, .5, -2}, .4);
    made.scene.unknown.push_back({{-.5, -.7, -2}, {1.5, .4, -1.2}});
    made.scene.unknown.push_back({{-unbounded, -unbounded, 3}, {unbounded, -1, unbounded}});
    expect_right(made, "unknown", 1500);
}

TEST_P(ItemPainterTest, InsideOfAnUnknownBoxNothingIsKnown) {
    ItemScene made(look_at({3, 2, -5}, {0, 0, 0}), width, height);
    made.box({-1, -1, -1}, {1, 1, 1});
    for (const Bounds& bounds : {everywhere, Bounds{{-9, -9, -9}, {9, 9, 9}}}) {
        made.scene.unknown = {bounds};
        const ItemBuffer painted = painter_of(GetParam()).paint(made.scene);
        for (std::size_t i = 0; i < painted.surfaces.size(); ++i) {
            ASSERT_EQ(painted.surfaces[i], ItemBuffer::unknown);
            ASSERT_EQ(painted.kinds[i], Look::Kind::mixed);
        }
    }
}

TEST_P(ItemPainterTest, CoincidentBoundariesInAnObjectAreUnknown) {
    // A cube-like slab less a cylinder whose end lies in the slab's front.
    ItemScene made(look_at({.5, .7, -4}, {0, 0, 0}), width, height);
    const auto front = static_cast<int>(made.half_space({0, 0, -1}, {0, 0, 0}));
    const auto hole = static_cast<int>(made.cylinder_solid({0, 0, 0}, {0, 0, 1}, .8));
    const auto hole_end = static_cast<int>(made.half_space({0, 0, -1}, {0, 0, 0}));
    const auto ball = static_cast<int>(made.sphere_solid({0, 0, 0}, 1.5));
    made.piece(static_cast<std::uint32_t>(front),
               {ball, hole, hole_end, condition_and, condition_not, condition_and});
    made.object({glm::dvec3(-1.5), glm::dvec3(1.5)});
    const ItemBuffer painted = painter_of(GetParam()).paint(made.scene);
    const auto at = [&](double x, double y) {
        const glm::dvec3 p = made.scene.polygons.camera.to_pixels * glm::dvec4(x, y, 0, 1);
        return painted.surfaces[static_cast<std::size_t>(int(p.y / p.z) * width + int(p.x / p.z))];
    };
    EXPECT_EQ(at(0, 0), ItemBuffer::unknown);
    EXPECT_EQ(at(.5, .5), ItemBuffer::unknown);
    EXPECT_EQ(at(1.1, 0), 1u);
    EXPECT_EQ(at(0, -1.2), 1u);
}

TEST_P(ItemPainterTest, SenselessDataIsUnknownOrLeftOut) {
    const double nan = std::nan("");
    ItemScene made(look_at({3, 2, -5}, {0, 0, 0}), width, height);
    made.box({-1, -1, -1}, {1, 1, 1});
    made.face({{nan, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    made.face({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}});
    made.face({{1, 1, -2}, {2, 2, -2}});
    made.sphere({nan, nan, nan}, 1);
    ItemBuffer painted = painter_of(GetParam()).paint(made.scene);
    EXPECT_EQ(painted.surfaces[0], ItemBuffer::unknown) << "it may be anywhere";

    const auto unknown_with = [&](const std::function<void(ItemScene&)>& damage) {
        ItemScene damaged(look_at({3, 2, -5}, {0, 0, 0}), width, height);
        damaged.cylinder({0, -1, 0}, {0, 1, 0}, 1);
        damage(damaged);
        painted = painter_of(GetParam()).paint(damaged.scene);
        EXPECT_EQ(painted.surfaces[width * height / 2 + width / 2], ItemBuffer::unknown);
        EXPECT_EQ(painted.surfaces[0], ItemBuffer::background);
    };
    unknown_with([](ItemScene& damaged) { damaged.scene.pieces[1].solid = 99; });
    unknown_with([](ItemScene& damaged) { damaged.scene.conditions[0] = 99; });
    unknown_with([](ItemScene& damaged) { damaged.scene.conditions[0] = -9; });
    unknown_with([](ItemScene& damaged) { damaged.scene.conditions[1] = condition_or; });
    unknown_with([](ItemScene& damaged) { damaged.scene.pieces[0].conditions = 1000; });
    unknown_with([](ItemScene& damaged) { damaged.scene.objects[0].pieces = 1000; });
    unknown_with([&](ItemScene& damaged) { damaged.scene.solids[0].to_frame[1][1] = nan; });

    ItemScene without_camera(look_at({3, 2, -5}, {0, 0, 0}), width, height);
    without_camera.scene.polygons.camera.to_pixels = glm::dmat4x3(0);
    EXPECT_EQ(painter_of(GetParam()).paint(without_camera.scene).surfaces[7], ItemBuffer::unknown);
}

TEST_P(ItemPainterTest, SurfacesKeepAllTheirBits) {
    ItemScene made(look_at({0, 0, -5}, {0, 0, 0}), 30, 10);
    // Bits of denormal numbers, of none, and of infinity, were they floats.
    const std::uint32_t surfaces[] = {1,          0x7fc00001, 0xff800001,
                                      0x80000000, 0x7f800000, 0xfffffffe};
    for (int i = 0; i < 6; ++i) {
        const double x = i - 2.5;
        if (i % 2)
            made.sphere({x, 0, 0}, .4);
        else
            made.box({x - .4, -.4, -.4}, {x + .4, .4, .4});
        if (i % 2) made.scene.pieces.back().surface = surfaces[i];
    }
    for (Face& face : made.scene.polygons.faces)
        face.surface = surfaces[(&face - made.scene.polygons.faces.data()) / 6 * 2];
    const ItemBuffer painted = painter_of(GetParam()).paint(made.scene);
    for (int i = 0; i < 6; ++i) {
        const glm::dvec3 p = made.scene.polygons.camera.to_pixels * glm::dvec4(i - 2.5, 0, 0, 1);
        EXPECT_EQ(painted.surfaces[static_cast<std::size_t>(5 * 30 + int(p.x / p.z))], surfaces[i]);
    }
}

/// Waves, each colour in its own; no edge is so sharp that a texel's width matters much.
ImageTexels waves(std::uint32_t columns, std::uint32_t rows) {
    ImageTexels image{columns, rows, {}};
    for (std::uint32_t j = 0; j < rows; ++j)
        for (std::uint32_t i = 0; i < columns; ++i) {
            const double u = (i + .5) / columns, v = (j + .5) / rows, turn = 6.283185307;
            image.texels.push_back(
                {glm::packHalf1x16(static_cast<float>(.5 + .4 * std::sin(turn * u * 3))),
                 glm::packHalf1x16(static_cast<float>(.5 + .4 * std::sin(turn * v * 2))),
                 glm::packHalf1x16(static_cast<float>(.5 + .4 * std::sin(turn * (u + 2 * v)))),
                 glm::packHalf1x16(1.f)});
        }
    return image;
}

constexpr const char* mapping_names[] = {"planar", "spherical", "cylindrical", "toroidal", "uv"};

/// Things of all shapes around the origin, with the scene's image laid on them by `mapping`.
ItemScene textured(const CameraPose& pose, ImageLook::Mapping mapping) {
    ItemScene made(pose, width, height);
    made.scene.images = {waves(200, 101), waves(16, 16)};
    Look look{Look::Kind::image, {}};
    look.image.mapping = mapping;
    look.image.to_map = {{.8, .1, 0}, {-.1, .7, .2}, {0, -.2, .9}, {.3, .2, .1}};
    look.image.interpolation = ImageLook::Interpolation::bilinear;
    made.scene.looks.push_back(look);
    made.material = 1;
    if (mapping == ImageLook::Mapping::uv) {
        made.face({{-2, -1, 0}, {2, -1, 0}, {2, 1.5, 1}, {-2, 1.5, 1}},
                  {{-.2f, 0.f}, {1.f, .1f}, {1.3f, 1.f}, {.1f, .9f}});
        made.face({{-90, -1.2, -90}, {90, -1.2, -90}, {0, -1.2, 90}}, {{0, 0}, {30, 0}, {0, 30}});
        return made;
    }
    made.sphere({0, 0, 0}, 1);
    made.cylinder({-2, -1, 0}, {-1.5, 1.2, .3}, .5);
    made.torus({1.7, .3, 0}, {.2, 1, -.6}, .7, .25);
    made.face({{-9, -1.2, -9}, {9, -1.2, -9}, {9, -1.2, 9}, {-9, -1.2, 9}});
    made.material = 0;
    made.box({-.3, -.3, -2}, {.3, .3, -1.8});
    return made;
}

TEST_P(ItemPainterTest, ImagesOfEveryMapping) {
    for (int mapping = 0; mapping < 5; ++mapping) {
        for (const bool orthographic : {false, true}) {
            CameraPose pose = look_at({1, 2, -5}, {0, 0, 0}, orthographic ? 6 : 4. / 3);
            pose.orthographic = orthographic;
            const ItemScene made = textured(pose, static_cast<ImageLook::Mapping>(mapping));
            const std::string name = std::string("image_") + mapping_names[mapping];
            SCOPED_TRACE(orthographic);
            expect_right(made, orthographic ? name + "_orthographic" : name, 9000);
        }
    }
}

TEST_P(ItemPainterTest, ImagesOfEveryInterpolation) {
    for (int kind = 0; kind < 4; ++kind) {
        for (const bool once : {false, true}) {
            ItemScene made = textured(look_at({1, 2, -5}, {0, 0, 0}), ImageLook::Mapping::planar);
            ImageLook& look = made.scene.looks[1].image;
            look.image = 1;
            look.interpolation = static_cast<ImageLook::Interpolation>(kind);
            look.once = once;
            made.scene.working_gamma = once ? 2.2f : 1.f;
            SCOPED_TRACE(kind);
            expect_right(made, "interpolation_" + std::to_string(kind) + (once ? "_once" : ""),
                         9000);
        }
    }
}

TEST_P(ItemPainterTest, OnceLeavesTheRestToTracing) {
    for (int mapping = 0; mapping < 5; ++mapping) {
        ItemScene made =
            textured(look_at({1, 2, -5}, {0, 0, 0}), static_cast<ImageLook::Mapping>(mapping));
        made.scene.looks[1].image.once = true;
        SCOPED_TRACE(mapping_names[mapping]);
        expect_right(made, std::string("once_") + mapping_names[mapping], 9000);
    }
}

TEST_P(ItemPainterTest, SeveralImagesAndMaterials) {
    ItemScene made = textured(look_at({1, 2, -5}, {0, 0, 0}), ImageLook::Mapping::planar);
    Look other = made.scene.looks[1];
    other.image.image = 1;
    other.image.mapping = ImageLook::Mapping::spherical;
    made.scene.looks.push_back(other);
    other.image.image = 0;
    made.scene.looks.push_back(other);
    made.scene.looks.push_back({Look::Kind::traced, {}});
    std::mt19937 random(3);
    std::uniform_real_distribution<double> place(-2, 2);
    for (int i = 0; i < 30; ++i) {
        made.material = random() % 7;  // some beyond the last look
        made.sphere({place(random), place(random), place(random)}, .3);
    }
    expect_right(made, "materials", 9000);
}

TEST_P(ItemPainterTest, ImagesThatCannotBeDrawnAreTraced) {
    const auto kind_with = [&](const std::function<void(DrawableScene&)>& damage) {
        ItemScene made = textured(look_at({0, 0, -5}, {0, 0, 0}), ImageLook::Mapping::planar);
        made.scene.polygons.faces.clear();
        damage(made.scene);
        const ItemBuffer painted = painter_of(GetParam()).paint(made.scene);
        EXPECT_EQ(painted.surfaces[width * height / 2 + width / 2], 1u);
        return painted.kinds[width * height / 2 + width / 2];
    };
    using Kind = Look::Kind;
    EXPECT_EQ(kind_with([](DrawableScene&) {}), Kind::image);
    EXPECT_EQ(kind_with([](DrawableScene& scene) { scene.looks[1].image.image = 2; }),
              Kind::traced);
    EXPECT_EQ(kind_with([](DrawableScene& scene) { scene.images[0].texels.pop_back(); }),
              Kind::traced);
    EXPECT_EQ(kind_with([](DrawableScene& scene) { scene.images[0] = {}; }), Kind::traced);
    EXPECT_EQ(kind_with([](DrawableScene& scene) {
                  scene.images[0] = {1u << 13, (1u << 12) + 1, {}};
                  scene.images[0].texels.resize((std::size_t{1} << 25) + (1u << 13));
              }),
              Kind::traced);
    EXPECT_EQ(kind_with([](DrawableScene& scene) {
                  scene.looks[1].image.mapping = ImageLook::Mapping::uv;
              }),
              Kind::traced)
        << "no texture coordinates";
    EXPECT_EQ(kind_with([](DrawableScene& scene) {
                  for (auto& texel : scene.images[0].texels) texel[3] = glm::packHalf1x16(.5f);
              }),
              Kind::mixed);
    EXPECT_EQ(kind_with([](DrawableScene& scene) { scene.looks.clear(); }), Kind::mixed);
}

TEST_P(ItemPainterTest, NothingOfAnEarlierSceneIsLeft) {
    ItemPainter& painter = painter_of(GetParam());
    const ItemScene made = textured(look_at({1, 2, -5}, {0, 0, 0}), ImageLook::Mapping::planar);
    const ItemBuffer first = painter.paint(made.scene);
    ItemScene other(look_at({0, 0, -5}, {0, 0, 0}), 77, 31);
    other.sphere({0, 0, 0}, 1);
    const ItemBuffer between = painter.paint(other.scene);
    EXPECT_TRUE(between.albedos.empty());
    EXPECT_EQ(between.surfaces.size(), 77u * 31u);
    const ItemBuffer again = painter.paint(made.scene);
    EXPECT_EQ(first.surfaces, again.surfaces);
    EXPECT_EQ(first.kinds, again.kinds);
    EXPECT_EQ(first.albedos, again.albedos);
    ItemScene empty(look_at({0, 0, -5}, {0, 0, 0}), 5, 3);
    EXPECT_EQ(painter.paint(empty.scene).surfaces,
              std::vector<std::uint32_t>(15, ItemBuffer::background));
}

}  // namespace
}  // namespace povpreview::test
