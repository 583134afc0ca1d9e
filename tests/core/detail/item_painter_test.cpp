// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/detail/item_painter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "core/detail/pixel_rays.h"
#include "tests/core/detail/item_agreement.h"

namespace povpreview::test {
namespace {

constexpr int width = 160, height = 120;

TEST(ItemPainter, PolygonsHideEachOther) {
    ItemScene made(look_at({3, 2, -5}, {0, 0, 0}), width, height);
    made.box({-1, -1, -1}, {1, 1, 1});
    made.box({-.5, -.5, -3}, {.2, .3, 3});
    made.face({{-9, -1.2, -9}, {9, -1.2, -9}, {9, -1.2, 9}, {-9, -1.2, 9}});
    expect_right(made, 9000);
}

TEST(ItemPainter, SpheresOfAllSizes) {
    ItemScene made(look_at({3, 2, -5}, {0, 0, 0}), width, height);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> place(-2, 2), radius(.02, .5);
    for (int i = 0; i < 60; ++i)
        made.sphere({place(random), place(random), place(random)}, radius(random));
    made.ellipsoid({{.3, .9, 0}, {-.9, .3, .1}, {0, 0, .2}, {.5, 0, -2}});
    expect_right(made, 5000);
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

TEST(ItemPainter, EverySolid) {
    ItemScene made(look_at({1, 2, -6}, {.4, .4, 0}), width, height);
    add_solids(made, {0, 0, 0}, 1);
    expect_right(made, 3500);
}

TEST(ItemPainter, EverySolidAtEveryScale) {
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
            expect_right(made, 3500);
        }
    }
}

TEST(ItemPainter, TelephotoViewsFromFarAway) {
    const glm::dvec3 from(2e4, 1e4, -3e4);
    ItemScene made(look_at(from, {.4, .4, 0}, 8 / glm::length(from)), width, height);
    add_solids(made, {0, 0, 0}, 1);
    for (int i = 0; i < 5; ++i) made.sphere({i - 2., 2.3, .2 * i}, .3);
    made.box({-.2, -2, -.2}, {.2, -1.2, .2});
    expect_right(made, 3500, 1e-3);  // what is in doubt grows with the distance
}

TEST(ItemPainter, OrthographicViews) {
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
    expect_right(made, 3500);
}

TEST(ItemPainter, TheEyeInTheMidstOfThings) {
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
        expect_right(made, 15000);
    }
}

TEST(ItemPainter, WhatIsBehindTheEyeIsNotSeen) {
    ItemScene made(look_at({0, 0, 0}, {0, 0, 1}), width, height);
    add_solids(made, {0, 0, -8}, 1);
    for (int i = 0; i < 9; ++i) made.sphere({i - 4., 0, -3}, .5);
    made.box({-1, -1, -4}, {1, 1, -2});
    made.plane({0, 0, -1}, {0, 0, -1});
    made.scene.unknown.push_back({{-1, -1, -4}, {1, 1, -2}});
    made.sphere({0, 0, 5}, 1);
    expect_right(made, 900);
}

TEST(ItemPainter, EndlessPlanesReachTheHorizon) {
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
    expect_right(made, 15000);
}

TEST(ItemPainter, ThinThingsFarAway) {
    ItemScene made(look_at({0, 3, -1000}, {0, 0, 0}, .5), width, height);
    std::mt19937 random(8);
    std::uniform_real_distribution<double> place(-200, 200);
    for (int i = 0; i < 25; ++i) {
        const auto point = [&] { return glm::dvec3(place(random), place(random), place(random)); };
        made.cylinder(point(), point(), 3.5);
        made.cone(point(), 5, point(), 1);
    }
    made.torus({0, 0, 0}, {.1, .2, 1}, 150, 4);
    expect_right(made, 3000);
}

TEST(ItemPainter, SolidGeometryOfRandomKind) {
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
        expect_right(made, 500);
    }
}

// The nearest are drawn first, and what is wholly behind them is not tried: neither may tell.
TEST(ItemPainter, TheOrderOfObjectsChangesNothing) {
    for (const bool orthographic : {false, true}) {
        CameraPose pose = look_at({1, 2, -5}, {0, 0, 0});
        if (orthographic) {
            pose.orthographic = true;
            pose.right *= 5.;
            pose.up *= 5.;
        }
        ItemScene made(pose, width, height);
        std::mt19937 random(11);
        std::uniform_real_distribution<double> place(-2, 2), radius(.02, .6);
        const auto point = [&] { return glm::dvec3(place(random), place(random), place(random)); };
        for (int i = 0; i < 60; ++i) {
            made.sphere(point(), radius(random));
            made.cylinder(point(), point(), .3 * radius(random));
            made.torus(point(), point(), radius(random), .1);
        }
        made.plane({0, 1, 0}, {0, -2, 0});
        expect_right(made, 15000);
        const ItemBuffer once = paint_items(made.scene);
        for (int turn = 0; turn < 3; ++turn) {
            std::shuffle(made.scene.objects.begin(), made.scene.objects.end(), random);
            EXPECT_EQ(paint_items(made.scene).surfaces, once.surfaces);
        }
    }
}

