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

void expect_equal(const Bounds& a, const Bounds& b) {
    EXPECT_EQ(a.low, b.low);
    EXPECT_EQ(a.high, b.high);
}

void expect_equal_solids(const Geometry& a, const Geometry& b) {
    ASSERT_EQ(a.solids.size(), b.solids.size());
    for (std::size_t i = 0; i < a.solids.size(); ++i) {
        EXPECT_EQ(a.solids[i].kind, b.solids[i].kind);
        EXPECT_EQ(a.solids[i].to_frame, b.solids[i].to_frame);
        EXPECT_EQ(a.solids[i].coefficients, b.solids[i].coefficients);
        EXPECT_EQ(a.solids[i].first_number, b.solids[i].first_number);
        EXPECT_EQ(a.solids[i].numbers, b.solids[i].numbers);
    }
    EXPECT_EQ(a.numbers, b.numbers);
    EXPECT_EQ(a.conditions, b.conditions);
    ASSERT_EQ(a.pieces.size(), b.pieces.size());
    for (std::size_t i = 0; i < a.pieces.size(); ++i) {
        const CurvedPiece &p = a.pieces[i], &q = b.pieces[i];
        EXPECT_EQ(std::tie(p.solid, p.surface, p.material, p.first_condition, p.conditions),
                  std::tie(q.solid, q.surface, q.material, q.first_condition, q.conditions));
    }
    ASSERT_EQ(a.objects.size(), b.objects.size());
    for (std::size_t i = 0; i < a.objects.size(); ++i) {
        expect_equal(a.objects[i].bounds, b.objects[i].bounds);
        EXPECT_EQ(a.objects[i].first_piece, b.objects[i].first_piece);
        EXPECT_EQ(a.objects[i].pieces, b.objects[i].pieces);
    }
    ASSERT_EQ(a.unknown.size(), b.unknown.size());
    for (std::size_t i = 0; i < a.unknown.size(); ++i) expect_equal(a.unknown[i], b.unknown[i]);
    ASSERT_EQ(a.unknown_in_mirrors.size(), b.unknown_in_mirrors.size());
    for (std::size_t i = 0; i < a.unknown_in_mirrors.size(); ++i)
        expect_equal(a.unknown_in_mirrors[i], b.unknown_in_mirrors[i]);
}

void expect_equal_looks(const Geometry& a, const Geometry& b) {
    ASSERT_EQ(a.looks.size(), b.looks.size());
    for (std::size_t i = 0; i < a.looks.size(); ++i) {
        EXPECT_EQ(a.looks[i].material, b.looks[i].material);
        const Look &p = a.looks[i].look, &q = b.looks[i].look;
        EXPECT_EQ(p.kind, q.kind);
        EXPECT_EQ(
            std::tie(p.image.image, p.image.mapping, p.image.interpolation, p.image.once, p.mirror),
            std::tie(q.image.image, q.image.mapping, q.image.interpolation, q.image.once,
                     q.mirror));
        EXPECT_EQ(p.image.to_map, q.image.to_map);
        EXPECT_EQ(p.pattern.kind, q.pattern.kind);
        EXPECT_EQ(p.pattern.colours, q.pattern.colours);
        EXPECT_EQ(p.pattern.brick_size, q.pattern.brick_size);
        EXPECT_EQ(p.pattern.mortar, q.pattern.mortar);
        EXPECT_EQ(p.pattern.to_pattern, q.pattern.to_pattern);
    }
    ASSERT_EQ(a.images.size(), b.images.size());
    for (std::size_t i = 0; i < a.images.size(); ++i) {
        EXPECT_EQ(a.images[i].width, b.images[i].width);
        EXPECT_EQ(a.images[i].height, b.images[i].height);
    }
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
        EXPECT_EQ(a.left_out[i].drawn, b.left_out[i].drawn);
    }
    EXPECT_EQ(a.corner_uvs, b.corner_uvs);
    expect_equal_solids(a, b);
    expect_equal_looks(a, b);
}

TEST(GeometryOnTheWire, IsReadAsItWasWritten) {
    const report::GeometryChunk chunk = decode(small_geometry());
    EXPECT_TRUE(chunk.last);
    EXPECT_FALSE(decode(small_geometry(), false).last);
    expect_equal(chunk.part, small_geometry());
    expect_equal(decode({}).part, {});
}

