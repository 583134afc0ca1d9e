// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Shapes and positions in which something vanishes or coincides.
#include "tests/stability/series.h"

namespace povpreview::stability {

std::vector<Series> degenerate_series() {
    return {
        {"degenerate",
         "needles",
         "triangles without area to speak of",
         "width of a needle",
         {1e-9, 1e-3},
         {1e-7, 1e-5, 1e-2, 1e-1},
         R"(
camera { location <0, 1, -5> look_at <0, 1, 0> }
light_source { <5, 8, -6>, 1 }
plane { y, 0 pigment { rgb <.9, .8, .7> } }
#declare R = seed(7);
mesh {
  #for (I, 1, 40)
    #local A = <4 * rand(R) - 2, 2 * rand(R), 2 * rand(R) - 1>;
    #local B = <4 * rand(R) - 2, 2 * rand(R), 2 * rand(R) - 1>;
    triangle { A, B, B + K * <rand(R), rand(R), 0> }
  #end
  pigment { rgb <1, .3, .2> }
})"},
        {"degenerate",
         "flat_triangles",
         "triangles of no area among others",
         "triangles of no area",
         {50},
         {1, 1000},
         R"(
camera { location <0, 1, -5> look_at <0, 1, 0> }
light_source { <5, 8, -6>, 1 }
#declare R = seed(3);
mesh {
  triangle { <-2, 0, 0>, <2, 0, 0>, <0, 2, 1> }
  #for (I, 1, K)
    #local A = <4 * rand(R) - 2, 2 * rand(R), 0>; #local B = <4 * rand(R) - 2, 2 * rand(R), 0>;
    triangle { A, B, (A + B) / 2 } triangle { A, A, B } triangle { A, A, A }
  #end
  pigment { rgb <1, .3, .2> }
})"},
        {"degenerate",
         "nearly_coincident",
         "which of two faces is in front",
         "gap between them",
         {0, 1e-9, 1e-4},
         {1e-12, 1e-6, 1e-2},
         R"(
camera { location <1, 2, -6> look_at <0, .5, 0> }
light_source { <5, 8, -6>, 1 }
box { <-2, -1, -2>, <1, 0, 2> pigment { rgb <.9, .8, .7> } }
box { <-1, -1, -1>, <2, K, 1> pigment { rgb <.3, .5, 1> } }
box { <-1, 0, 0>, <0, 1, 1> pigment { rgb <1, .3, .2> } }
box { <K, 0, 0>, <1, 1.2, 1> pigment { rgb <.4, .8, .3> } }
disc { <0, 1 + K, .5>, y, .4 pigment { rgb <.9, .9, .2> } })"},
        {"degenerate",
         "t_junctions",
         "edges that end within other edges",
         "triangles along the edge",
         {9},
         {100, 2000},
         R"(
camera { location <0, 1, -5> look_at <0, 1, 0> }
light_source { <5, 8, -6>, 1 }
mesh {
  triangle { <-2, 1, 0>, <2, 1, 0>, <0, 3, 0> }
  #for (I, 0, K - 1)
    triangle { <-2 + 4 * I / K, 1, 0>, <-2 + 4 * (I + 1) / K, 1, 0>, <-2 + 4 * (I + .5) / K, 0, -.5> }
  #end
  pigment { rgb <1, .3, .2> }
}
plane { y, -1 pigment { rgb <.9, .8, .7> } })"},
        {"degenerate",
         "crossing_angle",
         "the crossing of two edges almost parallel",
         "degrees between them",
         {1e-12, 1e-3},
         {1e-9, 1e-6, 1e-1, 1},
         R"(
camera { location <0, 3, -5> look_at <0, 0, 0> }
light_source { <5, 8, -6>, 1 }
plane { y, -1 pigment { rgb <.9, .8, .7> } }
polygon { 5, <-3, 0, 0>, <3, 0, 0>, <3, 0, 1>, <-3, 0, 1>, <-3, 0, 0> rotate y * 17
  pigment { rgb <.3, .5, 1> } }
polygon { 5, <-3, .5, 0>, <3, .5, 0>, <3, .5, 1>, <-3, .5, 1>, <-3, .5, 0> rotate y * (17 + K)
  translate -.5 * y + .02 * y pigment { rgb <1, .3, .2> } })"},
        {"degenerate",
         "star",
         "many edges through one point",
         "edges",
         {10, 300},
         {3, 30, 100, 1000},
         R"(
camera { location <0, 0, -5> look_at 0 }
light_source { <5, 8, -6>, 1 }
mesh {
  #for (I, 0, K - 1)
    #local A = 2 * pi * I / K; #local B = 2 * pi * (I + .5) / K;
    triangle { 0, 2 * <cos(A), sin(A), 0>, 2 * <cos(B), sin(B), .3> }
  #end
  pigment { rgb <1, .3, .2> }
}
plane { z, 2 pigment { rgb <.9, .8, .7> } hollow })"},
        {"degenerate",
         "plane_through_eye",
         "a face seen edge-on",
         "distance of the eye from it",
         {0, 1e-12, 1e-6},
         {1e-9, 1e-4, 1e-2},
         R"(
camera { location <0, K, -5> look_at <0, K, 0> }
light_source { <5, 8, -6>, 1 }
polygon { 5, <-2, 0, -3>, <2, 0, -3>, <2, 0, 3>, <-2, 0, 3>, <-2, 0, -3> pigment { rgb <.3, .5, 1> } }
box { <-.5, -1, 1>, <.5, 1, 2> pigment { rgb <1, .3, .2> } }
box { <1, 0, -1>, <3, 2, 1> pigment { rgb <.4, .8, .3> } }
plane { y, -1 pigment { rgb <.9, .8, .7> } })"},
        {"degenerate",
         "plane_through_light",
         "a shadow volume without inside",
         "distance of the light from it",
         {0, 1e-9},
         {1e-12, 1e-6, 1e-3},
         R"(
camera { location <1, 3, -6> look_at <0, .5, 0> }
light_source { <4 + K, 4, -2>, 1 }
plane { y, 0 pigment { rgb <.9, .8, .7> } }
polygon { 5, <4, 0, 2>, <4, 2, 2>, <4, 2, -5>, <4, 0, -5>, <4, 0, 2> pigment { rgb <.3, .5, 1> } }
box { <-1, 0, -1>, <0, 4, 1> pigment { rgb <1, .3, .2> } }
polygon { 5, <-2, 4, 3>, <2, 4, 3>, <2, 4, -1>, <-2, 4, -1>, <-2, 4, 3> pigment { rgb <.4, .8, .3> } })"},
        {"degenerate",
         "on_pixels",
         "edges through pixel centres and along the image's border",
         "offset in pixels of 64x48",
         {0, .5, 1e-9},
         {.25, 1e-6, 1e-3},
         R"(
camera { orthographic location <32 + K, 24 + K, -9> look_at <32 + K, 24 + K, 0> right 64 * x up 48 * y }
light_source { <50, 80, -90>, 1 }
box { <0, 0, 0>, <16, 48, 1> pigment { rgb <.3, .5, 1> } }
box { <16, 0, 0>, <32, 20, 1> pigment { rgb <1, .3, .2> } }
box { <40, 8, 0>, <64, 9, 1> pigment { rgb <.4, .8, .3> } }
triangle { <32, 47, 0>, <63, 47, 0>, <63, 16, 0> pigment { rgb <.9, .9, .2> } }
plane { z, 3 pigment { rgb <.9, .8, .7> } hollow })"},
        {"degenerate",
         "cocircular",
         "points of which many lie on one circle",
         "corners",
         {64},
         {8, 512, 4096},
         R"(
camera { orthographic location <0, 0, -9> look_at 0 right 4 * x up 3 * y }
light_source { <5, 8, -9>, 1 }
polygon { K + 1 #for (I, 0, K) , 1.2 * <cos(2 * pi * mod(I, K) / K), sin(2 * pi * mod(I, K) / K), 0> #end
  pigment { rgb <1, .3, .2> } }
plane { z, 1 pigment { rgb <.9, .8, .7> } hollow })"},
        {"degenerate",
         "polygon_with_rings",
         "rings that touch, cross and repeat themselves",
         "distance between two of them",
         {0, 1e-9},
         {1e-4, 1e-2},
         R"(
camera { location <0, 0, -5> look_at 0 }
light_source { <5, 8, -6>, 1 }
polygon { 20, <-2, -1>, <2, -1>, <2, 1>, <-2, 1>, <-2, -1>,
  <-2 + K, -.5>, <-1, -.5>, <-1, .5>, <-2 + K, .5>, <-2 + K, -.5>,
  <-1, .5 - K>, <0, -.5>, <0, .5>, <-1, -.5>, <-1, .5 - K>,
  <.5, 0>, <1.5, 0>, <1.5, .5>, <.5, .5>, <.5, 0> pigment { rgb <1, .3, .2> } }
plane { z, 1 pigment { rgb <.9, .8, .7> } hollow })"},
        {"degenerate",
         "deck_of_cards",
         "many faces almost in one plane",
         "distance of two cards",
         {0, 1e-7},
         {1e-9, 1e-5, 1e-3},
         R"(
camera { location <0, 2, -4> look_at 0 }
light_source { <5, 8, -6>, 1 }
#for (I, 0, 30)
  polygon { 5, <-1, K * I, -1>, <1, K * I, -1>, <1, K * I, 1>, <-1, K * I, 1>, <-1, K * I, -1>
    rotate y * 7 * I pigment { rgb <mod(I, 3) / 2, mod(I, 4) / 3, mod(I, 5) / 4> } }
#end
plane { y, -1 pigment { rgb <.9, .8, .7> } })"},
        {"degenerate",
         "touching",
         "curved things that touch, or almost",
         "gap between them",
         {0, 1e-9},
         {1e-12, 1e-6, 1e-3},
         R"(
camera { location <0, 1, -5> look_at <0, .8, 0> }
light_source { <5, 8, -6>, 1 }
plane { y, 0 pigment { rgb <.9, .8, .7> } }
sphere { <-1 - K, 1 + K, 0>, 1 pigment { rgb <1, .3, .2> } }
sphere { <1, 1 + K, 0>, 1 pigment { rgb <.3, .5, 1> } }
cylinder { <-3, 2 + K, 0>, <3, 2 + K, 0>, K + 1e-3 pigment { rgb <.4, .8, .3> } }
cone { <0, 0, -1>, .5, <0, 1, -1>, K pigment { rgb <.9, .9, .2> } }
torus { 1, 1 - K translate <3.5, 1, 2> pigment { rgb <.2, .8, .8> } })"},
        {"degenerate",
         "horizon",
         "a plane seen ever more edge-on",
         "height of the eye",
         {1e-6, 1e-3},
         {0, 1e-9, 1e-1},
         R"(
camera { location <0, K, -5> look_at <0, K, 0> }
light_source { <5, 8, -6>, 1 }
plane { y, 0 pigment { checker rgb 1, rgb <.2, .3, .9> } }
background { rgb <.6, .7, .9> }
sphere { <0, .5, 0>, .5 pigment { rgb <1, .3, .2> } })"},
        {"degenerate",
         "thin_wires",
         "things thinner than a pixel",
         "radius",
         {1e-8, 1e-2},
         {1e-6, 1e-4, 1e-3},
         R"(
camera { location <0, 1, -5> look_at <0, 1, 0> }
light_source { <5, 8, -6>, 1 }
plane { y, 0 pigment { rgb <.9, .8, .7> } }
#for (I, -10, 10)
  cylinder { <I / 5, 0, 0>, <I / 4, 2, 0>, K pigment { rgb <1, .3, .2> } }
  sphere { <I / 5, 1, -1>, K pigment { rgb <.3, .5, 1> } }
#end)"},
    };
}

}  // namespace povpreview::stability
