// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Ten thousand boxes.
//
// Tests: numbers. 10,000 boxes of all sizes stand, lean and float on a plain, 60,000 faces, most of
//   them hidden or smaller than a pixel towards the horizon: finding edges must not take longer
//   than tracing, the heavy edges must come first, and where edges are denser than pixels they are
//   of no use. Two lights, so every box throws two shadows.
// Should be seen: a circular plaza of low blocks in the colours of a sunset between heaps that rise
//   to all sides like a city of crates; the nearest are large, the farthest dust.
// Camera: aspect 4:3, meant for 640x480 and up.
// Options: Declare=Boxes=N for another number; Declare=Untextured=1 changes nothing: there are no
//   textures but plain colours.
//
// Units are metres; x right, y up, z into the picture.

#version 3.7;

#ifndef (Boxes)
  #declare Boxes = 10000;
#end

global_settings { assumed_gamma 1.0 }

camera {
  location <0, 15, -46>
  right x * 4 / 3
  angle 58
  look_at <0, 3.5, 0>
}

light_source {
  <-70, 90, -50>
  color rgb <1.0, 0.88, 0.72> * 0.85
}

light_source {
  <80, 60, 10>
  color rgb <0.55, 0.66, 0.95> * 0.40
}

background { color srgb <0.80, 0.78, 0.80> }

#declare Dice = seed(10000);
#macro Between(A, B) (A + (B - A) * rand(Dice)) #end

#declare Paint = array[6] {
  srgb <0.86, 0.42, 0.28>, srgb <0.93, 0.69, 0.36>, srgb <0.74, 0.31, 0.37>,
  srgb <0.48, 0.34, 0.48>, srgb <0.88, 0.83, 0.72>, srgb <0.35, 0.45, 0.56>
}

#macro Matt(C)
  texture {
    pigment { color C }
    finish { ambient rgb <0.20, 0.21, 0.25> diffuse 0.75 }
  }
#end

// Along a sunflower's spiral, so that they cover the plain evenly out to a radius of 100; heaps grow
// with the distance from the plaza.
#for (I, 0, Boxes - 1)
  #local T = (I + 0.5) / Boxes;
  #local R = 100 * sqrt(T);
  #local A = 2.39996323 * I;
  #local Rise = min(1, max(0, (R - 17) / 30));
  #local S = Between(0.25, 0.75) * (1 + 0.8 * (mod(I, 23) = 0)) * sqrt(10000 / Boxes);
  #local Tall = Between(0.3, 1) * (1 + 5 * Rise * rand(Dice) * rand(Dice));
  box {
    <-S, 0, -S>, <S, S * Tall * 2, S>
    #if (mod(I, 5) = 0) rotate <Between(-25, 25), 0, Between(-25, 25)> #end
    rotate y * Between(0, 90)
    translate <R * cos(A), (mod(I, 11) = 0) * Rise * Between(0, 5), R * sin(A)>
    Matt(Paint[int(6 * rand(Dice))] * Between(0.85, 1.1))
  }
#end

box { <-300, -1, -300>, <300, 0, 300> Matt(srgb <0.62, 0.58, 0.56>) }

box { <-1.5, 0, -1.5>, <1.5, 9, 1.5> rotate y * 30 Matt(srgb <0.90, 0.88, 0.84>) }
box { <-2.2, 0, -2.2>, <2.2, 1.2, 2.2> rotate y * 30 Matt(srgb <0.66, 0.64, 0.62>) }
