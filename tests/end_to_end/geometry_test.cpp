// SPDX-License-Identifier: AGPL-3.0-or-later
//
// The polygons that the tracer sends against what its rays hit: for every kind of object, in every
// way that POV-Ray lets people put them together.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "adapter/povray_options.h"
#include "tests/end_to_end/geometry_agreement.h"
#include "tests/end_to_end/real_tracer.h"

namespace povpreview {
namespace {

struct GeometryScene {
    const char* name;
    const char* text;
    double on_faces;  ///< share of the probes that must hit surfaces of which there are faces
    std::vector<std::string> left_out;  ///< kinds
    double noise =
        0;  ///< share of the probes for which POV-Ray itself shows this or that by chance
};
void PrintTo(const GeometryScene& scene, std::ostream* out) { *out << scene.name; }

const char* const head = R"(#version 3.7; global_settings { assumed_gamma 1 }
light_source { <5, 8, -5> rgb 1 }
)";
const char* const eye = "camera { location <0, 3, -9> look_at <0, .5, 0> angle 55 }\n";

const GeometryScene scenes[] = {
    {"flat_objects",
     R"(
plane { y, -1 pigment { checker rgb 1 rgb .2 } }
box { <-6,-1,0>, <-5,1,1> rotate 20*y pigment { rgb x } }
box { <0,0,0>, <1,1,0> rotate 30*y translate <-4.8,1.5,1> pigment { rgb <1,.5,0> } }
triangle { <-4,-1,0>, <-3,-1,0>, <-3.5,1,.5> pigment { rgb y } }
smooth_triangle { <-2,-1,0>, <0,0,-1>, <-1,-1,0>, <0,.2,-1>, <-1.5,1,.5>, <.1,.2,-1> }
polygon { 9, <0,0>,<1,0>,<1,1>,<0,1>,<0,0> <.3,.3>,<.6,.3>,<.5,.6>,<.3,.3>
  scale 2 translate <0,-.8,1> pigment { rgb <1,1,0> } }
disc { <-3, 2, 1>, <.2,.3,1>, 1, .4 pigment { rgb <0,1,1> } }
disc { <2, 2.5, 1>, <-.2,.1,1>, .6 pigment { rgb <0,1,.5> } })",
     .5,
     {}},
    {"prisms",
     R"(
prism { linear_sweep linear_spline 0, 1, 7, <0,0>,<1,0>,<1,1>,<.5,.4>,<0,1>,<-.5,.5>,<0,0>
  rotate -30*x scale 1.5 translate <-4,0,0> }
prism { linear_spline linear_sweep 0, 1, 10, <0,0>,<3,0>,<3,3>,<0,3>,<0,0>,
  <1,1>,<2,1>,<2,2>,<1,2>,<1,1> rotate <-70,20,0> translate <-1.5,-1,1> pigment { rgb x } }
prism { linear_spline conic_sweep 0, 1, 5, <1,1>,<-1,1>,<-1,-1>,<1,-1>,<1,1>
  rotate 180*x translate <3,1.5,1> pigment { rgb y } }
prism { linear_spline conic_sweep -1, .6, 4, <1,1>,<-1,1>,<0,-1>,<1,1> open
  rotate 20*z translate <3,-.5,-1> pigment { rgb z } })",
     .1,
     {}},
    {"meshes",
     R"(
mesh { triangle { <-3,0,0>, <-1,0,0>, <-2,2,.5> } triangle { <-1,0,0>, <-3,0,0>, <-2,-1.5,-.8> }
  smooth_triangle { <0,0,0>, <-.1,0,-1>, <1.5,0,0>, <.1,0,-1>, <1,2,1>, <0,.2,-1> }
  smooth_triangle { <3,0,-1>, <.1,0,-1>, <1.5,0,0>, <.1,0,-1>, <1,2,1>, <0,.2,-1> }
  scale <1,1.2,1> rotate 10*z pigment { rgb .5 } }
mesh2 { vertex_vectors { 5, <0,0,0>, <1,0,0>, <1,1,0>, <0,1,0>, <.5,.5,-1> }
  texture_list { 2, texture { pigment { rgb x } }, texture { pigment { rgbt <0,1,0,.5> } } }
  face_indices { 4, <0,1,4>,0, <1,2,4>,1, <2,3,4>,0, <3,0,4>,1 }
  rotate 40*y translate <-1,-2,-2> scale 1.3 })",
     .1,
     {}},
    {"height_fields",
     R"(
height_field { function 24, 20 { pattern { bozo scale .2 } } water_level .35
  translate -.5 scale <5, 1.5, 5> rotate 20*y translate <-2.4,0,2> pigment { rgb y } }
height_field { function 16, 16 { pattern { bozo scale .3 } } smooth
  translate -.5 scale <4, 1.5, 4> translate <2.5,-.5,0> pigment { rgb x } })",
     .1,
     {}},
    {"bicubic_patches",
     R"(
#macro Patch(Type) bicubic_patch { type Type flatness .01 u_steps 3 v_steps 2
  <-2,-1,0>, <-1,-1,1>, <1,-1,-1>, <2,-1,0>, <-2,0,1>, <-1,0,0>, <1,0,2>, <2,0,1>,
  <-2,1,0>, <-1,1,-1>, <1,1,0>, <2,1,0>, <-2,2,1>, <-1,2,0>, <1,2,1>, <2,2,0> #end
Patch(0) translate <-2.3,0,0> } Patch(1) rotate 30*y translate <2.3,0,0> pigment { rgb x } })",
     .1,
     {}},
    {"unions_and_transforms",
     R"(
#declare Part = union { box { 0, 1 } union { box { <.2,1,.2>, <.8,1.6,.8> }
  triangle { <0,1,0>, <1,1,0>, <.5,2,0> } rotate 15*y } }
