// SPDX-License-Identifier: AGPL-3.0-or-later
//
// What the tracer says of materials against the albedo that its rays bring: an image look must give
// the same at every pixel, a plain look one albedo all over; and which textures are of which kind.
#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <map>
#include <set>

#include "adapter/povray_options.h"
#include "core/detail/item_painter.h"
#include "tests/end_to_end/look_agreement.h"
#include "tests/end_to_end/real_tracer.h"

namespace povpreview {
namespace {

struct Sampled {
    Geometry geometry;
    DrawableScene scene;
    std::vector<Sample> samples;  ///< albedo rays
    std::vector<Seen> seen;       ///< where they are
};

Sampled sample(const WorkFolder& folder, const std::string& text) {
    const PovrayOptions options =
        read_povray_options({folder.write("scene.pov", text), "+W160", "+H120", "+WT2"});
    PovrayOracle oracle({.program = real_tracer(), .arguments = options.tracer_arguments()});
    const SceneDescription description = oracle.wait_for_scene(nullptr, nullptr);
    oracle.wait_for_geometry(nullptr);
    oracle.wait_for_images(nullptr);
    Sampled result;
    result.geometry = oracle.take_geometry().value();
    result.scene = drawable_scene(result.geometry, description).value();
    result.scene.images = oracle.take_images().value();
    std::vector<Request> requests;
    std::vector<glm::dvec2> positions;
    for (int y = 0; y < description.height; ++y)
        for (int x = 0; x < description.width; ++x) {
            positions.push_back({x + .5, y + .5});
            requests.push_back({positions.back(), RayKind::albedo});
        }
    oracle.submit(requests, Parts::surface);
    while (result.samples.size() < requests.size())
        oracle.collect(result.samples, std::chrono::milliseconds(20));
    result.seen = seen_at(result.scene, positions);
    return result;
}

const char* const head = R"(#version 3.7; global_settings { assumed_gamma 1 }
camera { location <0, 3, -9> look_at <0, .5, 0> angle 55 } light_source { <5, 8, -5> rgb 1 }
#macro Image(W, H) image_map { function W, H { pigment { bozo scale .3
  color_map { [0 rgb <1,.2,0>] [.5 rgb <.1,.9,.3>] [1 rgb <0,.1,1>] } } } #end
)";

struct ImageScene {
    const char* name;
    const char* text;
    double share;    ///< of the pixels, at least, is of images
    double outside;  ///< of the pixels, at least, is outside of images used once
};
void PrintTo(const ImageScene& scene, std::ostream* out) { *out << scene.name; }

const ImageScene image_scenes[] = {
    {"planar",
     R"(plane { y, -1 pigment { Image(13, 9) } rotate 90*x scale 3 rotate 20*y } }
box { <-3,0,0>, <-1,2,1> pigment { Image(16, 16) interpolate 2 } translate <.3,.2,0> } rotate 30*y }
sphere { <2,1,0>, 1 pigment { Image(8, 5) interpolate 4 } scale <.7,.4,1> rotate 30*z } }
cylinder { <0,-1,-2>, <0,1,-2>, .5 pigment { Image(8, 5) interpolate 3 } } scale <2,1,1> })",
     .5, 0},
    {"round",
     R"(sphere { 0, 1.3 pigment { Image(20, 12) map_type 1 interpolate 2 } rotate 40*y } translate <-3,1,0> }
cylinder { -y, y, 1 pigment { Image(20, 12) map_type 2 } translate -y/3.1 } rotate 20*x translate <0,1,0> }
torus { 1, .4 pigment { Image(20, 12) map_type 5 interpolate 3 } rotate 10*y } rotate -60*x translate <3,1,0> }
box { -1, 1 pigment { Image(9, 9) map_type 1 } translate <.1,.2,.3> } translate <0,-2,1> })",
     .15, 0},
    {"once",
     R"(plane { y, -1 pigment { Image(13, 9) once interpolate 2 } rotate 90*x translate <-.5,0,-.5> scale 6 } }
box { <-3,0,0>, <-1,2,1> pigment { Image(16, 16) once } translate <-3,.5,0> } rotate 30*y })",
     .1, .1},
    {"own_coordinates",
     R"(mesh2 { vertex_vectors { 4, <-3,-1,0>, <3,-1,2>, <3,3,2>, <-3,3,0> }
  uv_vectors { 5, <0,0>, <2,.2>, <2,2>, <.3,2>, <.5,.5> }
  face_indices { 2, <0,1,2>, <0,2,3> } uv_indices { 2, <0,1,2>, <4,2,3> }
  uv_mapping pigment { Image(16, 12) interpolate 2 } scale <.5,.7,1> rotate 20*z } }
