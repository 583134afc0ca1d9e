// SPDX-License-Identifier: AGPL-3.0-or-later
//
// The curved pieces that the tracer sends, evaluated without haste, against what its rays hit: for
// every primitive that has a closed form, in every way that POV-Ray lets people put them together.
#include <gtest/gtest.h>

#include "adapter/povray_options.h"
#include "tests/end_to_end/drawable_agreement.h"
#include "tests/end_to_end/real_tracer.h"

namespace povpreview {
namespace {

struct CurvedScene {
    const char* name;
    const char* text;
    double known, curved;  ///< shares of the probes, at least
    /// Share of the known probes where POV-Ray itself shows this or that by chance.
    double noise = 0;
};
void PrintTo(const CurvedScene& scene, std::ostream* out) { *out << scene.name; }

const char* const head = R"(#version 3.7; global_settings { assumed_gamma 1 }
light_source { <5, 8, -5> rgb 1 }
)";
const char* const eye = "camera { location <0, 3, -9> look_at <0, .5, 0> angle 55 }\n";

const CurvedScene scenes[] = {
    {"spheres_and_ellipsoids",
     R"(
plane { y, -1 }
sphere { <-3,0,0>, 1 }
sphere { 0, 1 scale <1,.4,2> rotate <20,30,40> translate <0,1,0> pigment { rgb x } }
sphere { <.5,0,0>, .8 matrix <1,.3,0, -.2,1,.4, .1,0,1, 3,.2,1> }
sphere { <1,1,1>, .7 rotate 40*y translate <-2,1,0> } sphere { <-1,2.5,2>, 1 inverse })",
     1, .1},
    {"cylinders_and_cones",
     R"(
plane { y, -1.5 }
cylinder { <-4,-1,0>, <-4,1,.5>, .6 } cylinder { <-2,-1,0>, <-2,1,-1>, .6 open }
cylinder { 0, y, 1 scale <.5,1.5,1> rotate <50,10,0> translate <0,1.5,0> pigment { rgb x } }
cone { <2,-1,0>, 1, <2,1,0>, .3 } cone { <4,-1,0>, .8, <4,1.5,0>, 0 }
cone { <0,-1,-2>, .2, <.2,0,-2>, .7 open } cone { <2,2,1>, .9, <3.5,2.5,0>, .4 open }
cone { <-2.5,2,0>, 0, <-2,3.5,-.5>, .7 open scale <1,1,.5> })",
     1, .1},
    {"tori_and_quadrics",
     R"(
plane { y, -2 }
torus { 1, .3 rotate <50,0,20> translate <-3,0,0> } torus { 2, .25 scale <.5,1,.5> rotate -70*x }
torus { .5, .45 rotate 30*x translate <3,1,0> pigment { rgb x } }
quadric { <1,2,.5>, <0,.3,0>, <0,0,0>, -1 scale .7 rotate 30*z translate <3,-1,0> }
quadric { <1,-1,1>, <0,0,0>, <0,0,0>, -.2 clipped_by { box { -1, 1 } } translate <-1,2,1> }
quadric { <1,0,1>, <0,0,0>, <0,-1,0>, 0 clipped_by { plane { y, 1 } } scale .8 translate <0,-1.7,-3> })",
     1, .1},
    {"planes_boxes_and_discs_cut_by_curves",
     R"(
plane { y, -1 clipped_by { cylinder { -2*y, y, 4 } } }
difference { box { -1, 1 } sphere { 0, 1.25 } rotate <20,30,0> translate <-3,1,1> pigment { rgb x } }
intersection { box { -1, 1 } sphere { 0, 1.3 } plane { <1,1,-1>, .4 } rotate 20*y translate <3,1,1> }
box { 0, 1.5 clipped_by { sphere { 0, 1.4 inverse } } rotate -10*y translate <-.5,1,0> pigment { rgb y } }
disc { <0,0,-2>, <.1,1,-.3>, 1.5, .5 clipped_by { sphere { <.5,0,-2>, 1.2 } } }
plane { z, 6 clipped_by { torus { 3, 1 rotate 90*x translate 6*z } } pigment { rgb z } })",
     1, .1},
    {"nested_csg",
     R"(
plane { y, -2 }
difference { sphere { 0, 1.5 } union { cylinder { -2*x, 2*x, .6 } cylinder { -2*y, 2*y, .6 }
  difference { cylinder { -2*z, 2*z, .6 } box { <-2,-.2,-2>, <2,.2,2> } } }
  rotate <30,40,0> translate <-2.5,1,0> pigment { rgb x } }
intersection { union { sphere { -.5*x, 1 } sphere { .5*x, 1 inverse } } merge { box { -1, .5 } torus { .9, .3 } }
  object { difference { cylinder { -2*y, 2*y, 1.2 } cone { -y, 1, y, 0 } } inverse } inverse
  bounded_by { sphere { 0, 3 } } translate <8,0,30> }
difference { cone { -y, 1.5, y, .5 } merge { sphere { <.5,.2,-1>, .7 } sphere { <-.5,.2,-1>, .7 } }
  torus { 1, .25 } rotate 15*z translate <2.5,0,0> pigment { rgb y } }
difference { union { sphere { 0, .8 } cylinder { 0, <1.5,.5,0>, .4 } } union { sphere { -.5*z, .6 } box { 0, 1 } }
  inverse inverse translate <0,-1,-3> })",
     .9, .1},
    {"merges",
     R"(
plane { y, -1.5 pigment { rgb z } }
#declare Glass = texture { pigment { rgbt <1,.9,.8,.8> } }
merge { sphere { -.6*x, 1 } sphere { .6*x, 1 } cylinder { -2*x, 2*x, .5 } texture { Glass } translate <-2,1,0> }
merge { torus { 1, .4 } cylinder { -y, y, .8 } clipped_by { plane { -z, .2 } } rotate 20*x translate <2.5,.5,0> }
difference { merge { sphere { 0, 1 } cone { 0, .9, 2*y, 0 } } merge { sphere { -z, .7 } sphere { <.5,.5,-1>, .4 } }
  translate <.2,-1,-2> })",
     1, .1},
    {"clipped_at_each_level",
     R"(
plane { y, -2 }
union { sphere { -x, 1 clipped_by { plane { y, .3 } } } cylinder { -y, y, .5 open }
  difference { box { <.6,-1,-1>, <2,1,1> } sphere { <1.2,0,-1>, .8 } clipped_by { plane { <1,1,0>, 1.3 } } }
  clipped_by { sphere { 0, 1.6 } plane { -z, 1.2 } } translate <-2,1,0> pigment { rgb x } }
sphere { 0, 1.2 clipped_by { difference { box { -2, 2 } cylinder { -3*z, 3*z, .7 } } } translate <2,1,0> }
intersection { sphere { 0, 1 } object { union { plane { y, 0 } sphere { .5*y, .4 } } clipped_by { plane { x, .6 } } }
  translate <0,-.5,-3> pigment { rgb y } }
sphere { <4,0,0>, 1 clipped_by { sphere { <4,0,-1>, .8 inverse } } bounded_by { clipped_by } })",
     1, .1},
    {"text",
     R"(
plane { y, -1 pigment { rgb z } }
text { ttf "timrom.ttf" "&8Rg" .3, 0 scale 2.2 translate <-3.4,.2,0> pigment { rgb x } }
text { ttf "crystal.ttf" "a8@" .4, .1*x scale 1.5 rotate <30,-40,10> translate <1.5,1,0> }
difference { box { <-3,-1,-1.5>, <3,.3,-1> } text { ttf "cyrvetic.ttf" "eBa" .5, 0
  translate <-1,-.7,-1.7> } texture { pigment { rgb y } } }
intersection { sphere { 0, 1 } text { ttf "timrom.ttf" "S" 4, 0 scale 2 translate <-.5,-.6,-2> inverse }
  translate <3.2,0,-2> })",
     1, .1, 5e-4},  // where the chords that stand for curves here are not fine enough
    {"prisms",
     R"(
#declare Curve = prism { cubic_spline -.5, .6, 7, <.2,-1>, <.9,-.3>, <.5,.8>, <-.8,.6>, <-.6,-.7>, <.9,-.3>, <.5,.8> }
#declare Bezier = prism { bezier_spline conic_sweep .3, 1, 8, <-.5,-.5>, <-.9,.3>, <.1,.9>, <.5,.5>,
  <.5,.5>, <.9,-.2>, <.2,-.8>, <-.5,-.5> }