union { object { Part } object { Part matrix <1,.2,0, 0,1,.3, .1,0,1, 2,-.5,.4> }
  object { Part scale <-1,1.5,1> translate -1.5*x } split_union off rotate 10*z }
plane { z, 6 rotate 30*y } light_group { light_source { <0,5,-5> 1 } box { <2.5,1.5,0>, <3.2,2.2,1> } })",
     .5,
     {}},
    {"csg",
     R"(
difference { box { -1, 1 } box { <-.5,-.5,-2>, <.5,.5,2> } box { <-2,-.3,-.3>, <2,.3,.3> }
  rotate <20,30,0> translate <-3,1.5,1> pigment { rgb <.9,.5,.2> } }
intersection { plane { y, 1 } plane { -y, 1 } plane { x,1 } plane { -x,1 } plane { z,1 }
  plane { <-1,-1,-1>,.4 } rotate <20,30,0> translate <0,2,4> }
merge { box { 0, 1 } box { .5, 1.5 } pigment { rgbt <1,0,0,.5> } rotate 20*y translate <2,1,0> }
difference { prism { linear_spline 0, 1, 6, <0,0>,<2,0>,<2,2>,<1,.5>,<0,2>,<0,0> }
  union { box { <.2,-1,.2>, <.6,2,.6> } prism { linear_spline -1, 2, 4, <1.2,0>,<1.8,.3>,<1.5,1>,<1.2,0> } }
  rotate <-60,10,0> translate <-1,-2,0> pigment { rgb x } }
intersection { merge { box { 0, 2 } box { 1, 3 } } box { .5, 2.5 inverse } scale .6 translate <-4,-1.5,0> }
disc { 0, z, 1 clipped_by { box { <-.3,-2,-1>, <.3,2,1> inverse } } translate <3.5,-.8,1> pigment { rgb y } }
intersection { mesh { triangle { <-1,-1,0>, <1,-1,.5>, <0,1,0> } } box { -.6, .8 } translate <1.5,-1,-1> })",
     .1,
     {}},
    {"coinciding_faces",
     R"(
difference { box { 0, 2 } box { <.5,1,.5>, <1.5,2,1.5> } rotate <-30,20,0> translate <-3,0,0> }
merge { box { 0, 1 } box { <1,0,0>, <2,1,1> } rotate <-30,20,0> pigment { rgbt <1,0,0,.5> } }
intersection { box { 0, 1 } box { <0,0,-1>, <1,1,.5> } rotate <-30,-40,0> translate <2,1.5,0> })",
     .05,
     {},
     .02},
    {"clipped_and_bounded",
     R"(
box { 0, 1.5 clipped_by { plane { <1,1,0>, 1 } } translate <-3,0,0> pigment { rgb x } }
plane { y, -1 clipped_by { box { <-4,-2,-2>, <4,2,6> } } pigment { checker rgb 1 rgb .3 } }
union { box { 0, 1 } triangle { <0,1,0>, <1,1,0>, <.5,2.5,0> } clipped_by { box { <-1,-1,-1>, <.7,1.7,.7> inverse } }
  bounded_by { box { -.01, <1.01,2.51,1.01> } } translate <-.5,0,0> }
mesh { triangle { 0, 2*x, 2*y } triangle { 2*x, 2*y, <2,2,.5> } clipped_by { box { <.3,.2,-1>, <1.7,1.5,1> } }
  translate <1.5,0,0> pigment { rgb z } }
difference { box { 0, 1 } box { .3, .7 scale <1,1,3> } bounded_by { sphere { .5, 2 } } translate <2,2,0> }
union { box { 0, 1 } box { <1.2,0,0>, <2,1,1> } bounded_by { box { -.1, 1.1 } } translate <-3.5,2,0> })",
     .1,
     {"union"}},
    {"seen_by_some",
     R"(
box { -1, 1 no_image translate -2*x } box { -1, 1 no_reflection translate 2*x }
plane { y, -1.5 finish { reflection .4 } }
intersection { box { -1, 1 no_image } plane { <1,1,-1>, .3 } translate <0,1,2> }
union { box { -.5, .5 no_image } box { .2, .8 } translate <0,0,-1> })",
     .3,
     {}},
    {"with_curves",
     R"(
sphere { <-2,0,0>, 1 } cylinder { <0,-1,0>, <0,1,0>, .5 } plane { y, -1 }
difference { box { 1, 3 } sphere { 2, 1.2 } translate -x }
box { 0, 1 clipped_by { sphere { 0, 1 } } translate <-1,1,-2> }
prism { cubic_spline 0, 1, 7, <-1,1>,<0,0>,<1,0>,<1,1>,<0,1>,<0,0>,<1,-1> translate <2,-1,-2> }
light_source { <0, 3, 0> .1 looks_like { box { -.2, .2 } } })",
     .2,
     {"box", "cylinder", "difference", "light_source", "prism", "sphere"}},
};

