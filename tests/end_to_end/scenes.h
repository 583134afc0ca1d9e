// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <ostream>

namespace povpreview::scenes {

/// A small scene and what it is about.
struct SmallScene {
    const char* name;
    const char* text;
};

inline void PrintTo(const SmallScene& scene, std::ostream* out) { *out << scene.name; }

/// Without random numbers: POV-Ray's own image does not depend on the order of its pixels.
inline const SmallScene still[] = {
    {"mirror_and_glass", R"(#version 3.7; global_settings { assumed_gamma 1 max_trace_level 8 }
camera { location <0, 2, -5> look_at <0, .5, 0> angle 50 }
light_source { <5, 8, -5> rgb 1 } light_source { <-5, 3, -3> rgb .3 }
plane { y, 0 pigment { checker rgb 1 rgb <.1, .2, .6> } finish { reflection .2 } }
sphere { <0, 1, 0>, 1 pigment { rgbf <1, .9, .8, .8> } interior { ior 1.5 } finish { specular .5 } }
box { <1, 0, 1>, <2, 1, 2> pigment { rgb <1, .3, .1> } normal { bumps .4 scale .1 } }
background { rgb <.2, .4, .8> })"},
    {"mirrors_of_one_colour", R"(#version 3.7; global_settings { assumed_gamma 1 max_trace_level 6 }
camera { location <0, 2, -6> look_at <0, .6, 0> angle 55 }
light_source { <5, 8, -5> rgb 1 } background { rgb <.2, .4, .8> }
fog { distance 40 rgb <.6, .7, .8> }
plane { y, 0 pigment { rgb <.3, .2, .1> } finish { reflection { .3, .6 falloff 2 } conserve_energy } }
box { <-4, 0, 3>, <4, 4, 3.1> texture { pigment { rgb <.9, .8, .2> }
  finish { reflection { .5 metallic } metallic } } rotate 8*y }
sphere { <-1.4, .7, 0>, .7 pigment { checker rgb 1 rgb <.1, .2, .6> scale .2 } }
sphere { <0, .6, 1>, .6 pigment { rgb .1 } finish { reflection .7 irid { .3 thickness .4 } } }
box { <.8, 0, -.6>, <1.8, .9, .4> pigment { granite scale .4 } finish { reflection .1 } }
box { <2, 0, 0>, <2.1, 2, 2> texture { pigment { rgb .2 } finish { reflection .3 } }
  texture { pigment { rgbt <1, 0, 0, .5> } finish { reflection .3 reflection_exponent 1.5 } } rotate -20*y }
sphere { <-.4, .3, -1.6>, .3 pigment { rgbt <1, .9, .8, .7> } interior { ior 1.3 } })"},
    {"layers_and_maps", R"(#version 3.7; global_settings { assumed_gamma 2.2 }
camera { location <0, 1, -4> look_at 0 } light_source { <5, 9, -7>, <1, .9, .8> }
sphere { 0, 1 texture { pigment { rgb <1, .5, 0> } }
  texture { pigment { marble color_map { [0 rgbt 1] [1 rgbt <0, 0, 1, .3>] } turbulence .5 } } }
plane { y, -1 texture { bozo texture_map { [.4 pigment { wood } finish { phong .5 }]
  [.6 pigment { granite } normal { wrinkles } finish { reflection .1 conserve_energy }] } } }
box { <-2.2, -1, 0>, <-1.2, .5, 1> texture { average texture_map {
  [1 pigment { rgb x } finish { metallic specular 1 }] [2 pigment { rgbf <.2, 1, .2, .4> }] } } })"},
    {"before_gamma", R"(#version 3.5;
camera { location <0, 1, -4> look_at 0 } light_source { <5, 9, -7>, 1 }
sphere { 0, 1 pigment { rgb <1, .3, .1> } finish { ambient .3 } }
plane { y, -1 pigment { checker rgb .2 rgb .9 } } sky_sphere { pigment { gradient y
  color_map { [0 rgb 1] [1 rgb <.2, .3, .9>] } } })"},
    {"soft_shadow", R"(#version 3.7; global_settings { assumed_gamma 1 }
camera { location <0, 2, -5> look_at 0 }
light_source { <3, 6, -3>, 1 area_light x, z, 5, 5 adaptive 1 }
light_source { <-3, 6, -3>, .4 spotlight point_at 0 radius 10 falloff 30 }
plane { y, -1 pigment { rgb .8 } } sphere { 0, 1 pigment { rgb <.2, .7, .3> } }
union { box { -1, 1 } cylinder { -2*x, 2*x, .5 } scale .4 translate <2, -.5, -1>
  pigment { rgbt <1, 0, 0, .5> } })"},
    {"fog_and_iridescence", R"(#version 3.7; global_settings { assumed_gamma 1 }
camera { location <0, 2, -5> look_at 0 } light_source { <3, 6, -3>, 1 }
fog { distance 15 rgb <.6, .7, .8> } fog { fog_type 2 fog_alt .5 fog_offset 0 distance 4 rgb 1 }
plane { y, -1 pigment { hexagon rgb 1 rgb .3 rgb <0, .5, 0> } }
torus { 1, .4 pigment { rgb .6 } finish { irid { .4 thickness .5 turbulence .5 } diffuse .4 } })"},
    {"focal_blur", R"(#version 3.7; global_settings { assumed_gamma 1 }
camera { location <0, 1, -4> look_at 0 aperture .4 blur_samples 12 focal_point <0, 0, -1> }
light_source { <5, 9, -7>, 1 } plane { y, -1 pigment { checker rgb .2 rgb .9 } }
sphere { 0, 1 pigment { rgb <1, .3, .1> } finish { reflection .3 } })"},
    {"photons", R"(#version 3.7; global_settings { assumed_gamma 1 photons { spacing .05 } }
camera { location <0, 3, -4> look_at 0 } light_source { <2, 6, 1>, 1 }
plane { y, -1 pigment { rgb .8 } }
sphere { 0, 1 pigment { rgbf .95 } interior { ior 1.5 } finish { specular .4 }
  photons { target reflection on refraction on } })"},
    {"fisheye", R"(#version 3.7; global_settings { assumed_gamma 1 }
camera { fisheye location <0, .5, -2> look_at 0 angle 150 } light_source { <5, 9, -7>, 1 }
plane { y, -1 pigment { brick } } mesh { triangle { <-1, -1, 0>, <1, -1, 0>, <0, 1, 0> }
  smooth_triangle { <1, 0, 0>, x, <2, 0, 1>, x + y, <1, 1, 1>, y } pigment { rgb x + y } })"},
};

/// With random numbers in the light: stock POV-Ray's image depends on order or threads.
inline const SmallScene noisy[] = {
    {"jittered_light", R"(#version 3.7; global_settings { assumed_gamma 1 }
camera { location <0, 2, -5> look_at 0 }
light_source { <3, 6, -3>, 1 area_light 2*x, 2*z, 5, 5 jitter }
plane { y, -1 pigment { rgb .8 } finish { crand .1 } } sphere { 0, 1 pigment { rgb <.2, .7, .3> } })"},
    {"scattering_media", R"(#version 3.7; global_settings { assumed_gamma 1 }
camera { location <0, 2, -5> look_at 0 } light_source { <3, 6, -3>, 1 }
media { method 1 intervals 2 samples 2, 4 scattering { 1, .05 } }
plane { y, -1 pigment { rgb .8 } hollow } sphere { 0, 1 pigment { rgb <.2, .7, .3> } })"},
    {"radiosity", R"(#version 3.7; global_settings { assumed_gamma 1
  radiosity { count 20 pretrace_start .16 pretrace_end .08 recursion_limit 2 } }
camera { location <0, 1, -4> look_at 0 } light_source { <3, 6, -3>, .5 }
box { <-3, -1, -5>, <3, 3, 3> pigment { gradient x color_map { [0 rgb x] [1 rgb z] } scale 6 }
  finish { ambient 0 } } sphere { 0, 1 pigment { rgb .9 } finish { ambient 0 } })"},
};

}  // namespace povpreview::scenes
