// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Lengths and coordinates from 10^-9 to 10^9.
#include "tests/stability/series.h"

namespace povpreview::stability {

std::vector<Series> scale_series() {
    return {
        {"scale",
         "whole_scene",
         "thresholds in scene units that do not scale",
         "size of the scene",
         {1e-9, 1e-4, 1e4, 1e9},
         {1e-6, 1e-2, 1, 1e2, 1e6},
         R"(
camera { location <1, 2, -6> * K direction vnormalize(<-1, -1.3, 6>) right x * 4 / 3 up y }
light_source { <5, 8, -6> * K, 1 }
plane { y, 0 pigment { checker rgb 1, rgb .3 } scale K }
box { <-1.5, 0, 0>, <-.3, 1.2, 1> pigment { rgb <.3, .5, 1> } rotate y * 20 scale K }
sphere { <.8, .7, 0>, .7 pigment { rgb <1, .3, .2> } scale K }
mesh {
  triangle { <-3, 0, 2>, <0, 3, 3>, <3, 0, 2.5> }
  triangle { <0, 3, 3>, <3, 0, 2.5>, <3, 3, 4> }
  pigment { rgb <.4, .8, .3> } scale K
})"},
        {"scale",
         "far_from_origin",
         "cancellation between large coordinates",
         "distance from the origin",
         {1e3, 1e6, 1e9},
         {1, 1e4, 1e5, 1e7, 1e8},
         R"(
#declare D = <K, K / 3, -K / 7>;
camera { location <1, 2, -6> + D look_at <0, .7, 0> + D }
light_source { <5, 8, -6> + D, 1 }
box { <-5, -1, -5> + D, <5, 0, 8> + D pigment { rgb <.9, .8, .7> } }
box { <-1.5, 0, 0> + D, <-.3, 1.2, 1> + D pigment { rgb <.3, .5, 1> } }
sphere { <.8, .7, 0> + D, .7 pigment { rgb <1, .3, .2> } }
cylinder { <2, 0, 1> + D, <2.5, 2, 1> + D, .3 pigment { rgb <.4, .8, .3> } })"},
        {"scale",
         "both_in_one",
         "the small thing lost beside the large one",
         "large against small",
         {1e3, 1e6, 1e9},
         {1, 1e4, 1e5, 1e7, 1e8},
         R"(
camera { location <0, 1, -5> look_at <0, .8, 0> }
light_source { <.5, .9, -.6> * K, 1 }
box { <-K, -K, -K>, <K, 0, K> pigment { rgb <.9, .8, .7> } }
mesh {
  triangle { <-K, 0, K * .9>, <0, K * .2, K * .9>, <K * .3, 0, K * .8> }
  pigment { rgb <.3, .4, .6> }
}
box { <-.6, 0, 0>, <.4, 1, 1> pigment { rgb <.3, .5, 1> } }
sphere { <.9, .5, 0>, .5 pigment { rgb <1, .3, .2> } })"},
        {"scale",
         "stretched",
         "inverses of matrices of great condition",
         "stretch along one axis",
         {1e-6, 1e6},
         {1e-9, 1e-4, 1e-2, 1e2, 1e4, 1e9},
         R"(
camera { location <1, 2, -6> look_at <0, .7, 0> }
light_source { <5, 8, -6>, 1 }
plane { y, 0 pigment { rgb <.9, .8, .7> } }
sphere { 0, 1 scale <K, 1, 1> scale <1 / K, 1, 1> * <.7, .7, .7> translate <.9, .7, 0>
  pigment { rgb <1, .3, .2> } }
box { 0, <1 / K, 1, 1> scale <K, 1, 1> rotate y * 30 translate -1.5 * x
  pigment { checker rgb 1 rgb <.2, .3, .9> scale <.25, .25, .25> } }
cylinder { 0, 2 * y, .4 scale <1, K, 1> translate <0, 0, 2> pigment { rgb <.4, .8, .3> } })"},
        {"scale",
         "thin_plate",
         "two sides of a thing nearer than the tracer's own threshold",
         "thickness",
         {1e-9, 1e-3},
         {1e-7, 1e-5, 1e-4, 1e-2, 1e-1},
         R"(
camera { location <1, 2, -6> look_at <0, .7, 0> }
light_source { <5, 8, -6>, 1 }
plane { y, 0 pigment { rgb <.9, .8, .7> } }
box { <-1.5, 0, 0>, <-.5, 1.5, K> rotate y * 30 pigment { rgb <.3, .5, 1> } }
cylinder { <0, 1, -1>, <0, 1 + K, -1>, 1 pigment { rgb <1, .3, .2> } }
difference { sphere { <1.5, .7, 0>, .7 } sphere { <1.5, .7, 0>, .7 - K }
  box { <1, .9, -1>, <3, 2, 1> } pigment { rgb <.4, .8, .3> } })"},
    };
}

}  // namespace povpreview::stability