struct Exported {
    Geometry geometry;
    GeometryAgreement agreement;
};

Exported compare(const std::string& scene_text, std::size_t positions) {
    const WorkFolder folder;
    const PovrayOptions options =
        read_povray_options({folder.write("scene.pov", scene_text), "+W120", "+H90", "+WT2"});
    PovrayOracle oracle({.program = real_tracer(), .arguments = options.tracer_arguments()});
    const SceneDescription description = oracle.wait_for_scene(nullptr, nullptr);
    oracle.wait_for_geometry(nullptr);
    Exported exported;
    exported.geometry = oracle.take_geometry().value();
    const PolygonScene polygons = polygon_scene(exported.geometry, description).value();
    exported.agreement =
        compare_geometry(polygons, probe(oracle, probing_positions(polygons, positions, 1)));
    return exported;
}

class ExportedGeometry : public testing::TestWithParam<GeometryScene> {
   protected:
    void SetUp() override {
        if (real_tracer().empty()) GTEST_SKIP() << "no tracer: POVPREVIEW_TRACER is not set";
    }
    void expect_agreement(const std::string& camera) const {
        const auto [geometry, agreement] =
            compare(std::string(head) + camera + GetParam().text, 3000);
        EXPECT_LE(static_cast<double>(agreement.disagreeing()),
                  GetParam().noise * static_cast<double>(agreement.probes))
            << agreement.missing << " faces missing, " << agreement.in_front << " in front";
        // One probe in a thousand may fall into the hair's breadth where POV-Ray rounds.
        EXPECT_LE(agreement.at_edges, agreement.probes / 1000);
        EXPECT_GE(static_cast<double>(agreement.on_faces),
                  GetParam().on_faces * static_cast<double>(agreement.probes));
        std::set<std::string> left_out;
        for (const Geometry::LeftOut& left : geometry.left_out) left_out.insert(left.kind);
        EXPECT_EQ(std::vector(left_out.begin(), left_out.end()), GetParam().left_out);
    }
};