TEST(PixelRays, NothingWithinBoundsIsNearer) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> place(-3, 3), part(0, 1);
    const auto point = [&] { return glm::dvec3(place(random), place(random), place(random)); };
    int known = 0;
    for (int i = 0; i < 2000; ++i) {
        CameraPose pose = look_at(point(), point());
        pose.orthographic = i % 2 == 0;
        const PixelRays rays(pose.straight(width, height));
        const glm::dvec3 a = point(), b = a + .3 * point();
        const Bounds box{glm::min(a, b), glm::max(a, b)};
        const double greatest = greatest_nearness(rays, box);
        known += std::isfinite(greatest);
        for (int j = 0; j < 20; ++j) {
            const glm::dvec3 inside =
                glm::mix(box.low, box.high, glm::dvec3(part(random), part(random), part(random)));
            const double depth = rays.project(inside).depth;
            if (depth > 0) {
                ASSERT_LE(rays.nearness(depth), greatest);
            }
        }
    }
    EXPECT_GT(known, 1000);
    const PixelRays rays(look_at({0, 0, -5}, {0, 0, 0}).straight(width, height));
    EXPECT_EQ(greatest_nearness(rays, everywhere), unbounded);
}

TEST(ItemPainter, WhatIsBehindAnUnknownBoxIsUnknown) {
    ItemScene made(look_at({3, 2, -5}, {0, 0, 0}), width, height);
    made.box({-1, -1, -1}, {1, 1, 1});
    made.sphere({1.5, .5, -2}, .4);
    made.scene.unknown.push_back({{-.5, -.7, -2}, {1.5, .4, -1.2}});
    made.scene.unknown.push_back({{-unbounded, -unbounded, 3}, {unbounded, -1, unbounded}});
    expect_right(made, 1500);
}

// Such rays meet two pairs of its sides nowhere.
TEST(ItemPainter, UnknownBoxesAreMetByRaysAlongTheirSides) {
    CameraPose pose;
    pose.orthographic = true;
    pose.right *= 4.;
    pose.up *= 4.;
    ItemScene made(pose, width, height);
    made.box({-1.9, -1.5, 0}, {1.5, 1.7, 1});
    made.sphere({.3, .2, -2}, .4);
    made.scene.unknown.push_back({{-.5, -.7, -1}, {.9, .4, -.5}});
    made.scene.unknown.push_back({{1, -unbounded, -unbounded}, {1.2, -.6, unbounded}});
    made.scene.unknown.push_back({{-1.5, 1, 2}, {9, 9, 3}});
    made.scene.unknown.push_back({{-2, 1.2, -9}, {2, 1.4, -7}});  // behind the eye
    expect_right(made, 5000);
}

TEST(ItemPainter, InsideOfAnUnknownBoxNothingIsKnown) {
    ItemScene made(look_at({3, 2, -5}, {0, 0, 0}), width, height);
    made.box({-1, -1, -1}, {1, 1, 1});
    for (const Bounds& bounds : {everywhere, Bounds{{-9, -9, -9}, {9, 9, 9}}}) {
        made.scene.unknown = {bounds};
        const ItemBuffer buffer = painted(made.scene);
        for (std::size_t i = 0; i < buffer.surfaces.size(); ++i) {
            ASSERT_EQ(buffer.surfaces[i], ItemBuffer::unknown);
            ASSERT_EQ(buffer.kinds[i], Look::Kind::mixed);
        }
    }
}

