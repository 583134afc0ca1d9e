// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/core/polygonal/brute_force.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "tests/core/polygonal/random_scenes.h"
#include "tests/core/polygonal/scene_builder.h"
#include "tests/core/polygonal/sight_change.h"

/// The reference itself, against arrangements whose picture is known on paper.
namespace povpreview {
namespace {

/// Looks straight down z from 10 before the origin; 10 units fill 100 pixels in the plane z = 0.
SceneBuilder ten_by_ten() {
    SceneBuilder builder;
    builder.look({0, 0, -10}, {0, 0, 0}, 2 * std::atan(.5), 100, 100);
    return builder;
}

/// A square across the view at some depth.
void square(SceneBuilder& builder, glm::dvec3 middle, double half) {
    builder.polygon({middle + glm::dvec3(-half, -half, 0), middle + glm::dvec3(half, -half, 0),
                     middle + glm::dvec3(half, half, 0), middle + glm::dvec3(-half, half, 0)});
}

TEST(BruteForce, LinesOfSightGoThroughThePointsThatTheyShow) {
    Dice dice(7);
    for (const Family family : {Family::boxes, Family::room})
        for (std::uint64_t seed = 0; seed < 20; ++seed) {
            const PolygonScene scene = random_scene(family, seed, 64);
            const BruteForce brute(scene, 0);
            for (int i = 0; i < 20; ++i) {
                const Vec3 point(dice.vector(-4, 4));
                const auto pixel = brute.project(point);
                if (!pixel) continue;
                const Ray ray = brute.ray_through(*pixel);
                const Vec3 off = glm::cross(point - ray.origin, ray.direction);
                EXPECT_LT(glm::length(off), 1e-11L) << family << " seed " << seed;
                EXPECT_GT(glm::dot(point - ray.origin, ray.direction), 0);
            }
        }
}

TEST(BruteForce, NearestOpaqueFaceEndsTheView) {
    SceneBuilder builder = ten_by_ten();
    square(builder, {0, 0, 0}, 2);
    builder.style.transparent = true;
    square(builder, {0, 0, -5}, 1);
    builder.style = {};
    square(builder, {0, 0, 5}, 5);
    builder.style.visible = false;
    square(builder, {0, 0, -8}, 1);
    const BruteForce brute(builder.scene, 1);
    const Sight sight = brute.look({50.5, 50.5});
    ASSERT_EQ(sight.hits.size(), 2U);
    EXPECT_EQ(sight.hits[0].face, 1U);
    EXPECT_NEAR(double(sight.hits[0].distance), 5, 1e-2);
    EXPECT_EQ(sight.hits[1].face, 0U);
    EXPECT_NEAR(double(sight.hits[1].point.z), 0, 1e-12);
    EXPECT_TRUE(brute.eye_sees({.5L, .5L, 0}));   // behind glass
    EXPECT_TRUE(brute.eye_sees({2, 2, 0}));       // on its own corner
    EXPECT_FALSE(brute.eye_sees({.5L, .5L, 1}));  // behind a square
    EXPECT_FALSE(brute.eye_sees({0, 0, -11}));    // behind the eye
    EXPECT_FALSE(sight.tie);
}

TEST(BruteForce, ShadowBorderIsWhereSimilarTrianglesPutIt) {
    SceneBuilder builder = ten_by_ten();
    square(builder, {0, 0, 0}, 5);
    builder.style.visible = false;
    square(builder, {0, 0, -2}, 1);  // its shadow by a light at distance 4: half as large again
    builder.light({0, 0, -4});
    builder.parallel_light({0, 0, -1});
    const BruteForce brute(builder.scene, 0);
    const auto lit = [&](double x) { return brute.look({50 + 10 * x, 50.1}).hits.at(0).lit; };
    EXPECT_EQ(lit(.9), 0U);
    EXPECT_EQ(lit(1.1), 2U);
    EXPECT_EQ(lit(1.9), 2U);
    EXPECT_EQ(lit(2.1), 3U);
    glm::dvec2 dark(65, 50.1), bright(75, 50.1);
    close_in(brute, dark, bright);
    EXPECT_NEAR(bright.x, 70, 1e-8);
    const auto change = change_between(brute, brute.look(dark), brute.look(bright));
    ASSERT_TRUE(change);
    EXPECT_EQ(change->kind, EdgeKind::shadow);
    EXPECT_EQ(change->lights, 1U);
}

TEST(BruteForce, FacesAreDarkFromBehindUnlessLitFromBehind) {
    for (const bool from_behind : {false, true}) {
        SceneBuilder builder = ten_by_ten();
        builder.style.lit_from_behind = from_behind;
        square(builder, {0, 0, 0}, 5);
        builder.light({1, 2, -4});
        builder.light({1, 2, 4});
        const BruteForce brute(builder.scene, 0);
        EXPECT_EQ(brute.look({50.3, 50.1}).hits.at(0).lit, from_behind ? 3U : 1U);
    }
}

TEST(BruteForce, MirrorsShowWhatStandsBeforeThem) {
    SceneBuilder builder = ten_by_ten();
    builder.style.mirror = 1;
    square(builder, {0, 0, 0}, 5);
    builder.style = {};
    builder.style.visible = builder.style.casts_shadow = false;
    square(builder, {0, 0, -6}, 1);
    builder.light({3, 3, -20});
    const BruteForce one(builder.scene, 1), none(builder.scene, 0);
    const glm::dvec2 middle(50.2, 50.3);
    EXPECT_EQ(none.look(middle).hits.size(), 1U);
    const Sight sight = one.look(middle);
    ASSERT_EQ(sight.hits.size(), 2U);
    EXPECT_EQ(sight.hits[1].face, 1U);
    EXPECT_EQ(sight.hits[1].mirrors, 1U);
    EXPECT_NEAR(double(sight.hits[1].distance), 16, 1e-3);
    EXPECT_EQ(sight.hits[1].lit, 0U);  // the light is on the other side than the mirror
    // Seen in the mirror, the border appears where its mirror image would be.
    const Vec3 image = one.mirrored({1, 0, -6}, 0);
    EXPECT_NEAR(double(image.z), 6, 1e-12);
    const auto border = one.project(image);
    ASSERT_TRUE(border);
    glm::dvec2 in = middle, out{90, 50.3};
    close_in(one, in, out);
    EXPECT_NEAR(in.x, border->x, 1e-8);
    const auto change = change_between(one, one.look(in), one.look(out));
    ASSERT_TRUE(change);
    EXPECT_EQ(change->kind, EdgeKind::reflection);
}

TEST(BruteForce, NoLineSlipsBetweenFacesThatShareAnEdge) {
    SceneBuilder builder = ten_by_ten();
    builder.ball({0, 0, 0}, 3, 7, 5, false, true);
    const BruteForce brute(builder.scene, 0);
    Dice dice(3);
    int aimed = 0;
    for (const Face& face : builder.scene.faces)
        for (std::uint32_t i = 0; i < face.count; ++i) {
            const Vec3 a(builder.scene.corner(face, i));
            const Vec3 b(builder.scene.corner(face, (i + 1) % face.count));
            const auto pixel = brute.project(a + Real(dice.from_to(0, 1)) * (b - a));
            if (!pixel || glm::distance(*pixel, glm::dvec2(50)) > 20) continue;
            ++aimed;
            EXPECT_FALSE(brute.look(*pixel).hits.empty());
        }
    EXPECT_GT(aimed, 30);
}

TEST(BruteForce, SmoothFacesPartThePictureAtSilhouettesOnly) {
    for (const bool smooth : {true, false}) {
        SceneBuilder builder = ten_by_ten();
        builder.ball({0, 0, 0}, 3, 9, 7, smooth, false);
        const BruteForce brute(builder.scene, 0);
        Dice dice(11);
        int edges = 0, passed = 0;
        for (int i = 0; i < 200; ++i) {
            glm::dvec2 p(dice.from_to(35, 65), dice.from_to(35, 65));
            glm::dvec2 q = p + glm::dvec2(2, 1);
            if (same_sight(brute.look(p), brute.look(q))) continue;
            close_in(brute, p, q);
            ++passed;
            edges += change_between(brute, brute.look(p), brute.look(q)).has_value();
        }
        EXPECT_GT(passed, 20);
        EXPECT_EQ(edges, smooth ? 0 : passed);
    }
}

}  // namespace
}  // namespace povpreview