plane { y, -1.5 }
object { Curve rotate <-50,20,10> translate <-2.5,1,0> pigment { rgb x } }
object { Bezier scale 1.5 rotate <-30,20,0> translate <0,.5,0> pigment { rgb y } }
prism { quadratic_spline -.4, .4, 7, <.6,-.6>, <.5,.5>, <-.5,.6>, <-.8,-.1>, <-.3,-.8>, <.6,-.6>, <.5,.5>
  open rotate <-60,0,20> translate <2.2,1.5,0> }
prism { linear_spline conic_sweep -1, .8, 4, <-1,-.6>, <1,-.5>, <.1,.9>, <-1,-.6> translate <2.8,-.5,0> }
difference { object { Curve } object { Bezier scale 1.4 translate <.1,-.9,0> } cylinder { -y, y, .2 }
  rotate -40*x translate <-1.2,-.8,-3> })",
     1, .1},
    {"turned_and_swollen",
     R"(
plane { y, -1.5 }
lathe { cubic_spline 7, <0,-1>, <.1,-.9>, <.8,-.5>, <.3,.1>, <.7,.8>, <.5,1>, <.4,1.1> rotate -20*x
  translate <-3,.5,0> pigment { rgb x } }
lathe { bezier_spline 4, <.2,-.5>, <1.4,-.4>, <.05,.6>, <.5,.8> rotate <60,0,20> translate <-1,1.5,0> }
lathe { linear_spline 5, <.3,0>, <.9,.2>, <.6,.5>, <.9,.9>, <.3,0> translate <-.8,-1.4,-1> }
sor { 6, <0,-.9>, <.3,-.8>, <.5,-.2>, <.2,.3>, <.5,.8>, <.5,1> rotate <-30,0,20> translate <-2,-.9,-2> }
sor { 4, <.2,-.5>, <.2,-.4>, <.4,.3>, <.4,.4> open rotate 60*x translate <.3,2.6,0> }
superellipsoid { <.3,.3> rotate <20,30,0> translate <1.2,1.2,0> pigment { rgb y } }
superellipsoid { <1,.2> scale .8 rotate <-60,30,0> translate <3.4,1,0> }
superellipsoid { <1.5,.7> scale .8 rotate <20,0,50> translate <1.5,-.6,-1> }
difference { superellipsoid { <.2,.2> scale .8 } lathe { quadratic_spline 4, <.2,-1>, <.3,-.9>, <.6,0>, <.2,.9> }
  sor { 4, <.1,-1.2>, <.2,-1>, <.3,1>, <.3,1.2> rotate 90*x } rotate <30,20,0> translate <3.2,-.5,-1> })",
     1, .1},
    {"blobs",
     R"(
plane { y, -1.5 }
blob { threshold .6 sphere { <-.5,0,0>, 1, 1 } sphere { <.6,.2,0>, 1.1, .9 } cylinder { <0,-1,0>, <.3,1,.4>, .6, 1.3 }
  sphere { <.2,.3,-.6>, .7, -1.2 } translate <-2,.8,0> pigment { rgb x } }
blob { threshold .5 sphere { 0, 1, 1 scale <1.5,.6,1> rotate 30*z } cylinder { -x, x, .5, 1 rotate 60*y }
  scale .9 rotate <20,0,-30> translate <1.2,1,0> }
difference { blob { threshold .4 sphere { 0, 1, 1 } sphere { <.8,.3,0>, .9, 1 } } sphere { <.3,.2,-.7>, .6 }
  box { -2, <2,-.3,2> } translate <2.6,-.4,-1> pigment { rgb y } })",
     1, .05},
    {"unions_beside_what_is_unknown",
     R"(
plane { y, -1 }
union { sphere { 0, 1 } julia_fractal { <-.1,.7,0,-.2> quaternion max_iteration 5 translate 2*x }
  cylinder { <-3,-1,0>, <-3,1,0>, .5 } bounded_by { box { -4, 4 } } translate -z }
intersection { sphere { <-1,2,0>, 1 } isosurface { function { x*x+y*y+z*z-1 } contained_by { box { -1, 1 } }
  translate <-1,2.5,0> } }
light_source { <3, 2, 0> .1 looks_like { sphere { 0, .3 } } } torus { .3, .6 translate <3,3,0> })",
     .4, .05},
    {"seen_by_some",
     R"(
plane { y, -1 } sphere { <-2,0,0>, 1 no_image } sphere { <-2,.5,1>, .8 } torus { 1, .3 no_reflection }
union { sphere { <2,0,0>, 1 } cylinder { <2,0,0>, <2,2,0>, .3 } no_image } cone { <3,-1,2>, 1, <3,2,2>, 0 }
difference { sphere { <0,2,0>, 1 } box { <0,0,-3>, <3,4,3> no_image } })",
     1, .05},
    {"many_faces_are_pieces",
     R"(
#declare Pin = box { <-.02,-3,-.02>, <.02,3,.02> }
difference { box { -1, 1 } union { #for (I, -5, 5) #for (J, -5, 5)
  object { Pin rotate <7*I,0,3*J> translate <.17*I,0,.17*J> } #end #end } rotate <30,20,0> }
plane { y, -3 })",
     .3, 0},
};

