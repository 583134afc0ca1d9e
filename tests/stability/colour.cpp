// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Colours that are large, small, negative, infinite, or change within a pixel.
#include "tests/stability/series.h"

namespace povpreview::stability {

std::vector<Series> colour_series() {
    return {
        {"colour",
         "radiance",
         "bright and dark side by side",
         "radiance",
         {1e-8, 1e4, 1e8},
         {1e-4, 1, 1e2, 1e6, 1e12},
         R"(
camera { location <0, 1, -5> look_at <0, 1, 0> }
light_source { <5, 8, -6>, 1 }
plane { y, 0 pigment { rgb <.9, .8, .7> } finish { reflection .2 } }
box { <-2, 0, 0>, <-.5, 2, 1> pigment { rgb 1 } finish { ambient 0 emission K diffuse 0 } }
box { <-.5, 0, 0>, <.5, 2, 1> pigment { rgb <1, .3, .2> } }
sphere { <1.2, .7, 0>, .7 pigment { checker rgb K, rgb 1 / K scale .3 } })"},
        {"colour",
         "light_of_strength",
         "products of light and albedo that overflow",
         "strength of the light",
         {1e-30, 1e30},
         {1e-12, 1e-6, 1e6, 1e12, 1e38},
         R"(
camera { location <0, 1, -5> look_at <0, 1, 0> }
light_source { <5, 8, -6>, K }
plane { y, 0 pigment { rgb <.9, .8, .7> } finish { specular .5 reflection .2 } }
box { <-1.5, 0, 0>, <-.5, 2, 1> pigment { checker rgb 0, rgb 1 scale .4 } }
sphere { <1, .7, 0>, .7 pigment { rgb <1, .3, .2> / K } })"},
        {"colour",
         "black_albedo",
         "light that no pigment tells of",
         "albedo",
         {0, 1e-30},
         {1e-8, 1e-3},
         R"(
camera { location <0, 2, -5> look_at <0, .7, 0> }
light_source { <5, 8, -6>, 3 }
plane { y, 0 pigment { checker rgb K, rgb 1 } finish { ambient .1 specular .6 } }
box { <-1.5, 0, 0>, <-.5, 1.5, 1> pigment { rgb K } finish { phong 1 reflection .3 } }
sphere { <1, .7, 0>, .7 pigment { bozo color_map { [0 rgb K] [1 rgb <1, K, .3>] } scale .2 } })"},
        {"colour", "negative", "colours below black", "colour", {-1, -1e4}, {-1e-3, -1e2, -1e8}, R"(
camera { location <0, 2, -5> look_at <0, .7, 0> }
light_source { <5, 8, -6>, 1 }
light_source { <-5, 8, -6>, K / 10 }
plane { y, 0 pigment { checker rgb <1, K, 1>, rgb <.2, .3, .4> } }
box { <-1.5, 0, 0>, <-.5, 1.5, 1> pigment { rgb <K, 1, .5> } }
sphere { <1, .7, 0>, .7 pigment { rgb 1 } finish { ambient K * .1 } })"},
        {"colour",
         "not_finite",
         "functions divided by zero",
         "numerator",
         {0, 1},
         {-1, 1e300},
         R"(
camera { location <0, 2, -5> look_at <0, .7, 0> }
light_source { <5, 8, -6>, 1 }
plane { y, 0 pigment { function { select(x, K / (x - x), z) } color_map { [0 rgb 1] [1 rgb x] } } }
box { <-1.5, 0, 0>, <-.5, 1.5, 1> pigment { rgb <.3, .5, 1> * (1 + K * 1e300) } }
sphere { <1, .7, 0>, .7 pigment { function { sqrt(-1 - y) * K } } }
torus { .5, .1 translate <0, 1, -1> pigment { function { pow(y - 5, .5 + K) } } })"},
        {"colour",
         "highlight",
         "highlights smaller than a pixel",
         "roughness",
         {1e-3, 1e-6},
         {1e-5, 1e-4, 1e-2},
         R"(
camera { location <0, 2, -5> look_at <0, .7, 0> }
light_source { <5, 8, -6>, 1 }
plane { y, 0 pigment { rgb <.9, .8, .7> } }
#for (I, -6, 6) #for (J, 0, 3)
  sphere { <I / 3, .2 + J / 3, 0>, .16 pigment { rgb <.3, .1, .5> }
    finish { specular 10 roughness K } }
#end #end)"},
        {"colour",
         "checker_to_horizon",
         "a texture finer than pixels",
         "fields in a unit of length",
         {1, 100},
         {10, 1e4},
         R"(
camera { location <0, 2, -5> look_at <0, 1, 0> }
light_source { <5, 8, -6>, 1 }
plane { y, 0 pigment { checker rgb 0, rgb 1 scale 1 / K } }
sphere { <0, 1, 0>, 1 pigment { brick rgb 1, rgb <.8, .2, .1> scale .2 / K } finish { reflection .2 } }
background { rgb <.6, .7, .9> })"},
        {"colour",
         "strobe",
         "stripes that beat with the pixels of 64x48",
         "period in pixels",
         {1.001, 2.01},
         {.5, 1.01, 4.1},
         R"(
camera { orthographic location <32, 24, -9> look_at <32, 24, 0> right 64 * x up 48 * y }
light_source { <50, 80, -90>, 1 }
plane { z, 0 pigment { gradient x color_map { [.5 rgb 0] [.5 rgb 1] } scale K } hollow }
box { <20, 10, -1>, <40, 30, 0> pigment { checker rgb x, rgb y scale K / 2 } })"},
        {"colour", "transmittance", "filters that amplify", "filter", {2, 10}, {-1, 100}, R"(
camera { location <0, 2, -5> look_at <0, .7, 0> }
light_source { <5, 8, -6>, 1 }
plane { y, 0 pigment { checker rgb 1, rgb <.2, .3, .4> } }
box { <-1.5, 0, 0>, <-.5, 1.5, 1> pigment { rgbf <1, .5, .9, K> } }
sphere { <1, .7, 0>, .7 pigment { rgbt <.9, 1, .5, K> } interior { ior 1.5 } })"},
        {"colour",
         "rough_normals",
         "normals that turn from pixel to pixel",
         "height of bumps",
         {10},
         {1, 1e3, 1e6},
         R"(
camera { location <0, 2, -5> look_at <0, .7, 0> }
light_source { <5, 8, -6>, 1 }
plane { y, 0 pigment { rgb <.9, .8, .7> } normal { granite K } finish { reflection .3 specular 1 } }
sphere { <0, 1, 0>, 1 pigment { rgb <1, .3, .2> } normal { bumps K scale .01 } })"},
    };
}

}  // namespace povpreview::stability
