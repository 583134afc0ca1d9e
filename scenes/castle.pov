// SPDX-License-Identifier: AGPL-3.0-or-later
//
// A castle cut out of boxes, prisms and planes.
//
// Tests: CSG of flat solids. Every wall is a difference or an intersection: arrow slits and windows
//   are cut through, gates have pointed arches, towers are intersections of half spaces (planes)
//   with battlements cut into them, so most edges belong to no primitive but to the meeting of two.
//   Also a perspective camera close to large faces, and light that falls through openings.
// Should be seen: a gatehouse with an open gate between two octagonal towers, a bridge across the
//   ditch in front of it; behind it the roof of the keep with a banner; a wall on buttresses.
// Camera: aspect 4:3, meant for 640x480 and up.
// Options: Declare=Untextured=1 leaves out the courses of the stone.
//
// Units are metres; x right, y up, z into the picture. The yard lies at y = 0.

#version 3.7;

#ifndef (Untextured)
  #declare Untextured = 0;
#end

global_settings { assumed_gamma 1.0 }

camera {
  location <-13, 6.5, -29>
  right x * 4 / 3
  angle 60
  look_at <1, 6, 0>
}

light_source {
  <-60, 62, -38>
  color rgb <1.0, 0.92, 0.80> * 1.05
}

background { color srgb <0.62, 0.75, 0.88> }

#declare Light = finish { ambient rgb <0.22, 0.24, 0.29> diffuse 0.72 }
#macro Matt(C)
  texture {
    pigment { color C }
    finish { Light }
  }
#end
#macro Masonry(C)
  texture {
    #if (Untextured)
      pigment { color C }
    #else
      pigment {
        brick color C * 0.78, color C
        brick_size <1.7, 0.62, 0.9>
        mortar 0.05
        translate <0.031, 0.017, 0.043> // no joint lies in a face
      }
    #end
    finish { Light }
  }
#end
#declare Stone = srgb <0.78, 0.72, 0.62>;
#declare Slate = srgb <0.36, 0.39, 0.45>;
#declare Oak = srgb <0.42, 0.29, 0.19>;

// A pointed arch W wide with springing at height S, H high, along z from Z0 to Z1.
//
//        /\      H
//       /  \
//      |    |    S
//      |____|
//
#macro Arch(W, S, H, Z0, Z1)
  prism {
    linear_sweep
    linear_spline
    Z0, Z1, 8,
    <-W / 2, -1>, <W / 2, -1>, <W / 2, S>, <W * 0.36, S + (H - S) * 0.55>, <0, H>,
    <-W * 0.36, S + (H - S) * 0.55>, <-W / 2, S>, <-W / 2, -1>
    // the sweep along z, the outline upwards
    matrix <1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0>
  }
#end

// An upright solid between N planes at distance R from its axis, from the ground to H.
#macro Column(N, R, H)
  intersection {
    #for (I, 0, N - 1)
      plane { x, R rotate y * (I + 0.5) * 360 / N }
    #end
    plane { y, H }
    plane { -y, 0.5 }
    bounded_by { box { <-2 * R, -0.6, -2 * R>, <2 * R, H + 0.1, 2 * R> } }
  }
#end

// An octagonal tower with a parapet, battlements, and arrow slits on all sides.
#macro Tower(R, H)
  difference {
    union {
      Column(8, R, H)
      intersection { // the parapet leans out
        #for (I, 0, 7)
          plane { <1, -0.5, 0>, 0 translate <R, H - 2.2, 0> rotate y * (I + 0.5) * 45 }
          plane { x, R + 0.45 rotate y * (I + 0.5) * 45 }
        #end
        plane { y, H + 1.4 }
        plane { -y, -(H - 2.2) }
        bounded_by { box { <-R - 2, H - 2.3, -R - 2>, <R + 2, H + 1.5, R + 2> } }
      }
    }
    object { Column(8, R - 0.35, 3) translate y * (H - 0.2) } // its platform
    #for (I, 0, 3)
      box { <-R - 2, H + 0.55, -0.45>, <R + 2, H + 2, 0.45> rotate y * 45 * (I + 0.5) }
    #end
    #for (I, 0, 3)
      #for (J, 0, 1)
        box {
          <-R - 2, 3 + J * 4 + mod(I, 2) * 1.3, -0.13>, <R + 2, 4.7 + J * 4 + mod(I, 2) * 1.3, 0.13>
          rotate y * 45 * (I + 0.5)
        }
      #end
    #end
    Column(8, R - 1.1, H - 1) // hollow inside
    Masonry(Stone)
  }
#end

// A stretch of wall along x from 0 to L with a walk on top, slits and merlons.
#macro Curtain(L, H)
  difference {
    box { <0, -0.5, -0.9>, <L, H + 1.6, 0.9> }
    box { <-1, H, -0.45>, <L + 1, H + 2, 1> }
    #local N = int(L / 1.8);
    #for (I, 0, N - 1)
      box { <(I + 0.3) * L / N, H + 0.8, -1>, <(I + 0.75) * L / N, H + 2, 1> }
    #end
    #local M = int(L / 4);
    #for (I, 0, M - 1)
      box { <(I + 0.5) * L / M - 0.15, 2.2, -1>, <(I + 0.5) * L / M + 0.15, 4, 1> }
    #end
    Masonry(Stone * 0.96)
  }