mesh { triangle { <-4,-1,-2>, <0,-1,-2>, <-2,1,-2> uv_vectors <0,0>, <1,0>, <.5,1> }
  uv_mapping pigment { Image(7, 7) } } })",
     .3, 0},
};

class ImageLooks : public testing::TestWithParam<ImageScene> {
   protected:
    void SetUp() override {
        if (real_tracer().empty()) GTEST_SKIP() << "no tracer: POVPREVIEW_TRACER is not set";
    }
    static void expect_agreement(const std::string& start) {
        const WorkFolder folder;
        const Sampled all = sample(folder, start + GetParam().text);
        std::size_t on_images = 0, outside = 0, wrong = 0;
        std::string examples;
        for (std::size_t i = 0; i < all.samples.size(); ++i) {
            const Sample& traced = all.samples[i];
            const Seen& seen = all.seen[i];
            if (seen.surface == 0 || seen.surface != traced.surface ||
                all.scene.looks.at(seen.material).kind != Look::Kind::image)
                continue;
            const auto albedo = image_albedo(all.scene, seen);
            on_images += albedo.has_value();
            outside += !albedo;
            const glm::dvec3 said = albedo.value_or(glm::dvec3(0));
            if (glm::distance(said, glm::dvec3(traced.albedo)) <= 2e-3) continue;
            if (++wrong <= 5)
                examples += "\n(" + std::to_string(traced.position.x) + ", " +
                            std::to_string(traced.position.y) + ") " +
                            std::to_string(traced.albedo.x) + " said " + std::to_string(said.x);
        }
        const auto pixels = static_cast<double>(all.samples.size());
        // Borders between texels may lie anywhere, also on a pixel's centre.
        EXPECT_LE(wrong, on_images / 1000) << on_images << examples;
        EXPECT_GE(static_cast<double>(on_images), GetParam().share * pixels);
        EXPECT_GE(static_cast<double>(outside), GetParam().outside * pixels);
    }
};

TEST_P(ImageLooks, GiveTheAlbedoOfRays) { expect_agreement(head); }

TEST_P(ImageLooks, GiveTheAlbedoOfRaysInAnotherGamma) {
    std::string start = head;
    start.replace(start.find("assumed_gamma 1"), 15, "assumed_gamma 2.2");
    expect_agreement(start);
}

INSTANTIATE_TEST_SUITE_P(Scenes, ImageLooks, testing::ValuesIn(image_scenes),
                         [](const auto& scene) { return scene.param.name; });

const ImageScene pattern_scenes[] = {
    {"checkers",
     R"(plane { y, 0 pigment { checker rgb <1,.2,.1> rgb <.1,.4,.9> } }
sphere { <2,1,0>, 1 pigment { checker rgb x rgb y scale .3 rotate <10,20,30> } translate .1 }
box { <-3,0,0>, <-1,2,1> pigment { checker pigment { rgb .9 } pigment { rgb <.2,.3,.1> } scale <.5,.2,1> } rotate 30*y }
box { <-1,.5,-3>, <1,1,-2.5> texture { checker texture { pigment { rgb .5 } } texture { pigment { rgb <.9,.1,0> } } scale .25 rotate 45*y } })",
     .6, 0},
    {"bricks",
     R"(plane { y, 0 texture { pigment { brick rgb .5 rgb <.7,.2,.1> scale .2 } rotate 20*y } }
sphere { <2,1,0>, 1 pigment { brick brick_size <1,.4,.5> mortar .1 rotate 30*z } scale <1,1.2,1> }
box { <-3,0,0>, <-1,2,1> pigment { brick rgb .8 rgb <.5,.1,.1> scale .1 } rotate 30*y }
box { <-1,.5,-3>, <1,1,-2.5> texture { brick texture { pigment { rgb .5 } }, texture { pigment { rgb <.9,.1,0> } } scale .05 } translate .03*x })",
     .6, 0},
    {"hexagons",
     R"(plane { y, 0 pigment { hexagon rgb <1,.2,.1> rgb <.1,.4,.9> rgb <.1,.9,.1> } }
sphere { <2,1,0>, 1 pigment { hexagon rgb x rgb y scale .2 rotate <10,20,30> } translate .1 }
box { <-3,0,0>, <-1,2,1> pigment { hexagon rgb .9 rgb .5 rgb <.2,.3,.1> scale .2 rotate 80*x } rotate 30*y }
box { <-1,.5,-3>, <1,1,-2.5> texture { hexagon texture { pigment { rgb .5 } } texture { pigment { rgb <.9,.1,0> } } texture { pigment { rgb <.1,0,.9> } } scale .1 rotate -90*x } })",
     .6, 0},
};