TEST_P(ExportedGeometry, IsWhatRaysHit) { expect_agreement(eye); }

TEST_P(ExportedGeometry, IsWhatParallelRaysHit) {
    expect_agreement(
        "camera { orthographic location <-4, 5, -9> look_at <0, .5, 0> right 9*x up 6.75*y }\n");
}

INSTANTIATE_TEST_SUITE_P(Scenes, ExportedGeometry, testing::ValuesIn(scenes),
                         [](const auto& scene) { return scene.param.name; });

TEST(ExportedFaces, SayWhatTheirTexturesAndFlagsSay) {
    if (real_tracer().empty()) GTEST_SKIP() << "no tracer: POVPREVIEW_TRACER is not set";
    const Exported exported = compare(std::string(head) + eye + R"(
#declare Red = texture { pigment { rgb x } }
triangle { <0,0,0>, <1,0,0>, <0,1,0> texture { Red } }
triangle { <0,0,1>, <1,0,1>, <0,1,1> pigment { rgb x } }
triangle { <0,0,2>, <1,0,2>, <0,1,2> pigment { rgbt <1,0,0,.5> } no_shadow }
triangle { <0,0,3>, <1,0,3>, <0,1,3> pigment { checker rgb 1 rgbf 1 } double_illuminate }
triangle { <0,0,4>, <1,0,4>, <0,1,4> pigment { rgb y } finish { reflection .6 } no_reflection }
triangle { <0,0,5>, <1,0,5>, <0,1,5> pigment { rgb y } finish { reflection .6 } normal { bumps .3 } }
smooth_triangle { <0,0,6>, z, <1,0,6>, z, <0,1,6>, z finish { reflection .6 } no_image }
triangle { <0,0,7>, <1,0,7>, <0,1,7> texture { pigment { rgbt 1 } } texture { pigment { rgb x } } })",
                                      0);
    const auto& polygons = exported.geometry.polygons;
    ASSERT_EQ(polygons.size(), 8U);
    const auto face = [&](std::size_t i) { return polygons[i].face; };
    EXPECT_EQ(face(0).material, face(1).material);
    EXPECT_NE(face(0).surface, face(1).surface);
    std::set<std::uint32_t> materials;
    for (std::size_t i = 1; i < 8; ++i) materials.insert(face(i).material);
    EXPECT_EQ(materials.size(), 7U);
    for (std::size_t i = 0; i < 8; ++i) {
        SCOPED_TRACE(testing::Message() << "triangle " << i);
        EXPECT_EQ(face(i).transparent, i == 2 || i == 3);
        EXPECT_EQ(face(i).casts_shadow, i != 2);
        EXPECT_EQ(face(i).lit_from_behind, i == 3);
        EXPECT_EQ(face(i).reflected, i != 4);
        EXPECT_NEAR(face(i).mirror, i == 4 ? .6 : 0, 1e-6);
        EXPECT_EQ(face(i).visible, i != 6);
        EXPECT_EQ(face(i).smooth != 0, i == 6);
    }
}

}  // namespace
}  // namespace povpreview
