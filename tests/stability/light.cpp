// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Lights: none, many, and where none can be.
#include "tests/stability/series.h"

namespace povpreview::stability {

std::vector<Series> light_series() {
    return {
        {"light",
         "count",
         "work and edges that grow with the lights",
         "lights",
         {0, 1, 100},
         {10, 1000},
         R"(
camera { location <0, 3, -6> look_at <0, .7, 0> }
#declare R = seed(11);
#for (I, 1, K)
  light_source { <20 * rand(R) - 10, 3 + 5 * rand(R), -6 * rand(R)>, 1.5 / K }
#end
plane { y, 0 pigment { rgb <.9, .8, .7> } finish { ambient .2 } }
box { <-1.5, 0, 0>, <-.3, 1.2, 1> pigment { rgb <.3, .5, 1> } }
box { <.5, 0, -1>, <1, 2, 0> pigment { rgb <1, .3, .2> } finish { ambient .2 } })"},
        {"light",
         "at_the_eye",
         "shadows that hide behind what throws them",
         "distance from the eye",
         {0, 1e-6},
         {1e-12, 1e-9, 1e-3},
         R"(
camera { location <0, 2, -6> look_at <0, .7, 0> }
light_source { <K, 2, -6>, 1 }
plane { y, 0 pigment { rgb <.9, .8, .7> } }
box { <-1.5, 0, 0>, <-.3, 1.2, 1> pigment { rgb <.3, .5, 1> } }
sphere { <.8, .7, 0>, .7 pigment { rgb <1, .3, .2> } })"},
        {"light",
         "in_a_face",
         "a light before, in and behind the face it stands on",
         "height above the face",
         {0, -1e-6, 1e-6},
         {1e-12, -1e-3, 1e-3},
         R"(
camera { location <0, 3, -6> look_at <0, .7, 0> }
light_source { <0, K, -1>, 1 }
light_source { <1, 4, -1>, .3 }
box { <-4, -1, -4>, <4, 0, 4> pigment { rgb <.9, .8, .7> } }
box { <-1.5, 0, 0>, <-.3, 1.2, 1> pigment { rgb <.3, .5, 1> } }
sphere { <.8, .7, 0>, .7 pigment { rgb <1, .3, .2> } })"},
        {"light",
         "grazing",
         "light along a face",
         "slope of the light",
         {1e-6, 1e-2},
         {0, 1e-9, 1e-4},
         R"(
camera { location <0, 3, -6> look_at <0, .7, 0> }
light_source { <100, 100 * K, 0>, 1 }
box { <-4, -1, -4>, <4, 0, 4> pigment { rgb <.9, .8, .7> } finish { ambient .2 } }
box { <-1.5, 0, 0>, <-.3, 1.2, 1> pigment { rgb <.3, .5, 1> } finish { ambient .2 } }
polygon { 5, <1, 1e-3, -1>, <2, 1e-3, -1>, <2, 1e-3, 1>, <1, 1e-3, 1>, <1, 1e-3, -1>
  pigment { rgb <1, .3, .2> } finish { ambient .3 } })"},
        {"light",
         "spotlight",
         "a cone of light without inside",
         "degrees of the cone",
         {0, 1e-6},
         {1e-3, 1, 89.999, 180},
         R"(
camera { location <0, 3, -6> look_at <0, .7, 0> }
light_source { <2, 5, -3>, 1 spotlight point_at <0, 0, 0> radius K falloff K tightness 0 }
light_source { <-2, 5, -3>, .5 cylinder point_at <0, 0, 0> radius K falloff K + 1e-9 }
plane { y, 0 pigment { rgb <.9, .8, .7> } finish { ambient .2 } }
box { <-1.5, 0, 0>, <-.3, 1.2, 1> pigment { rgb <.3, .5, 1> } finish { ambient .2 } })"},
        {"light",
         "area",
         "shadows with and without umbra",
         "side of the light",
         {1e-6, 1e3},
         {1e-2, 1, 1e2},
         R"(
camera { location <0, 3, -6> look_at <0, .7, 0> }
light_source { <2, 5, -3>, 1 area_light K * x, K * z, 4, 4 }
plane { y, 0 pigment { rgb <.9, .8, .7> } finish { ambient .2 } }
box { <-1.5, 0, 0>, <-.3, 1.2, 1> pigment { rgb <.3, .5, 1> } }
sphere { <.8, .7, 0>, .7 pigment { rgb <1, .3, .2> } })"},
        {"light",
         "inside",
         "a light within what it lights",
         "size of the hull",
         {.5},
         {1e-3, 100},
         R"(
camera { location <0, 3, -6> look_at <0, .7, 0> }
light_source { <0, 1, 0>, 1 looks_like { sphere { 0, .1 pigment { rgb 1 } finish { emission 1 } } } }
difference { box { -K, K } box { -K * .9, K * .9 } cylinder { -2 * K * x, 2 * K * x, K / 2 }
  translate y pigment { rgb <.3, .5, 1> } finish { ambient .2 } }
plane { y, 0 pigment { rgb <.9, .8, .7> } finish { ambient .2 } })"},
        {"light",
         "fading",
         "light that fades within less than a pixel",
         "fade distance",
         {1e-9, 1e9},
         {1e-3, 1},
         R"(
camera { location <0, 3, -6> look_at <0, .7, 0> }
light_source { <2, 3, -3>, 1 fade_distance K fade_power 2 }
light_source { <-2, 3, -3>, .3 shadowless fade_distance 1 fade_power 1000 }
plane { y, 0 pigment { rgb <.9, .8, .7> } finish { ambient .2 } }
box { <-1.5, 0, 0>, <-.3, 1.2, 1> pigment { rgb <.3, .5, 1> } })"},
        {"light",
         "coincident",
         "shadow edges one upon the other",
         "lights at one place",
         {2, 30},
         {300},
         R"(
camera { location <0, 3, -6> look_at <0, .7, 0> }
#for (I, 1, K) light_source { <4, 6, -3>, 1 / K } #end
plane { y, 0 pigment { rgb <.9, .8, .7> } finish { ambient .2 } }
box { <-1.5, 0, 0>, <-.3, 1.2, 1> pigment { rgb <.3, .5, 1> } }
box { <.5, 0, -1>, <1, 2, 0> pigment { rgb <1, .3, .2> } })"},
        {"light",
         "parallel",
         "a light at infinity, and one that points nowhere",
         "distance",
         {1e-6, 1e6},
         {1, 1e9},
         R"(
camera { location <0, 3, -6> look_at <0, .7, 0> }
light_source { <2, 3, -3> * K, 1 parallel point_at 0 }
plane { y, 0 pigment { rgb <.9, .8, .7> } finish { ambient .2 } }
box { <-1.5, 0, 0>, <-.3, 1.2, 1> pigment { rgb <.3, .5, 1> } }
sphere { <.8, .7, 0>, .7 pigment { rgb <1, .3, .2> } })"},
    };
}

}  // namespace povpreview::stability