TEST(GeometryOnTheWire, ContradictionsAreRefused) {
    constexpr float infinite = std::numeric_limits<float>::infinity();
    const auto pattern_in = [](Geometry& g) -> PatternLook& { return g.looks[3].look.pattern; };
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
    refused([](Geometry& g) { g.corner_uvs.pop_back(); });
    refused([](Geometry& g) { g.solids[1].kind = Solid::Kind{17}; });
    refused([](Geometry& g) { g.solids[1].numbers = 8; });
    refused([](Geometry& g) { g.pieces[2].solid = 5; });
    refused([](Geometry& g) { g.pieces[1].conditions = 0xffffffff; });
    refused([](Geometry& g) { g.pieces.pop_back(); });
    refused([](Geometry& g) { g.objects[0].pieces = 4; });
    refused([](Geometry& g) { g.objects.pop_back(); });
    refused([](Geometry& g) { g.looks[0].look.kind = Look::Kind{5}; });
    refused([](Geometry& g) { g.looks[0].look.image.mapping = ImageLook::Mapping{5}; });
    refused([](Geometry& g) { g.looks[0].look.image.interpolation = ImageLook::Interpolation{4}; });
    refused([&](Geometry& g) { pattern_in(g).kind = PatternLook::Kind{3}; });
    refused([&](Geometry& g) { pattern_in(g).colours[2].y = infinite; });
    refused([&](Geometry& g) { pattern_in(g).brick_size.z = infinite; });
    refused([&](Geometry& g) { pattern_in(g).mortar = -infinite; });
    refused([&](Geometry& g) { pattern_in(g).to_pattern[3].x = infinite; });
    refused([](Geometry& g) { g.images[0].width = 0; });
    refused([](Geometry& g) { g.images[0] = {4000, 4000, {}}; });
    refused([](Geometry& g) { g.images[0] = {0xffffffff, 0xffffffff, {}}; });
}

TEST(GeometryOnTheWire, ConditionsThatDoNotRunAreRefused) {
    const auto refused = [](std::vector<ConditionStep> steps) {
        Geometry geometry = small_geometry();
        geometry.conditions = steps;
        geometry.pieces.resize(1);
        geometry.pieces[0].conditions = static_cast<std::uint32_t>(steps.size());
        geometry.objects.resize(1);
        geometry.objects[0].pieces = 1;
        try {
            decode(geometry);
        } catch (const WireFault&) {
            return true;
        }
        return false;
    };
    EXPECT_FALSE(refused({}));
    EXPECT_FALSE(refused({2}));
    EXPECT_FALSE(refused({0, 1, condition_not, condition_and, 2, condition_or}));
    EXPECT_TRUE(refused({5}));
    EXPECT_TRUE(refused({condition_not}));
    EXPECT_TRUE(refused({0, condition_and}));
    EXPECT_TRUE(refused({0, 1}));
    EXPECT_TRUE(refused({0, 1, -4}));
    EXPECT_TRUE(refused({0, 1, std::numeric_limits<ConditionStep>::min()}));
    std::vector<ConditionStep> deep(32, 0);
    deep.insert(deep.end(), 31, condition_or);
    EXPECT_FALSE(refused(deep));
    deep.insert(deep.begin(), 0);
    deep.push_back(condition_or);
    EXPECT_TRUE(refused(deep));
}