#end

// -- the gatehouse -------------------------------------------------------------------------------
difference {
  union {
    box { <-4, -0.5, -2.5>, <4, 11, 2.5> }
    box { <-4, 9.6, -2.9>, <4, 12.2, 2.9> }
  }
  Arch(3.6, 3.2, 5.6, -4, 4)
  object { Arch(4.4, 3.4, 6.2, -3, -1.9) }
  box { <-3.6, 11, -2.5>, <3.6, 13, 2.5> }
  #for (I, -2, 2)
    box { <I * 1.65 - 0.4, 11.5, -4>, <I * 1.65 + 0.4, 13, 4> }
  #end
  #for (S, -1, 1, 2)
    object { Arch(0.9, 0.9, 1.8, -4, 4) translate <S * 2.3, 7, 0> }
  #end
  Masonry(Stone)
}
union { // the portcullis, drawn up half way
  #for (I, -4, 4)
    box { <I * 0.4 - 0.05, 3.1, -0.06>, <I * 0.4 + 0.05, 6, 0.06> }
  #end
  #for (I, 0, 4)
    box { <-1.8, 3.3 + 0.5 * I, -0.09>, <1.8, 3.4 + 0.5 * I, 0.02> }
  #end
  Matt(srgb <0.22, 0.21, 0.21>)
}
object { Tower(3.1, 12.5) translate <-6.3, 0, -0.8> }
object { Tower(3.1, 12.5) translate <6.3, 0, -0.8> }

// -- walls to both sides, and the buttresses in front -------------------------------------------------
object { Curtain(22, 7.2) translate <8.6, 0, 0> }
object { Curtain(16, 7.2) rotate y * -64 translate <-8.4, 0, 1> }
#for (I, 0, 3)
  intersection { // a buttress, sloping
    box { <-0.6, -0.5, -2.6>, <0.6, 6.4, 0> }
    plane { <0, 0.55, -1>, 2.4 }
    translate <12 + I * 4.8, 0, -0.8>
    Masonry(Stone * 0.9)
  }
#end

// -- the keep: seen above the wall and through the gate ------------------------------------------------
difference {
  box { <-5, -0.5, 15>, <9, 17, 28> }
  box { <-4.3, 15.6, 15.7>, <8.3, 18, 27.3> }
  #for (I, 0, 6)
    box { <-4.1 + I * 2, 16.2, 14>, <-3.1 + I * 2, 18, 29> }
    box { <-6, 16.2, 15.9 + I * 2>, <10, 18, 16.9 + I * 2> }
  #end
  #for (I, 0, 2)
    object { Arch(1.2, 1.6, 2.8, 14, 17) translate <-1.9 + I * 4, 11, 0> }
    object { Arch(1.0, 1.4, 2.2, 14, 17) translate <-1.9 + I * 4, 6.4, 0> }
  #end
  Arch(1.7, 2.2, 3.3, 14, 17)
  Masonry(Stone * 1.04)
}
prism { // its roof, within the battlements
  linear_sweep
  linear_spline
  16, 27, 4, <-4.2, 15.6>, <8.2, 15.6>, <2, 21.5>, <-4.2, 15.6>
  matrix <1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0>
  Matt(Slate)
}
box { // a banner on its pole
  <1.9, 21, 15.9>, <2.1, 26.5, 16.1>
  Matt(Oak)
}
polygon {
  6, <0, 0>, <4.2, -0.5>, <3, -1.2>, <4.2, -2>, <0, -2.3>, <0, 0>
  translate <2.1, 26.3, 16>
  Matt(srgb <0.75, 0.16, 0.15>)
}

// -- the bridge to the gate, and the ground around a ditch --------------------------------------------
union {
  #for (I, 0, 17)
    box { <-2, -0.25, -17.9 + I * 0.75>, <2, 0, -17.2 + I * 0.75> }
  #end
  #for (S, -1, 1, 2)
    box { <S * 1.9 - 0.1, -0.6, -18>, <S * 1.9 + 0.1, -0.25, -4> }
    box { <S * 1.9 - 0.07, 0.95, -17.5>, <S * 1.9 + 0.07, 1.1, -4.5> }
    #for (I, 0, 5)
      box { <S * 1.9 - 0.07, -0.5, -17 + I * 2.4>, <S * 1.9 + 0.07, 1.0, -16.86 + I * 2.4> }
    #end
  #end
  Matt(Oak * 1.3)
}
difference {
  plane { y, -0.02 }
  prism { // the ditch along x, its banks sloping
    linear_sweep
    linear_spline
    -200, 200, 5, <-0.1, -5.5>, <-0.1, -17>, <2.6, -14>, <2.6, -8.5>, <-0.1, -5.5>
    rotate z * -90
  }
  Matt(srgb <0.46, 0.53, 0.31>)
}
plane { // its water
  y, -1.9
  Matt(srgb <0.33, 0.43, 0.46>)
}
