// SPDX-License-Identifier: AGPL-3.0-or-later
//
// A vanity table: a wall mirror and a polished top that show a globe, a crate and tiles.
//
// Tests: textures seen in flat mirrors. Images (spherical, planar) and checker, brick and hexagon
//   patterns, all of which are known at every pixel without tracing, here behind two mirrors of one
//   colour each; what a mirror shows of them is known as well, and samples carry the light on it.
// Should be seen: a table top that mirrors all that stands on it, and a wall mirror above it that
//   shows the backs of the things and the room's brick wall behind the camera.
// Camera: aspect 4:3, meant for 640x480 and up.
//
// The images are those that come with POV-Ray's include files. Units are decimetres; x right, y up,
// z towards the wall.

#version 3.7;
global_settings { assumed_gamma 1 }

camera {
    location <-1, 5, -14>
    right 4/3*x
    look_at <0, 2.2, 0>
    angle 48
}
light_source { <8, 14, -12> rgb .9 }
light_source { <-10, 9, -6> rgb .35 }
background { rgb <.3, .4, .55> }

#declare Globe = pigment { image_map { png "mtmandj.png" map_type 1 interpolate 2 } }
#declare Print = pigment { image_map { png "mtmandj.png" interpolate 2 } translate -.5 }

// The room: a floor far below, a papered wall and a brick wall behind the camera.
plane { y, -8 pigment { checker rgb .6 rgb .3 scale 4 } }
plane { -z, -7 pigment { hexagon rgb <.55, .6, .5>, rgb <.6, .62, .55>, rgb <.5, .58, .5> rotate 90*x scale .8 } }
plane { z, -40 pigment { brick rgb .75, rgb <.6, .25, .18> brick_size <3, 1, 2> mortar .15 } }

// The table's top and the wall mirror: black, and nothing but mirrors.
box { <-9, -.4, -5>, <9, 0, 6> pigment { rgb .12 } finish { diffuse .5 reflection .45 } }
box { <-6, .6, 6.6>, <6, 7.2, 6.8> pigment { rgb .02 } finish { diffuse .1 reflection .85 } }

// What stands on it.
sphere { <-3.4, 2, 0>, 2 pigment { Globe rotate -40*y } finish { diffuse .8 ambient .1 } }
box { -1, 1 pigment { Print scale 2 } finish { diffuse .8 ambient .1 } scale 1.5 rotate 30*y translate <1.2, 1.5, 1.5> }
cylinder { <4.6, 0, -.5>, <4.6, 3.4, -.5>, 1.1 pigment { checker rgb .9 rgb <.1, .3, .6> scale .55 } finish { diffuse .8 ambient .1 } }
sphere { <.4, .9, -2.6>, .9 pigment { hexagon rgb .9, rgb <.2, .5, .2>, rgb <.8, .7, .1> scale .3 } finish { diffuse .8 ambient .1 } }