/// The item buffer against albedo rays at every pixel.
class PatternLooks : public testing::TestWithParam<ImageScene> {
   protected:
    void SetUp() override {
        if (real_tracer().empty()) GTEST_SKIP() << "no tracer: POVPREVIEW_TRACER is not set";
    }
    static void expect_agreement(const std::string& start) {
        const WorkFolder folder;
        const Sampled all = sample(folder, start + GetParam().text);
        const ItemBuffer items = paint_items(all.scene);
        std::size_t on_patterns = 0, right = 0;
        std::set<std::uint32_t> surfaces;
        for (const Sample& traced : all.samples) {
            const auto pixel = static_cast<std::size_t>(traced.position.y) *
                                   static_cast<std::size_t>(items.width) +
                               static_cast<std::size_t>(traced.position.x);
            EXPECT_NE(items.kinds[pixel], Look::Kind::traced);
            if (items.kinds[pixel] != Look::Kind::pattern ||
                items.surfaces[pixel] != traced.surface)
                continue;
            surfaces.insert(traced.surface);
            ++on_patterns;
            const bool agrees = glm::distance(items.albedos[pixel], traced.albedo) < 1e-5f;
            right += agrees;
            EXPECT_TRUE(agrees || on_patterns - right > 5)
                << traced.position.x << ", " << traced.position.y;
        }
        EXPECT_EQ(right, on_patterns);
        EXPECT_GE(static_cast<double>(on_patterns),
                  GetParam().share * static_cast<double>(all.samples.size()));
        EXPECT_GE(surfaces.size(), 4U);
    }
};

TEST_P(PatternLooks, GiveTheAlbedoOfRays) { expect_agreement(head); }

TEST_P(PatternLooks, GiveTheAlbedoOfRaysInAnotherGamma) {
    std::string start = head;
    start.replace(start.find("assumed_gamma 1"), 15, "assumed_gamma 2.2");
    expect_agreement(start);
}

TEST_P(PatternLooks, GiveTheAlbedoOfRaysInOldScenes) {
    std::string start = head;
    const std::string settings = "#version 3.7; global_settings { assumed_gamma 1 }";
    start.replace(start.find(settings), settings.size(), "#version 3.6;");
    expect_agreement(start);
}

INSTANTIATE_TEST_SUITE_P(Scenes, PatternLooks, testing::ValuesIn(pattern_scenes),
                         [](const auto& scene) { return scene.param.name; });

