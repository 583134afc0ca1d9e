// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Geometry on its way: what is sent is read, what contradicts itself is refused, it is had once
// whatever becomes of the tracer, and becomes a scene of convex faces.
#include "adapter/geometry.h"

#include <glm/geometric.hpp>
#include <limits>

#include "adapter/wire.h"
#include "tests/adapter/frames.h"
#include "tests/adapter/oracle_fixture.h"

namespace povpreview {
namespace {

using fake::small_geometry;

report::GeometryChunk decode(const Geometry& geometry, bool last = true) {
    const fake::Bytes frame = fake::geometry_frame(geometry, last);
    const fake::Bytes content(frame.begin() + 4, frame.end());
    return std::get<report::GeometryChunk>(decode_report(content));
}

void expect_equal(const Geometry& a, const Geometry& b) {
    EXPECT_EQ(a.points, b.points);
    EXPECT_EQ(a.corners, b.corners);
    ASSERT_EQ(a.rings.size(), b.rings.size());
    for (std::size_t i = 0; i < a.rings.size(); ++i) {
        EXPECT_EQ(a.rings[i].first, b.rings[i].first);
        EXPECT_EQ(a.rings[i].count, b.rings[i].count);
    }
    ASSERT_EQ(a.polygons.size(), b.polygons.size());
    for (std::size_t i = 0; i < a.polygons.size(); ++i) {
        const Geometry::Polygon &p = a.polygons[i], &q = b.polygons[i];
        EXPECT_EQ(p.first_ring, q.first_ring);
        EXPECT_EQ(p.rings, q.rings);
        EXPECT_EQ(p.convex, q.convex);
        EXPECT_EQ(p.face.surface, q.face.surface);
        EXPECT_EQ(p.face.material, q.face.material);
        EXPECT_EQ(p.face.smooth, q.face.smooth);
        EXPECT_EQ(p.face.transparent, q.face.transparent);
        EXPECT_EQ(p.face.casts_shadow, q.face.casts_shadow);
        EXPECT_EQ(p.face.visible, q.face.visible);
        EXPECT_EQ(p.face.reflected, q.face.reflected);
        EXPECT_EQ(p.face.lit_from_behind, q.face.lit_from_behind);
        EXPECT_EQ(p.face.mirror, q.face.mirror);
    }
    ASSERT_EQ(a.left_out.size(), b.left_out.size());
    for (std::size_t i = 0; i < a.left_out.size(); ++i) {
        EXPECT_EQ(a.left_out[i].kind, b.left_out[i].kind);
        EXPECT_EQ(a.left_out[i].reason, b.left_out[i].reason);
        EXPECT_EQ(a.left_out[i].count, b.left_out[i].count);
    }
}

TEST(GeometryOnTheWire, IsReadAsItWasWritten) {
    const report::GeometryChunk chunk = decode(small_geometry());
    EXPECT_TRUE(chunk.last);
    EXPECT_FALSE(decode(small_geometry(), false).last);
    expect_equal(chunk.part, small_geometry());
    expect_equal(decode({}).part, {});
}

TEST(GeometryOnTheWire, ContradictionsAreRefused) {
    const auto refused = [](const std::function<void(Geometry&)>& spoil) {
        Geometry geometry = small_geometry();
        spoil(geometry);
        EXPECT_THROW(decode(geometry), WireFault);
    };
    refused([](Geometry& g) { g.corners[2] = static_cast<std::uint32_t>(g.points.size()); });
    refused([](Geometry& g) { g.corners[2] = 0xffffffff; });
    refused([](Geometry& g) { g.points.clear(); });
    refused([](Geometry& g) { g.corners.pop_back(); });
    refused([](Geometry& g) { g.corners.push_back(0); });
    refused([](Geometry& g) { g.rings[1].count = 0xffffffff; });
    refused([](Geometry& g) { g.rings.pop_back(); });
    refused([](Geometry& g) { g.polygons[0].rings = 0xffffffff; });
    refused([](Geometry& g) { g.polygons.pop_back(); });
    refused([](Geometry& g) { g.left_out.assign(5000, {"a", "b", 1}); });
    refused([](Geometry& g) { g.left_out[0].reason.assign(300, 'x'); });
}

TEST(GeometryOnTheWire, ReflectionIsAShareWhateverIsSent) {
    Geometry geometry = small_geometry();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (const auto& [sent, read] : {std::pair(nan, 0.f), {-1.f, 0.f}, {7.f, 1.f}, {.5f, .5f}}) {
        geometry.polygons[0].face.mirror = sent;
        EXPECT_EQ(decode(geometry).part.polygons[0].face.mirror, read);
    }
}

TEST(Geometry, AppendedPartsKeepTheirPolygons) {
    Geometry both = small_geometry();
    both.append(small_geometry());
    const Geometry one = small_geometry();
    ASSERT_EQ(both.polygons.size(), 2 * one.polygons.size());
    for (std::size_t p = 0; p < both.polygons.size(); ++p) {
        const Geometry::Polygon &polygon = both.polygons[p],
                                &original = one.polygons[p % one.polygons.size()];
        ASSERT_EQ(polygon.rings, original.rings);
        for (std::uint32_t r = 0; r < polygon.rings; ++r) {
            const Geometry::Ring &ring = both.rings[polygon.first_ring + r],
                                 &from = one.rings[original.first_ring + r];
            ASSERT_EQ(ring.count, from.count);
            for (std::uint32_t i = 0; i < ring.count; ++i)
                EXPECT_EQ(both.points[both.corners[ring.first + i]],
                          one.points[one.corners[from.first + i]]);
        }
    }
}

// ---- through the oracle

/// A complete scene of the fake tracer: its two chunks.
Geometry complete() {
    Geometry geometry = small_geometry();
    geometry.append(small_geometry());
    return geometry;
}

using GeometryOracleTest = OracleTest;

TEST_F(GeometryOracleTest, ComesOnceBesideTheSamples) {
    PovrayOracle oracle(fake_tracer({"geometry"}));
    oracle.wait_for_scene(nullptr, nullptr);
    expect_right(trace(oracle, all_pixels(), Parts::colour), all_pixels(), Parts::colour);
    oracle.wait_for_geometry(nullptr);
    const std::optional<Geometry> geometry = oracle.take_geometry();
    ASSERT_TRUE(geometry);
    expect_equal(*geometry, complete());
    EXPECT_FALSE(oracle.take_geometry());
    oracle.wait_for_geometry(nullptr);  // had already: returns at once
    EXPECT_FALSE(oracle.take_geometry());
}

TEST_F(GeometryOracleTest, IsNotHadTwiceWhenTheTracerDies) {
    PovrayOracle oracle(fake_tracer({"geometry", "die_after=100", "once=" + fresh_file()}));
    oracle.wait_for_scene(nullptr, nullptr);
    oracle.wait_for_geometry(nullptr);
    EXPECT_TRUE(oracle.take_geometry());
    expect_right(trace(oracle, all_pixels(), Parts::colour), all_pixels(), Parts::colour);
    EXPECT_EQ(oracle.statistics().restarts, 1U);
    EXPECT_FALSE(oracle.take_geometry());
}

TEST_F(GeometryOracleTest, IsCompleteThoughTheTracerDiedWithinIt) {
    PovrayOracle oracle(fake_tracer({"geometry=half", "once=" + fresh_file()}));
    oracle.wait_for_scene(nullptr, nullptr);
    oracle.wait_for_geometry(nullptr);
    EXPECT_EQ(oracle.statistics().restarts, 1U);
    expect_equal(oracle.take_geometry().value(), complete());
}

TEST_F(GeometryOracleTest, InTheWrongPlaceOrOutOfRangeItEndsTheTracer) {
    for (const char* how : {"early", "twice", "wrong"}) {
        SCOPED_TRACE(how);
        const std::string text =
            error_of(fake_tracer({std::string("geometry=") + how}), Exit::tracer);
        EXPECT_NE(text.find("geometry"), std::string::npos) << text;
    }
}

TEST_F(GeometryOracleTest, WaitingEndsWhenInterruptedOrSilent) {
    PovrayOracle interrupted(fake_tracer({}));
    interrupted.wait_for_scene(nullptr, nullptr);
    EXPECT_THROW(interrupted.wait_for_geometry([] { return true; }), Error);
    PovrayOracle silent(fake_tracer({}, 300ms));
    silent.wait_for_scene(nullptr, nullptr);
    try {
        silent.wait_for_geometry(nullptr);
        ADD_FAILURE() << "geometry came";
    } catch (const Error& error) {
        EXPECT_EQ(error.exit(), Exit::tracer);
    }
}

// ---- as a scene

SceneDescription description() {
    SceneDescription scene;
    scene.width = 64;
    scene.height = 48;
    scene.camera.location = {0, 0, -5};
    scene.camera.direction = {0, 0, 1};
    scene.camera.right = {1.33, 0, 0};
    scene.camera.up = {0, 1, 0};
    return scene;
}

double area(const PolygonScene& scene, const Face& face) {
    glm::dvec3 sum(0);
    for (std::size_t i = 2; i < face.count; ++i)
        sum += glm::cross(scene.corner(face, i - 1) - scene.corner(face, 0),
                          scene.corner(face, i) - scene.corner(face, 0));
    return glm::length(sum) / 2;
}

TEST(PolygonSceneOfGeometry, PolygonsWithHolesAreCutIntoConvexFaces) {
    const std::optional<PolygonScene> scene = polygon_scene(small_geometry(), description());
    ASSERT_TRUE(scene);
    EXPECT_EQ(scene->width, 64);
    ASSERT_GT(scene->faces.size(), 4U);
    EXPECT_EQ(scene->faces[0].count, 3U);
    EXPECT_EQ(scene->faces[1].smooth, 9U);
    double sum = 0;
    for (std::size_t i = 2; i < scene->faces.size(); ++i) sum += area(*scene, scene->faces[i]);
    EXPECT_NEAR(sum, 6 - .24, 1e-12);
}

TEST(PolygonSceneOfGeometry, PointsThatAreNoNumbersLeaveTheOthersAlone) {
    Geometry geometry = small_geometry();
    geometry.points[13].x = std::numeric_limits<double>::quiet_NaN();
    const std::optional<PolygonScene> scene = polygon_scene(geometry, description());
    ASSERT_TRUE(scene);
    EXPECT_EQ(scene->faces.size(), 2U);
}

TEST(PolygonSceneOfGeometry, OnlyLightsThatCastShadowsOnAll) {
    SceneDescription scene = description();
    scene.lights.resize(4);
    scene.lights[0].shadowless = true;
    scene.lights[1].position = {1, 2, 3};
    scene.lights[1].colour = {.3, .6, .9};
    scene.lights[2].in_group = true;
    scene.lights[3].parallel = true;
    scene.lights[3].position = {0, 9, 0};
    scene.lights[3].points_at = {0, 2, 0};
    const std::vector<PointLight> lights = polygon_scene({}, scene).value().lights;
    ASSERT_EQ(lights.size(), 2U);
    EXPECT_EQ(lights[0].position, glm::dvec4(1, 2, 3, 1));
    EXPECT_NEAR(lights[0].brightness, .6, 1e-6);
    EXPECT_EQ(lights[0].number, 1U);
    EXPECT_EQ(lights[1].position, glm::dvec4(0, 7, 0, 0));
    EXPECT_EQ(lights[1].number, 3U);
}

TEST(PolygonSceneOfGeometry, NoneForACameraThatBendsLines) {
    SceneDescription scene = description();
    scene.camera.kind = CameraKind::fisheye;
    EXPECT_FALSE(polygon_scene(small_geometry(), scene));
}

}  // namespace
}  // namespace povpreview