TEST(ItemPainter, CoincidentBoundariesInAnObjectAreUnknown) {
    // A cube-like slab less a cylinder whose end lies in the slab's front.
    ItemScene made(look_at({.5, .7, -4}, {0, 0, 0}), width, height);
    const auto front = static_cast<int>(made.half_space({0, 0, -1}, {0, 0, 0}));
    const auto hole = static_cast<int>(made.cylinder_solid({0, 0, 0}, {0, 0, 1}, .8));
    const auto hole_end = static_cast<int>(made.half_space({0, 0, -1}, {0, 0, 0}));
    const auto ball = static_cast<int>(made.sphere_solid({0, 0, 0}, 1.5));
    made.piece(static_cast<std::uint32_t>(front),
               {ball, hole, hole_end, condition_and, condition_not, condition_and});
    made.object({glm::dvec3(-1.5), glm::dvec3(1.5)});
    const ItemBuffer buffer = painted(made.scene);
    const auto at = [&](double x, double y) {
        const glm::dvec3 p = made.scene.polygons.camera.to_pixels * glm::dvec4(x, y, 0, 1);
        return buffer.surfaces[static_cast<std::size_t>(int(p.y / p.z) * width + int(p.x / p.z))];
    };
    EXPECT_EQ(at(0, 0), ItemBuffer::unknown);
    EXPECT_EQ(at(.5, .5), ItemBuffer::unknown);
    EXPECT_EQ(at(1.1, 0), 1u);
    EXPECT_EQ(at(0, -1.2), 1u);
}

TEST(ItemPainter, CoincidentSurfacesAreUnknownInWhateverOrder) {
    // A slanted plane, as a polygon and as a half space; a ball stands before some of it.
    const glm::dvec3 normal = glm::normalize(glm::dvec3(.3, 1, -.7));
    const glm::dvec3 across = glm::normalize(glm::cross(normal, {0, 1, 0})),
                     along = glm::cross(normal, across);
    for (const bool twice_a_polygon : {false, true}) {
        ItemScene made(look_at({.5, 3, -4}, {0, 0, 0}), width, height);
        made.face({3. * across, 3. * along, -3. * across, -3. * along});
        if (twice_a_polygon)
            made.face({3. * along, -3. * across, -2. * along, 2. * across});
        else
            made.plane(normal, .7 * across - .1 * along);
        made.sphere(2.1 * normal, .6);
        const ItemBuffer buffer = painted(made.scene);
        const RayCaster caster(made.scene, made.pose);
        std::size_t tied = 0;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                // What lies on both is what is seen if either is left out.
                std::uint32_t alone[2];
                for (std::uint32_t left_out : {0u, 1u}) {
                    ItemScene one(made.pose, width, height);
                    one.scene = made.scene;
                    if (left_out == 0 || twice_a_polygon)
                        one.scene.polygons.faces[left_out].visible = false;
                    else
                        one.scene.objects[0].pieces = 0;
                    alone[left_out] = RayCaster(one.scene, one.pose).cast(x + .5, y + .5).surface;
                }
                const bool both = alone[0] == 2 && alone[1] == 1;
                tied += both;
                const std::uint32_t expected =
                    both ? ItemBuffer::unknown : caster.cast(x + .5, y + .5).surface;
                ASSERT_EQ(buffer.surfaces[static_cast<std::size_t>(y * width + x)], expected)
                    << x << ", " << y;
            }
        EXPECT_GT(tied, 2000u);
    }
}

TEST(ItemPainter, SenselessDataIsUnknownOrLeftOut) {
    const double nan = std::nan("");
    ItemScene made(look_at({3, 2, -5}, {0, 0, 0}), width, height);
    made.box({-1, -1, -1}, {1, 1, 1});
    made.face({{nan, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    made.face({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}});
    made.face({{1, 1, -2}, {2, 2, -2}});
    made.sphere({nan, nan, nan}, 1);
    ItemBuffer buffer = painted(made.scene);
    EXPECT_EQ(buffer.surfaces[0], ItemBuffer::unknown) << "it may be anywhere";

    const auto unknown_with = [&](const std::function<void(ItemScene&)>& damage) {
        ItemScene damaged(look_at({3, 2, -5}, {0, 0, 0}), width, height);
        damaged.cylinder({0, -1, 0}, {0, 1, 0}, 1);
        damage(damaged);
        buffer = painted(damaged.scene);
        EXPECT_EQ(buffer.surfaces[width * height / 2 + width / 2], ItemBuffer::unknown);
        EXPECT_EQ(buffer.surfaces[0], ItemBuffer::background);
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
    EXPECT_EQ(painted(without_camera.scene).surfaces[7], ItemBuffer::unknown);
}

TEST(ItemPainter, SurfacesKeepAllTheirBits) {
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
    const ItemBuffer buffer = painted(made.scene);
    for (int i = 0; i < 6; ++i) {
        const glm::dvec3 p = made.scene.polygons.camera.to_pixels * glm::dvec4(i - 2.5, 0, 0, 1);
        EXPECT_EQ(buffer.surfaces[static_cast<std::size_t>(5 * 30 + int(p.x / p.z))], surfaces[i]);
    }
}

}  // namespace
}  // namespace povpreview::test