TEST(Looks, OfTexturesAreWhatTheyShouldBe) {
    if (real_tracer().empty()) GTEST_SKIP() << "no tracer: POVPREVIEW_TRACER is not set";
    using enum Look::Kind;
    const std::pair<const char*, Look::Kind> textures[] = {
        {"pigment { rgb x }", plain},
        {"pigment { rgbt <1,0,0,.5> }", mixed},
        {"texture { pigment { rgb x } } texture { pigment { rgbt <0,1,0,.6> } finish { phong 1 } }",
         plain},
        {"texture { pigment { rgbt .5 } } texture { pigment { rgbt <0,1,0,.6> } }", mixed},
        {"texture { pigment { rgb x } } texture { pigment { bozo color_map { [0 rgbt 1] [1 rgb y] "
         "} } }",
         traced},
        {"texture { pigment { rgb x } } texture { pigment { bozo color_map { [0 rgbt 1] [1 rgb y] "
         "} } "
         "finish { reflection .5 } }",
         mixed},
        {"pigment { checker rgb 1 rgb 0 }", pattern},
        {"pigment { checker pigment { rgb x } pigment { rgb y } rotate 10*x }", pattern},
        {"pigment { checker pigment { rgb x } pigment { wood } }", traced},
        {"pigment { checker rgb 1 rgb 0 turbulence .2 }", traced},
        {"pigment { hexagon rgb 1 rgb 0 rgb x frequency 2 }", traced},
        {"pigment { checker rgb 1 rgb 0 warp { repeat x flip x } }", traced},
        {"pigment { checker rgb 1 rgb 0 quick_color rgb x }", traced},
        {"uv_mapping pigment { checker rgb 1 rgb 0 }", traced},
        {"texture { pigment { brick rgb 1 rgb x } normal { bumps .3 } finish { specular .4 } }",
         pattern},
        {"texture { hexagon texture { pigment { rgb x } } texture { pigment { rgb y } } texture { "
         "pigment { rgb z } } scale .1 }",
         pattern},
        {"texture { checker texture { pigment { rgb x } }, texture { pigment { wood } } }", traced},
        {"texture { pigment { checker rgb 1 rgb 0 } } texture { pigment { rgbt .5 } }", traced},
        {"pigment { marble turbulence 1 } normal { bumps .4 } finish { specular .4 }", traced},
        {"pigment { checker rgb 1 rgbt <1,1,1,.5> }", mixed},
        {"pigment { checker rgb 1 rgb x } finish { metallic specular .5 }", mixed},
        {"pigment { average pigment_map { [1 wood] [2 rgb x] } }", traced},
        {"texture { checker texture { pigment { rgb x } }, texture { pigment { rgb y } } }",
         pattern},
        {"texture { checker texture { pigment { rgb x } }, texture { pigment { rgb y } finish { "
         "reflection .5 } } }",
         mixed},
        {"texture { pigment { rgb x } } interior_texture { pigment { rgb y } }", mixed},
        {"pigment { Image(8, 8) } }", image},
        {"pigment { Image(8, 8) } warp { turbulence .3 } }", traced},
        {"pigment { Image(8, 8) transmit all .5 } }", mixed},
        {"uv_mapping pigment { Image(8, 8) } }", traced},
        {"texture { pigment { Image(8, 8) } } } texture { pigment { rgbt <1,0,0,.5> } }", traced},
    };
    std::string text = head;
    int x = 0;
    for (const auto& [texture, kind] : textures)
        text += "box { <0,0,0>, <.2,.5,1> translate " + std::to_string(x++) + "*x*.3-2.8*x " +
                texture + " }\n";
    const WorkFolder folder;
    const Sampled all = sample(folder, text);
    ASSERT_EQ(all.geometry.polygons.size(), 6 * std::size(textures));
    std::map<std::uint32_t, glm::vec3> albedo;
    for (std::size_t i = 0; i < std::size(textures); ++i) {
        const Look& look = all.scene.looks.at(all.geometry.polygons[6 * i].face.material);
        EXPECT_EQ(static_cast<int>(look.kind), static_cast<int>(textures[i].second))
            << textures[i].first;
    }
    std::size_t compared = 0;
    for (std::size_t i = 0; i < all.samples.size(); ++i) {
        const Seen& seen = all.seen[i];
        if (seen.surface == 0 || seen.surface != all.samples[i].surface ||
            all.scene.looks.at(seen.material).kind != plain)
            continue;
        const auto [known, is_new] = albedo.try_emplace(seen.material, all.samples[i].albedo);
        EXPECT_LT(glm::distance(known->second, all.samples[i].albedo), 1e-5);
        compared += !is_new;
    }
    EXPECT_GT(compared, 100U);
}

TEST(Looks, ImagesTooLargeAreLeftToBeTraced) {
    if (real_tracer().empty()) GTEST_SKIP() << "no tracer: POVPREVIEW_TRACER is not set";
    const WorkFolder folder;
    const Sampled all = sample(folder, std::string(head) + R"(
box { 0, 1 pigment { Image(3000, 2600) } } } box { 2, 3 pigment { Image(1000, 900) } } }
box { -2, -1 pigment { Image(400, 300) } } })");
    ASSERT_EQ(all.scene.images.size(), 2U);
    EXPECT_EQ(all.scene.images[0].texels.size(), 7800000U);
    EXPECT_EQ(all.scene.images[1].texels.size(), 120000U);
    EXPECT_EQ(all.scene.looks.at(all.geometry.polygons[6].face.material).kind, Look::Kind::traced);
    ASSERT_EQ(all.geometry.left_out.size(), 1U);
    EXPECT_EQ(all.geometry.left_out[0].kind, "image_map");
    EXPECT_EQ(all.geometry.left_out[0].reason, "larger than 8 million texels");
}

}  // namespace
}  // namespace povpreview
