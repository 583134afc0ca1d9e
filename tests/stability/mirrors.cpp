// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Mirrors that see each other.
#include "tests/stability/series.h"

namespace povpreview::stability {

std::vector<Series> mirror_series() {
    return {
        {"mirrors", "facing", "reflections of reflections", "recursion", {5, 100}, {1, 20}, R"(
global_settings { max_trace_level K adc_bailout 1e-6 }
camera { location <.3, 1.2, -3> look_at <-.2, .8, 0> }
light_source { <0, 2.8, 0>, 1 }
box { <-4, -1, -4>, <4, 0, 4> pigment { rgb <.9, .8, .7> } }
box { <-4, 0, 2>, <4, 3, 2.1> pigment { rgb .05 } finish { reflection .95 } }
box { <-4, 0, -3.6>, <4, 3, -3.5> pigment { rgb .05 } finish { reflection .95 } }
sphere { <.2, .5, 0>, .5 pigment { rgb <1, .3, .2> } finish { reflection .3 } })"},
        {"mirrors", "box", "a room of mirrors", "recursion", {10}, {2, 100}, R"(
global_settings { max_trace_level K }
camera { location <.3, 1.2, -1.5> look_at <-.2, .8, 0> }
light_source { <0, 1.8, 0>, 1 }
box { <-2, 0, -2>, <2, 2, 2> pigment { rgb .1 } finish { reflection .9 } hollow }
box { <-.5, 0, 0>, <.3, .7, .6> rotate y * 20 pigment { rgb <.3, .5, 1> } })"},
        {"mirrors", "spheres", "mirrors that are not flat", "recursion", {8}, {50}, R"(
global_settings { max_trace_level K }
camera { location <0, 2, -4> look_at 0 }
light_source { <5, 8, -6>, 1 }
#for (I, -2, 2) #for (J, -2, 2)
  sphere { <I, 0, J>, .5 pigment { rgb .1 } finish { reflection .9 } }
#end #end
plane { y, -.5 pigment { checker rgb 1, rgb <.2, .3, .9> } })"},
        {"mirrors",
         "tilted",
         "two mirrors almost parallel",
         "degrees between them",
         {1e-6, 1e-2},
         {0, 1e-9, 1},
         R"(
global_settings { max_trace_level 12 }
camera { location <.3, 1.2, -3> look_at <-.2, .8, 0> }
light_source { <0, 2.8, 0>, 1 }
box { <-4, -1, -4>, <4, 0, 4> pigment { rgb <.9, .8, .7> } }
box { <-4, 0, 2>, <4, 3, 2.1> pigment { rgb .05 } finish { reflection .9 } rotate y * K }
box { <-4, 0, -3.6>, <4, 3, -3.5> pigment { rgb .05 } finish { reflection .9 } }
box { <-.5, 0, 0>, <.3, .7, .6> rotate y * 20 pigment { rgb <.3, .5, 1> } })"},
        {"mirrors",
         "edge_on",
         "a mirror seen and seeing along its plane",
         "height of the eye",
         {0, 1e-6},
         {1e-9, 1e-3},
         R"(
camera { location <0, K, -5> look_at <0, K, 0> }
light_source { <5, 8, -6>, 1 }
box { <-9, -1, -9>, <9, 0, 9> pigment { rgb .05 } finish { reflection .9 } }
box { <-1.5, 0, 0>, <-.3, 1.2, 1> pigment { rgb <.3, .5, 1> } }
sphere { <.8, .7, 0>, .7 pigment { rgb <1, .3, .2> } }
background { rgb <.6, .7, .9> })"},
        {"mirrors",
         "self",
         "a mirror that reflects more than it gets",
         "reflection",
         {1, 2},
         {10},
         R"(
global_settings { max_trace_level 30 }
camera { location <.3, 1.2, -3> look_at <-.2, .8, 0> }
light_source { <0, 2.8, 0>, 1 }
box { <-4, -1, -4>, <4, 0, 4> pigment { rgb <.9, .8, .7> } finish { reflection K } }
box { <-4, 3, -4>, <4, 4, 4> pigment { rgb .5 } finish { reflection K } }
sphere { <0, .5, 0>, .5 pigment { rgb <1, .3, .2> } finish { reflection K } })"},
    };
}

}  // namespace povpreview::stability
