// SPDX-License-Identifier: AGPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <ctime>
#include <limits>

#include "core/polygonal/edge_finding.h"
#include "tests/core/polygonal/random_scenes.h"
#include "tests/core/polygonal/scene_builder.h"

/// People's scenes: whatever is wrong with them, edge finding ends soon and gives usable pieces.
namespace povpreview {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double time_limit = 10;  ///< seconds, sanitizers included; all scenes here are small

/// Finds the edges and checks what holds of all pieces, whatever the scene.
std::vector<ImageEdge> find_soundly(const PolygonScene& scene, int mirror_depth = 1) {
    const std::clock_t start = std::clock();  // other work on the machine does not count
    std::vector<ImageEdge> all;
    find_edges(scene, {.mirror_depth = mirror_depth},
               [&](std::vector<ImageEdge>&& pieces, std::uint64_t) {
                   all.insert(all.end(), pieces.begin(), pieces.end());
                   return true;
               });
    EXPECT_LT(double(std::clock() - start) / CLOCKS_PER_SEC, time_limit);
    for (const ImageEdge& piece : all) {
        for (const glm::dvec2 end : {piece.from, piece.to}) {
            const bool inside =
                end.x >= 0 && end.y >= 0 && end.x <= scene.width && end.y <= scene.height;
            EXPECT_TRUE(inside) << fmt::format("({}, {})", end.x, end.y);  // false for NaN, too
            if (!inside) return all;
        }
        EXPECT_NE(piece.from, piece.to);
        EXPECT_GE(piece.importance, 0);
        EXPECT_LE(piece.importance, 1);
        const bool of_a_light = piece.kind == EdgeKind::shadow;
        EXPECT_TRUE(!of_a_light || piece.light < scene.lights.size());
        EXPECT_NE(piece.kind, EdgeKind::traced);
    }
    return all;
}

int count(const std::vector<ImageEdge>& pieces, EdgeKind kind) {
    return int(std::count_if(pieces.begin(), pieces.end(),
                             [&](const ImageEdge& piece) { return piece.kind == kind; }));
}

/// Total length of a kind, pixels.
double length(const std::vector<ImageEdge>& pieces, EdgeKind kind) {
    double sum = 0;
    for (const ImageEdge& piece : pieces)
        if (piece.kind == kind) sum += glm::distance(piece.from, piece.to);
    return sum;
}

/// A box on a floor with a light: what bad things are added to.
SceneBuilder plain_scene() {
    SceneBuilder builder;
    builder.look({0, 3, -8}, {0, .5, 0}, 1, 64, 48);
    builder.floor(0, 5);
    builder.box({0, 1, 0}, glm::dvec3(1));
    builder.light({3, 6, -4});
    return builder;
}

TEST(BadInput, EmptyScenes) {
    SceneBuilder builder;
    builder.look({0, 3, -8}, {0, 0, 0}, 1, 64, 48);
    EXPECT_TRUE(find_soundly(builder.scene).empty());
    builder.light({0, 5, 0});
    EXPECT_TRUE(find_soundly(builder.scene).empty());
    PolygonScene no_image = plain_scene().scene;
    no_image.width = no_image.height = 0;
    EXPECT_TRUE(find_soundly(no_image).empty());
}

TEST(BadInput, WithoutLightsNoShadows) {
    SceneBuilder builder = plain_scene();
    builder.scene.lights.clear();
    const auto pieces = find_soundly(builder.scene);
    EXPECT_EQ(count(pieces, EdgeKind::shadow), 0);
    EXPECT_GE(count(pieces, EdgeKind::geometric), 7 + 3);  // of the box and the floor
}

TEST(BadInput, ASceneOfUsableFacesHasAllKinds) {
    SceneBuilder builder = plain_scene();
    builder.style.mirror = .5F;
    builder.polygon({{-4, 0, 3}, {4, 0, 3}, {4, 4, 3}, {-4, 4, 3}});
    const auto pieces = find_soundly(builder.scene);
    for (const EdgeKind kind : {EdgeKind::geometric, EdgeKind::shadow, EdgeKind::reflection})
        EXPECT_GT(length(pieces, kind), 20) << int(kind);
}

/// The bad faces change nothing about the edges of the good ones.
void expect_harmless(const PolygonScene& bad) {
    const auto good = find_soundly(plain_scene().scene), pieces = find_soundly(bad);
    for (const EdgeKind kind : {EdgeKind::geometric, EdgeKind::shadow})
        EXPECT_NEAR(length(pieces, kind), length(good, kind), 1e-3) << int(kind);
}

TEST(BadInput, FacesWithoutAreaAreNotThere) {
    SceneBuilder builder = plain_scene();
    builder.polygon({{-2, 2, -3}, {2, 2, -3}, {0, 2, -3}});  // a line
    builder.polygon({{1, 2, -3}, {1, 2, -3}, {1, 2, -3}});   // a point
    builder.polygon({{-2, 2, -3}, {2, 2, -3}, {2, 2, -3}, {-2, 2, -3}});
    builder.polygon({{1, 2, -3}, {2, 3, -3}});  // two corners
    builder.polygon({{1, 2, -3}});
    builder.polygon({});
    expect_harmless(builder.scene);
}

TEST(BadInput, FacesThatAreNotFiniteAreNotThere) {
    SceneBuilder builder = plain_scene();
    builder.polygon({{-2, 2, -3}, {2, nan, -3}, {0, 3, -3}});
    builder.polygon({{-2, 2, -3}, {2, 2, -3}, {0, infinity, -3}});
    builder.polygon({{nan, nan, nan}, {nan, nan, nan}, {nan, nan, nan}});
    builder.polygon({{-infinity, 0, 0}, {infinity, 0, 0}, {0, 1, 0}});
    expect_harmless(builder.scene);
}

TEST(BadInput, RepeatedCornersDoNotMatter) {
    SceneBuilder once, twice;
    for (SceneBuilder* builder : {&once, &twice}) builder->look({0, 3, -8}, {0, .5, 0}, 1, 64, 48);
    const glm::dvec3 a{-2, 0, 0}, b{2, 0, 0}, c{1, 2, 0}, d{-1, 2, 0};
    once.polygon({a, b, c, d});
    twice.polygon({a, a, b, b, b, c, d, d, a});
    const double expected = length(find_soundly(once.scene), EdgeKind::geometric);
    EXPECT_GT(expected, 30);
    EXPECT_NEAR(length(find_soundly(twice.scene), EdgeKind::geometric), expected, 1e-6);
}

TEST(BadInput, CornersOutOfThePlaneOrConcave) {
    Dice dice(5);
    for (int i = 0; i < 50; ++i) {
        SceneBuilder builder = plain_scene();
        std::vector<glm::dvec3> corners;
        for (int k = dice.whole(3, 9); k > 0; --k) corners.push_back(dice.vector(-3, 3));
        builder.polygon(corners);  // anyhow: bent, concave, crossing itself
        builder.polygon({{-2, 2, -1}, {2, 2 + 1e-6, -1}, {2, 3, -1 + 1e-7}, {-2, 3, -1}});
        builder.polygon({{-2, 0, -2}, {0, .5, -2}, {2, 0, -2}, {0, 2, -2}});  // an arrow head
        find_soundly(builder.scene);
    }
}

TEST(BadInput, EyeOnThings) {
    const glm::dvec3 eye{0, 3, -8};
    for (const glm::dvec3 across :
         {glm::dvec3(1, 0, 0), glm::dvec3(0, 0, 1), glm::dvec3(1, 2, 3)}) {
        SceneBuilder builder = plain_scene();
        // An edge through the eye, a corner at it, a face around it, a plane through it.
        builder.polygon({eye - across, eye + across, {0, 0, 0}});
        builder.polygon({eye, {1, 1, 1}, {-1, 1, 1}});
        builder.polygon(
            {eye - across, eye + glm::dvec3(.3, 1, .1), eye + across, eye - glm::dvec3(.3, 1, .1)});
        builder.polygon({eye + across, eye + 2. * across, {0, 0, 0}});
        find_soundly(builder.scene);
    }
}

TEST(BadInput, EyeInTheFloorAndInsideABox) {
    for (const double y : {0., 1., 1e-12, -1e-12}) {
        SceneBuilder builder = plain_scene();
        builder.look({0, y, -3}, {0, y, 0}, 1, 64, 48);
        find_soundly(builder.scene);
        builder.look({0, y, 0}, {0, y, 3}, 1, 64, 48);
        find_soundly(builder.scene);
    }
}

TEST(BadInput, LightsInPlanesAtTheEyeAndInsideSolids) {
    SceneBuilder builder = plain_scene();
    for (const glm::dvec3 at : {glm::dvec3(3, 0, -2), glm::dvec3(1, 5, 0), glm::dvec3(0, 3, -8),
                                glm::dvec3(0, 1, 0), glm::dvec3(1, 2, -1), glm::dvec3(1, 2, 0)})
        builder.light(at);
    builder.parallel_light({1, 0, 0});   // along the floor
    builder.parallel_light({0, -1, 0});  // from below
    builder.parallel_light({0, 0, 0});   // from nowhere
    builder.light({nan, 1, 0});
    builder.light({infinity, 1, 0});
    builder.light({1e300, 1e300, 0});
    const auto pieces = find_soundly(builder.scene);
    EXPECT_GT(length(pieces, EdgeKind::geometric), 30);
}

TEST(BadInput, LightAtTheEyeShowsNoShadow) {
    SceneBuilder builder = plain_scene();
    builder.scene.lights.clear();
    builder.light({0, 3, -8});
    const auto pieces = find_soundly(builder.scene);
    EXPECT_GT(length(pieces, EdgeKind::geometric), 30);
    // What the eye sees, the light sees: shadow borders can but coincide with silhouettes.
    const double without = [&] {
        builder.scene.lights.clear();
        return length(find_soundly(builder.scene), EdgeKind::geometric);
    }();
    EXPECT_NEAR(length(pieces, EdgeKind::geometric), without, 1e-6);
}

TEST(BadInput, FacesThroughTheNearPlane) {
    SceneBuilder builder = plain_scene();
    builder.polygon({{-1, -5, -30}, {1, -5, -30}, {1, 4, 20}, {-1, 4, 20}});
    builder.polygon({{-100, 1, -100}, {100, 1, -100}, {0, 1, 100}});
    builder.polygon({{0, 3, -9}, {1, 3, -9}, {1, 4, -9}});  // behind the eye
    builder.box({0, 3, -8}, glm::dvec3(.5));                // around it
    find_soundly(builder.scene);
    builder.look_parallel({0, 3, 0}, {0, 3, 5}, 6, 64, 48);  // begins in the box
    find_soundly(builder.scene);
}

TEST(BadInput, LargeAndSmallTogether) {
    for (const double large : {1e5, 1e7, 1e9, 1e12, 1e100, 1e200, 1e308}) {
        SceneBuilder builder = plain_scene();
        builder.floor(-1, large);
        builder.polygon({{-large, -large, large}, {large, -large, large}, {0, large, large}});
        builder.box({2, 1, -1}, glm::dvec3(1e-9));
        builder.box({-2, 1, -1}, glm::dvec3(1e-9, 1e-9, large));
        builder.box({-2, 1, -1}, glm::dvec3(5e-324));
        builder.light({large, large, -large});
        builder.light({2, 1 + 2e-9, -1});
        find_soundly(builder.scene);
    }
}

TEST(BadInput, EverythingTinyOrHuge) {
    // The same picture at every scale; what is farther than 1e7 POV-Ray does not see.
    double expected = 0;
    for (const double scale : {1., 1e-9, 1e-6, 1e5, 1e9, 1e15}) {
        SceneBuilder builder = plain_scene();
        for (glm::dvec3& point : builder.scene.points) point *= scale;
        builder.look(scale * glm::dvec3(0, 3, -8), scale * glm::dvec3(0, .5, 0), 1, 64, 48);
        builder.scene.lights.clear();
        builder.light(scale * glm::dvec3(3, 6, -4));
        const auto pieces = find_soundly(builder.scene);
        const double sum = length(pieces, EdgeKind::geometric) + length(pieces, EdgeKind::shadow);
        if (scale == 1) expected = sum;
        if (scale > 1e6) continue;
        EXPECT_GT(sum, 30);
        EXPECT_NEAR(sum, expected, 1e-3) << "scale " << scale;
    }
}

TEST(BadInput, Mirrors) {
    for (const int depth : {0, 1, 2, 3}) {
        SceneBuilder builder = plain_scene();
        builder.style.mirror = 1;
        builder.polygon({{-3, 0, 3}, {3, 0, 3}, {3, 4, 3}, {-3, 4, 3}});
        builder.polygon({{-3, 0, -9}, {3, 0, -9}, {3, 4, -9}, {-3, 4, -9}});  // faces the first
        builder.polygon({{-4, 0, -3}, {-4, 0, 3}, {-4, 4, 3}, {-4, 4, -3}});
        builder.polygon({{0, 0, -8}, {0, 6, -8}, {0, 6, -4}, {0, 0, -4}});  // the eye in it
        builder.polygon({{-3, 0, 3}, {3, 0, 3}, {3, 4, 3}, {-3, 4, 3}});    // doubled
        builder.polygon({{-1, 1, 1}, {-1, 1, 1}, {-1, 1, 1}});              // a point
        builder.polygon({{1, 1, nan}, {-1, 1, 1}, {-1, 1, 2}});
        const auto pieces = find_soundly(builder.scene, depth);
        EXPECT_EQ(count(pieces, EdgeKind::reflection) > 0, depth > 0);
    }
}

TEST(BadInput, ARoomOfMirrorsEnds) {
    SceneBuilder builder;
    builder.look({0, 1, -3}, {.3, 0, 0}, 1.2, 64, 48);
    builder.style.mirror = 1;
    builder.box({0, 0, 0}, glm::dvec3(4));
    builder.box({.5, -3, 1}, glm::dvec3(1), turn_about({0, 1, 0}, .5));
    builder.light({1, 3, -1});
    for (const int depth : {1, 2, 3}) find_soundly(builder.scene, depth);
}

TEST(BadInput, DoubledAndOverlappingFaces) {
    SceneBuilder builder = plain_scene();
    for (int i = 0; i < 4; ++i) {
        builder.box({0, 1, 0}, glm::dvec3(1));       // the very same again
        builder.box({.5 * i, 1, 0}, glm::dvec3(1));  // sides in one plane, overlapping
        builder.box({2, 1, 0}, glm::dvec3(1));       // side to side
        builder.floor(0, 5);
        builder.floor(1e-13 * i, 4);
    }
    EXPECT_GT(length(find_soundly(builder.scene), EdgeKind::geometric), 30);
}

TEST(BadInput, ManyFacesAroundOnePointAndOneEdge) {
    SceneBuilder builder = plain_scene();
    Dice dice(9);
    const glm::dvec3 hub{0, 2.5, -1}, end{1, 3, 0};
    for (int i = 0; i < 100; ++i) {
        builder.polygon({hub, hub + dice.vector(-1, 1), hub + dice.vector(-1, 1)});
        builder.polygon({hub, end, hub + dice.vector(-1, 1)});
    }
    find_soundly(builder.scene);
}

TEST(BadInput, StoppingAtOnceStops) {
    const PolygonScene scene = random_scene(Family::mirrors, 3, 64);
    int calls = 0;
    find_edges(scene, {}, [&](std::vector<ImageEdge>&&, std::uint64_t) {
        ++calls;
        return false;
    });
    EXPECT_EQ(calls, 1);
}

TEST(BadInput, FacesWithoutEndAreGivenUp) {
    const PolygonScene scene = random_scene(Family::mirrors, 3, 64);
    std::uint64_t all = 0;
    const auto take = [&](std::vector<ImageEdge>&&, std::uint64_t effort) {
        all = effort;
        return true;
    };
    EXPECT_TRUE(find_edges(scene, {}, take));
    const std::uint64_t whole = all;
    EXPECT_FALSE(find_edges(scene, {.most_effort = whole / 2}, take));
    EXPECT_GE(all, whole / 2);
    EXPECT_LT(all, whole);
}

TEST(BadInput, CamerasWithoutSense) {
    for (const double bad : {nan, infinity, 0.}) {
        PolygonScene scene = plain_scene().scene;
        scene.camera.to_pixels = glm::dmat4x3(bad);
        find_soundly(scene);
        scene = plain_scene().scene;
        scene.camera.depth = glm::dvec4(bad);
        find_soundly(scene);
        scene = plain_scene().scene;
        scene.camera.eye = glm::dvec4(bad);
        find_soundly(scene);
    }
}

TEST(BadInput, RandomDamage) {
    // Any number of the scene replaced by a bad one.
    Dice dice(12);
    const double bad[] = {0, nan, infinity, 1e300, 1e9, -1e9, 1e-9, 1e-300};
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
        const auto family = Family(dice.whole(0, int(Family::mixed_styles)));
        PolygonScene scene = random_scene(family, seed, 32);
        for (int i = dice.whole(1, 4); i > 0; --i) {
            const auto which = std::size_t(dice.whole(0, int(scene.points.size()) - 1));
            scene.points[which][dice.whole(0, 2)] = bad[dice.whole(0, std::size(bad) - 1)];
        }
        for (PointLight& light : scene.lights)
            if (dice.chance(.2))
                light.position[dice.whole(0, 3)] = bad[dice.whole(0, std::size(bad) - 1)];
        SCOPED_TRACE(fmt::format("family {} seed {}", int(family), seed));
        find_soundly(scene, dice.whole(0, 2));
    }
}

}  // namespace
}  // namespace povpreview
