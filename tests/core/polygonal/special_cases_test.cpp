// SPDX-License-Identifier: AGPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/polygonal/edge_finding.h"
#include "tests/core/polygonal/scene_builder.h"

/// Single arrangements that random scenes seldom or never hold.
namespace povpreview {
namespace {

std::vector<ImageEdge> find(const PolygonScene& scene, int mirror_depth = 1) {
    std::vector<ImageEdge> all;
    find_edges(scene, {.mirror_depth = mirror_depth},
               [&](std::vector<ImageEdge>&& pieces, std::uint64_t) {
                   all.insert(all.end(), pieces.begin(), pieces.end());
                   return true;
               });
    return all;
}

double length(const std::vector<ImageEdge>& pieces, EdgeKind kind) {
    double sum = 0;
    for (const ImageEdge& piece : pieces)
        if (piece.kind == kind) sum += glm::distance(piece.from, piece.to);
    return sum;
}

/// Whether pieces of a kind cover the segment between two positions of the image.
bool covered(const std::vector<ImageEdge>& pieces, EdgeKind kind, glm::dvec2 from, glm::dvec2 to) {
    for (int i = 1; i < 50; ++i) {
        const glm::dvec2 spot = from + i / 50. * (to - from);
        const bool near = std::any_of(pieces.begin(), pieces.end(), [&](const ImageEdge& piece) {
            const glm::dvec2 along = piece.to - piece.from;
            const double t =
                std::clamp(glm::dot(spot - piece.from, along) / glm::dot(along, along), 0., 1.);
            return piece.kind == kind && glm::distance(spot, piece.from + t * along) < .01;
        });
        if (!near) return false;
    }
    return true;
}

glm::dvec2 project(const PolygonScene& scene, glm::dvec3 point) {
    const glm::dvec3 h = scene.camera.to_pixels * glm::dvec4(point, 1);
    return {h.x / h.z, h.y / h.z};
}

/// From above, so that the image shows the floor within 3 of the origin and no border of it.
SceneBuilder from_above(double floor) {
    SceneBuilder builder;
    builder.look({0, 9, -3}, {0, 0, 0}, .6, 480, 480);
    builder.floor(0, floor);
    return builder;
}

TEST(SpecialCases, HowWideTheFloorIsSaysNothingAboutShadowsOnIt) {
    for (const bool parallel : {false, true}) {
        double narrow = 0;
        for (const double floor : {10., 1e3, 1e5, 1e7}) {
            SceneBuilder builder = from_above(floor);
            builder.box({0, .005, 0}, {.5, .005, .5});  // a sheet lying on it
            builder.box({1, .3, .2}, {.2, .3, .3});
            if (parallel)
                builder.parallel_light({1, 1, .3});
            else
                builder.light({3, 3, 1});
            const double shadows = length(find(builder.scene), EdgeKind::shadow);
            EXPECT_GT(shadows, 20);
            if (floor == 10.) narrow = shadows;
            EXPECT_NEAR(shadows, narrow, .1) << "floor " << floor << ", parallel " << parallel;
        }
    }
}

TEST(SpecialCases, HowWideTheFloorIsSaysNothingAboutWhatCutsIt) {
    double narrow = 0;
    for (const double floor : {10., 1e3, 1e5, 1e7}) {
        SceneBuilder builder = from_above(floor);
        builder.box({0, 0, 0}, {.5, .005, .5});  // half sunk
        builder.box({1, 0, .2}, {.2, 3e-4, .3});
        const double edges = length(find(builder.scene), EdgeKind::geometric);
        EXPECT_GT(edges, 20);
        if (floor == 10.) narrow = edges;
        EXPECT_NEAR(edges, narrow, .1) << "floor " << floor;
    }
}

TEST(SpecialCases, WhereAnUnseenFaceCutsTheFloorItsShadowBegins) {
    SceneBuilder builder = from_above(5);
    builder.style.visible = false;
    builder.polygon({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}});
    builder.light({.2, 4, -5});
    const auto pieces = find(builder.scene);
    EXPECT_TRUE(covered(pieces, EdgeKind::shadow, project(builder.scene, {-1, 0, 0}),
                        project(builder.scene, {1, 0, 0})));
}

TEST(SpecialCases, ParallelViewsBeginAtThePlaneOfTheCamera) {
    SceneBuilder builder;
    builder.floor(0, 100);
    builder.look_parallel({0, .5, 0}, {0, 0, 1}, 4, 480, 480);
    // The floor behind that plane is not there: it ends where the plane cuts it.
    const glm::dvec4 depth = builder.scene.camera.depth;
    const double z = -depth.w / depth.z;
    const auto pieces = find(builder.scene);
    EXPECT_TRUE(covered(pieces, EdgeKind::geometric, project(builder.scene, {-1.9, 0, z}),
                        project(builder.scene, {1.9, 0, z})));
}

/// A wall of one piece, and one of parts of one surface that meet in T-junctions: no edge between.
TEST(SpecialCases, PartsOfOneFlatSurfaceHaveNoEdgesBetween) {
    SceneBuilder whole, parts;
    for (SceneBuilder* builder : {&whole, &parts}) builder->look({.3, 3, -8}, {0, 1, 0}, 1, 64, 48);
    whole.polygon({{-2, 0, 0}, {2, 0, 0}, {2, 2, 0}, {-2, 2, 0}});
    parts.polygon({{-2, 0, 0}, {2, 0, 0}, {2, 1, 0}, {-2, 1, 0}});
    parts.polygon({{-2, 1, 0}, {.5, 1, 0}, {.5, 2, 0}, {-2, 2, 0}});
    parts.polygon({{.5, 1, 0}, {2, 1, 0}, {2, 2, 0}, {.5, 2, 0}});
    for (Face& face : parts.scene.faces) face.surface = 1;
    const double expected = length(find(whole.scene), EdgeKind::geometric);
    EXPECT_GT(expected, 50);
    EXPECT_NEAR(length(find(parts.scene), EdgeKind::geometric), expected, 1e-6);
}

/// The same wall in front of a light: its parts cast the shadow of the whole.
TEST(SpecialCases, PartsOfOneFlatSurfaceCastOneShadow) {
    double lengths[2];
    for (const bool parts : {false, true}) {
        SceneBuilder builder = from_above(5);
        builder.style.visible = false;
        if (parts) {
            builder.polygon({{-1, 1, -1}, {1, 1, -1}, {1, 1, 0}, {-1, 1, 0}});
            builder.polygon({{-1, 1, 0}, {.5, 1, 0}, {.5, 1, 1}, {-1, 1, 1}});
            builder.polygon({{.5, 1, 0}, {1, 1, 0}, {1, 1, 1}, {.5, 1, 1}});
        } else
            builder.polygon({{-1, 1, -1}, {1, 1, -1}, {1, 1, 1}, {-1, 1, 1}});
        builder.light({.2, 6, -.1});
        lengths[parts] = length(find(builder.scene), EdgeKind::shadow);
    }
    EXPECT_GT(lengths[0], 100);
    EXPECT_NEAR(lengths[1], lengths[0], 1e-6);
}

TEST(SpecialCases, TransparentFacesHaveEdgesAndSoHasWhatIsBehindThem) {
    SceneBuilder builder = from_above(5);
    builder.box({0, .2, 0}, glm::dvec3(.2));
    builder.style.transparent = true;
    builder.polygon({{-1, 1, -1}, {1, 1, -1}, {1, 1, 1}, {-1, 1, 1}});
    builder.polygon({{-.5, 2, -1}, {.5, 2, -1}, {.5, 2, 1}, {-.5, 2, 1}});
    const auto pieces = find(builder.scene);
    const auto shown = [&](glm::dvec3 from, glm::dvec3 to) {
        return covered(pieces, EdgeKind::geometric, project(builder.scene, from),
                       project(builder.scene, to));
    };
    EXPECT_TRUE(shown({-.5, 2, -1}, {-.5, 2, 1}));
    EXPECT_TRUE(shown({-1, 1, 1}, {1, 1, 1}));  // behind the other
    EXPECT_TRUE(shown({-.2, .4, -.2}, {.2, .4, -.2}));
}

TEST(SpecialCases, MirrorsShowTheBorderOfAWideFloor) {
    for (const double wide : {10., 1e4, 1e6}) {
        SceneBuilder builder;
        builder.look({0, 1.5, -4}, {0, 1.5, 1}, 1, 480, 480);
        builder.style.mirror = 1;
        builder.polygon({{-2, .2, 1}, {2, .2, 1}, {2, 4, 1}, {-2, 4, 1}});
        builder.style = {};
        builder.polygon({{-wide, 0, -wide}, {wide, 0, -wide}, {wide, 0, wide}, {-wide, 0, wide}});
        // The mirror turns z into 2 - z; it shows x from -2 to 2 at distance 5.
        const double x = .35 * (wide + 6);
        const auto pieces = find(builder.scene);
        EXPECT_TRUE(covered(pieces, EdgeKind::reflection, project(builder.scene, {-x, 0, 2 + wide}),
                            project(builder.scene, {x, 0, 2 + wide})))
            << wide;
    }
}

TEST(SpecialCases, ChainsOfMirrorsShowTheirDepth) {
    // Two mirrors face each other across x; between them a small box. Each reflection more shows
    // it once more.
    int edges_seen[4];
    for (const int depth : {0, 1, 2, 3}) {
        SceneBuilder builder;
        builder.look({-.8, 1.2, -2.5}, {1, 1, -.6}, 1.4, 480, 480);
        builder.style.mirror = 1;
        builder.polygon({{-1, 0, -3}, {-1, 0, 3}, {-1, 2, 3}, {-1, 2, -3}});
        builder.polygon({{1, 0, -3}, {1, 0, 3}, {1, 2, 3}, {1, 2, -3}});
        builder.style = {};
        builder.box({.1, .9, .5}, glm::dvec3(.15), turn_about({1, 2, 3}, .4));
        edges_seen[depth] =
            int(std::lround(length(find(builder.scene, depth), EdgeKind::reflection)));
    }
    EXPECT_EQ(edges_seen[0], 0);
    for (int depth = 1; depth <= 3; ++depth)
        EXPECT_GT(edges_seen[depth], edges_seen[depth - 1] + 100) << depth;
}

}  // namespace
}  // namespace povpreview