TEST(TexelsOnTheWire, AreReadAsTheyWereWrittenOrRefused) {
    const auto decode_texels = [](const fake::Bytes& frame) {
        const fake::Bytes content(frame.begin() + 4, frame.end());
        return std::get<report::Texels>(decode_report(content));
    };
    const report::Texels read = decode_texels(fake::texels_frame(7, 3, fake::small_texels()));
    EXPECT_EQ(read.image, 7U);
    EXPECT_EQ(read.first, 3U);
    EXPECT_EQ(read.texels, fake::small_texels());
    EXPECT_THROW(decode_texels(fake::raw_texels_frame(0, 0, {})), WireFault);
    EXPECT_THROW(decode_texels(fake::raw_texels_frame(0, 0, {1, 2, 3, 4, 5})), WireFault);
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

TEST_F(GeometryOracleTest, TexelsComeAfterItOnce) {
    PovrayOracle oracle(fake_tracer({"geometry", "texels"}));
    oracle.wait_for_scene(nullptr, nullptr);
    oracle.wait_for_images(nullptr);
    EXPECT_TRUE(oracle.take_geometry());
    const std::vector<ImageTexels> images = oracle.take_images().value();
    ASSERT_EQ(images.size(), 2U);
    for (const ImageTexels& image : images) {
        EXPECT_EQ(image.width, 3U);
        EXPECT_EQ(image.texels, fake::small_texels());
    }
    EXPECT_FALSE(oracle.take_images());
    expect_right(trace(oracle, all_pixels(), Parts::colour), all_pixels(), Parts::colour);
}

TEST_F(GeometryOracleTest, TexelsAreCompleteThoughTheTracerDied) {
    for (const char* how : {"texels=half", "die_after=100"}) {
        PovrayOracle oracle(fake_tracer({"geometry", "texels", how, "once=" + fresh_file()}));
        oracle.wait_for_scene(nullptr, nullptr);
        oracle.wait_for_images(nullptr);
        EXPECT_EQ(oracle.take_images().value().size(), 2U);
        EXPECT_TRUE(oracle.take_geometry());
        expect_right(trace(oracle, all_pixels(), Parts::colour), all_pixels(), Parts::colour);
        EXPECT_EQ(oracle.statistics().restarts, 1U);
        EXPECT_FALSE(oracle.take_images());
    }
}

TEST_F(GeometryOracleTest, TexelsOutOfOrderEndTheTracer) {
    for (const char* how : {"image", "order", "many", "more", "early"}) {
        SCOPED_TRACE(how);
        const std::string text =
            error_of(fake_tracer({"geometry", std::string("texels=") + how}), Exit::tracer);
        EXPECT_NE(text.find("texels"), std::string::npos) << text;
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

TEST(DrawableSceneOfGeometry, HasAllPartsWithTheirIndices) {
    const Geometry both = complete();
    const std::optional<DrawableScene> scene = drawable_scene(both, description());
    ASSERT_TRUE(scene);
    EXPECT_EQ(scene->polygons.faces.size(),
              polygon_scene(both, description()).value().faces.size());
    ASSERT_EQ(scene->corner_uvs.size(), scene->polygons.corners.size());
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_EQ(scene->corner_uvs[scene->polygons.faces[1].first + i],
                  both.corner_uvs[both.rings[1].first + i]);
    ASSERT_EQ(scene->solids.size(), 10U);
    ASSERT_EQ(scene->numbers.size(), 16U);
    EXPECT_EQ(scene->solids[8].first_number, 8U);
    EXPECT_EQ(scene->solids[8].numbers, 8U);
    ASSERT_EQ(scene->pieces.size(), 6U);
    EXPECT_EQ(scene->pieces[4].solid, 6U);
    EXPECT_EQ(scene->pieces[4].first_condition, 9U);
    EXPECT_EQ(scene->conditions[5], 6);
    EXPECT_EQ(scene->conditions[6], condition_not);
    EXPECT_EQ(scene->objects[3].first_piece, 5U);
    EXPECT_EQ(scene->unknown.size(), 2U);
    ASSERT_GE(scene->looks.size(), 4U);
    EXPECT_EQ(scene->looks[0].kind, Look::Kind::mixed);
    EXPECT_EQ(scene->looks[2].kind, Look::Kind::image);
    EXPECT_EQ(scene->looks[3].kind, Look::Kind::traced);
    EXPECT_EQ(scene->images.size(), 2U);
}

TEST(DrawableSceneOfGeometry, LooksOfWhatIsNotThereAreHarmless) {
    Geometry geometry = small_geometry();
    geometry.looks[1].look.image.image = 5;
    geometry.looks[2].material = 0xfffffff0;
    const DrawableScene scene = drawable_scene(geometry, description()).value();
    EXPECT_LE(scene.looks.size(), 5U);
    EXPECT_EQ(scene.looks[2].kind, Look::Kind::traced);
}

TEST(PolygonSceneOfGeometry, PointsThatAreNoNumbersLeaveTheOthersAlone) {
    Geometry geometry = small_geometry();
    geometry.points[13].x = std::numeric_limits<double>::quiet_NaN();
    const std::optional<PolygonScene> scene = polygon_scene(geometry, description());
    ASSERT_TRUE(scene);
    EXPECT_EQ(scene->faces.size(), 2U);
}

TEST(PolygonSceneOfGeometry, OnlyLightsThatCastSharpShadowsOnAll) {
    SceneDescription scene = description();
    scene.lights.resize(5);
    scene.lights[0].shadowless = true;
    scene.lights[1].position = {1, 2, 3};
    scene.lights[1].colour = {.3, .6, .9};
    scene.lights[2].in_group = true;
    scene.lights[3].parallel = true;
    scene.lights[3].position = {0, 9, 0};
    scene.lights[3].points_at = {0, 2, 0};
    scene.lights[4].kind = LightKind::area;
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