class CurvedGeometry : public testing::TestWithParam<CurvedScene> {
   protected:
    void SetUp() override {
        if (real_tracer().empty()) GTEST_SKIP() << "no tracer: POVPREVIEW_TRACER is not set";
    }
    static void expect_agreement(const std::string& camera) {
        const WorkFolder folder;
        const PovrayOptions options = read_povray_options(
            {folder.write("scene.pov", head + camera + GetParam().text), "+W120", "+H90", "+WT2"});
        PovrayOracle oracle({.program = real_tracer(), .arguments = options.tracer_arguments()});
        const SceneDescription description = oracle.wait_for_scene(nullptr, nullptr);
        oracle.wait_for_geometry(nullptr);
        const Geometry geometry = oracle.take_geometry().value();
        const DrawableScene scene = drawable_scene(geometry, description).value();
        const DrawableAgreement agreement =
            compare_drawable(scene, probe(oracle, probing_positions(scene.polygons, 3000, 1)));
        std::string examples;
        for (const DrawableAgreement::Example& e : agreement.examples)
            examples += "\n(" + std::to_string(e.position.x) + ", " + std::to_string(e.position.y) +
                        ") hit " + std::to_string(e.hit) + " at " + std::to_string(e.hit_depth) +
                        ", said " + std::to_string(e.said) + " at " + std::to_string(e.said_depth);
        for (const Geometry::LeftOut& left : geometry.left_out)
            examples +=
                "\nleft out " + left.kind + ": " + left.reason + (left.drawn ? " (drawn)" : "");
        EXPECT_LE(agreement.wrong_share(), GetParam().noise)
            << agreement.wrong << " of " << agreement.known() << examples;
        EXPECT_LE(agreement.at_edges + agreement.tied, 2 + agreement.probes / 500) << examples;
        EXPECT_GE(agreement.known_share(), GetParam().known) << examples;
        EXPECT_GE(DrawableAgreement::share(agreement.curved, agreement.probes), GetParam().curved);
    }
};

TEST_P(CurvedGeometry, IsWhatRaysHit) { expect_agreement(eye); }

TEST_P(CurvedGeometry, IsWhatParallelRaysHit) {
    expect_agreement(
        "camera { orthographic location <-4, 5, -9> look_at <0, .5, 0> right 9*x up 6.75*y }\n");
}

INSTANTIATE_TEST_SUITE_P(Scenes, CurvedGeometry, testing::ValuesIn(scenes),
                         [](const auto& scene) { return scene.param.name; });

}  // namespace
}  // namespace povpreview
