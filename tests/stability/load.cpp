// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Much at a time: faces, edges, pixels.
#include "tests/stability/series.h"

namespace povpreview::stability {

std::vector<Series> load_series() {
    return {
        {"load", "in_one_pixel", "all edges within one pixel", "triangles", {1000}, {1e4, 1e5}, R"(
camera { location <0, 0, -5> look_at 0 }
light_source { <5, 8, -6>, 1 }
#declare R = seed(5);
// Not "mesh": POV-Ray parses that in quadratic time where all corners are close together.
mesh2 {
  vertex_vectors { 3 * K
    #for (I, 1, K)
      #local A = <rand(R), rand(R), rand(R)> * .02;
      , A, A + <rand(R), rand(R), rand(R)> * .01, A + <rand(R), rand(R), rand(R)> * .01
    #end
  }
  face_indices { K #for (I, 0, K - 1) , <3 * I, 3 * I + 1, 3 * I + 2> #end }
  pigment { rgb <1, .3, .2> }
}
plane { z, 2 pigment { rgb <.9, .8, .7> } hollow })"},
        {"load",
         "terrain",
         "more faces than pixels",
         "faces along a side",
         {100},
         {10, 700},
         R"(
camera { location <0, 1.2, -1.2> look_at <0, 0, 0> }
light_source { <5, 3, -2>, 1 }
#macro H(I, J) <2 * I / K - 1, .1 * sin(I * 40 / K) * cos(J * 30 / K) + .05 * sin(I * J * 900 / K / K), 2 * J / K - 1> #end
#declare N = K + 1;
mesh2 {
  vertex_vectors { N * N #for (I, 0, K) #for (J, 0, K) , H(I, J) #end #end }
  face_indices { 2 * K * K
    #for (I, 0, K - 1) #for (J, 0, K - 1)
      , <I * N + J, I * N + N + J, I * N + J + 1>, <I * N + N + J, I * N + J + 1, I * N + N + J + 1>
    #end #end
  }
  pigment { rgb <.5, .8, .3> }
})"},
        {"load",
         "fences",
         "constraints from border to border that cross each other",
         "lines in each direction",
         {30},
         {10, 100, 300},
         R"(
camera { orthographic location <0, 0, -9> look_at 0 right 4 * x up 3 * y }
light_source { <5, 8, -9>, 1 }
union {
  #for (I, 0, K - 1)
    box { <-4, -.2 / K, 0>, <4, .2 / K, .1> translate <0, (2 * I + 1) / K * 3 - 3, 0> rotate z * 10 }
    box { <-4, -.2 / K, .2>, <4, .2 / K, .3> translate <0, (2 * I + 1) / K * 3 - 3, 0> rotate -z * 40 }
  #end
  pigment { rgb <1, .3, .2> }
}
plane { z, 2 pigment { rgb <.9, .8, .7> } hollow })"},
        {"load",
         "soup",
         "triangles through each other, with all their shadows",
         "triangles",
         {60},
         {10, 600, 3000},
         R"(
camera { location <0, 2, -5> look_at <0, .7, 0> }
light_source { <5, 8, -6>, 1 } light_source { <-6, 5, -3>, .5 }
#declare R = seed(9);
#macro P() <4 * rand(R) - 2, 2 * rand(R), 3 * rand(R) - 1.5> #end
#for (I, 1, K)
  triangle { P(), P(), P() pigment { rgb <rand(R), rand(R), rand(R)> } }
#end
plane { y, 0 pigment { rgb <.9, .8, .7> } })"},
        {"load", "spheres", "as many surfaces as pixels", "spheres along a side", {20}, {5, 80}, R"(
camera { location <0, 3, -3> look_at <0, 0, 0> }
light_source { <5, 8, -6>, 1 }
#for (I, 1, K) #for (J, 1, K)
  sphere { <4 * I / K - 2, 0, 4 * J / K - 2>, 1.8 / K pigment { rgb <I / K, J / K, .5> } }
#end #end)"},
        {"load",
         "large",
         "three million pixels",
         "spheres along a side",
         {},
         {20},
         R"(
camera { location <0, 3, -3> look_at <0, 0, 0> }
light_source { <5, 8, -6>, 1 }
#for (I, 1, K) #for (J, 1, K)
  sphere { <4 * I / K - 2, 0, 4 * J / K - 2>, 1.8 / K pigment { granite scale .1 } }
#end #end)",
         "2048x1536"},
        {"load", "holes", "differences with many parts", "holes", {12}, {3, 60}, R"(
camera { location <0, 3, -4> look_at <0, 0, 0> }
light_source { <5, 8, -6>, 1 }
difference {
  box { <-2, -.2, -2>, <2, .2, 2> }
  #for (I, 1, K)
    cylinder { -y, y, 1.2 / K translate <1.5 * cos(2 * pi * I / K), 0, 1.5 * sin(2 * pi * I / K)>
      pigment { rgb <.3, .5, 1> } }
  #end
  pigment { rgb <1, .3, .2> }
}
plane { y, -1 pigment { rgb <.9, .8, .7> } })"},
    };
}

}  // namespace povpreview::stability
