// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Hills under a low sun, as terrain programs write them: meshes of triangles.
//
// Tests: smooth and flat meshes beside each other. Of the smooth hills only the silhouettes and the
//   shadows are edges of the picture, not the thousands of edges between their triangles; of the
//   faceted rocks and trees every edge is. Shadows of the jagged ridge fall over smooth ground
//   across hundreds of triangles. About 7,400 triangles; parallel light.
// Should be seen: rolling green hills in front of a faceted range of mountains, boulders and fir
//   trees of few triangles, and a flat lake; the sun stands low on the left and everything throws
//   long shadows.
// Camera: aspect 4:3, meant for 640x480 and up.
// Options: Declare=Untextured=1 gives the hills one colour instead of meadows and woods.
//
// Units are metres; x right, y up, z into the picture.

#version 3.7;

#ifndef (Untextured)
  #declare Untextured = 0;
#end

global_settings { assumed_gamma 1.0 }

camera {
  location <0, 21, -62>
  right x * 4 / 3
  angle 54
  look_at <2, 9.5, 20>
}

light_source {
  <-300, 118, -60>
  color rgb <1.0, 0.86, 0.66> * 1.3
  parallel
  point_at <0, 0, 0>
}

background { color srgb <0.66, 0.76, 0.86> }

#declare Dice = seed(42);
#macro Between(A, B) (A + (B - A) * rand(Dice)) #end
#declare Light = finish { ambient rgb <0.17, 0.19, 0.24> diffuse 0.75 }
#macro Matt(C)
  texture {
    pigment { color C }
    finish { Light }
  }
#end

// Height of the hills above (X, Z).
#macro Hill(X, Z)
  (3.2 * sin(0.085 * X + 0.6) * cos(0.07 * Z) + 1.6 * sin(0.17 * Z + 0.11 * X)
   + 0.7 * sin(0.31 * X - 0.2 * Z) + 0.03 * (Z + 40) + 2.2 * (X * X + 300) / 2500)
#end
#macro HillNormal(X, Z)
  vnormalize(<Hill(X - 0.05, Z) - Hill(X + 0.05, Z), 0.1, Hill(X, Z - 0.05) - Hill(X, Z + 0.05)>)
#end

// -- smooth hills ------------------------------------------------------------------------------
#declare N = 48;
#declare P = array[N + 1][N + 1];
#declare V = array[N + 1][N + 1];
#for (I, 0, N)
  #for (J, 0, N)
    #local X = -60 + 120 * I / N;
    #local Z = -58 + 110 * J / N;
    #declare P[I][J] = <X, Hill(X, Z), Z>;
    #declare V[I][J] = HillNormal(X, Z);
  #end
#end
mesh {
  #for (I, 0, N - 1)
    #for (J, 0, N - 1)
      smooth_triangle { P[I][J], V[I][J], P[I + 1][J], V[I + 1][J], P[I + 1][J + 1], V[I + 1][J + 1] }
      smooth_triangle { P[I][J], V[I][J], P[I + 1][J + 1], V[I + 1][J + 1], P[I][J + 1], V[I][J + 1] }
    #end
  #end
  texture {
    #if (Untextured)
      pigment { color srgb <0.48, 0.56, 0.30> }
    #else
      pigment {
        bozo
        color_map {
          [0.45 color srgb <0.50, 0.58, 0.30>]
          [0.60 color srgb <0.62, 0.60, 0.34>]
          [0.75 color srgb <0.36, 0.48, 0.27>]
        }
        scale 9
      }
    #end
    finish { Light }
  }
}

// -- a faceted range behind ----------------------------------------------------------------------
#declare NX = 26;
#declare NZ = 9;
#declare R = array[NX + 1][NZ + 1];
#for (I, 0, NX)
  #for (J, 0, NZ)
    #local X = -95 + 190 * I / NX + Between(-2, 2);
    #local T = J / NZ;
    #local Z = 48 + 60 * T + Between(-2, 2);
    #local Bulge = sin(pi * min(1, T * 1.15));
    #declare R[I][J] = <X, -2 + Bulge * (14 + 13 * abs(sin(0.051 * X + 1.1)) + Between(-4.5, 5.5)), Z>;
  #end
#end
#declare Snow = Matt(srgb <0.93, 0.94, 0.97>)
#declare Rock = Matt(srgb <0.56, 0.51, 0.49>)
#macro Facet(A, B, C)
  triangle {
    A, B, C
    #if (min(A.y, B.y, C.y) > 18) texture { Snow } #else texture { Rock } #end
  }
#end
mesh {
  #for (I, 0, NX - 1)
    #for (J, 0, NZ - 1)
      Facet(R[I][J], R[I + 1][J], R[I + 1][J + 1])
      Facet(R[I][J], R[I + 1][J + 1], R[I][J + 1])
    #end
  #end
}

// -- boulders and firs --------------------------------------------------------------------------
// A boulder: a ring of points between a top and a buried bottom.
#macro Boulder(S)
  #local M = 7;
  #local Ring = array[M + 1];
  #local Brow = array[M + 1];
  #for (I, 0, M - 1)
    #local A = 2 * pi * I / M;
    #local Ring[I] = <cos(A), -0.2, sin(A)> * S * Between(0.9, 1.2);
    #local Brow[I] = <cos(A + 0.3) * 0.7, 0.55, sin(A + 0.3) * 0.7> * S * Between(0.8, 1.15);
  #end
  #local Ring[M] = Ring[0];
  #local Brow[M] = Brow[0];
  #local Top = <0.1, 0.85, 0> * S;
  mesh {
    #for (I, 0, M - 1)
      triangle { Ring[I], Ring[I + 1], Brow[I] }
      triangle { Ring[I + 1], Brow[I + 1], Brow[I] }
      triangle { Brow[I], Brow[I + 1], Top }
    #end
  }
#end
// A fir: three pyramids on a trunk.
#macro Fir(S)
  union {
    box { <-0.12, -0.3, -0.12> * S, <0.12, 0.8, 0.12> * S Matt(srgb <0.36, 0.26, 0.20>) }
    mesh {
      #for (K, 0, 2)
        #local Y = 0.6 + 0.85 * K;
        #local W = 1.15 - 0.27 * K;
        #for (I, 0, 5)
          #local A0 = pi / 3 * I + K;
          #local A1 = pi / 3 * (I + 1) + K;
          triangle {
            <W * cos(A0), Y, W * sin(A0)> * S, <W * cos(A1), Y, W * sin(A1)> * S, <0, Y + 1.5, 0> * S
          }
          triangle { <W * cos(A0), Y, W * sin(A0)> * S, <W * cos(A1), Y, W * sin(A1)> * S, <0, Y, 0> * S }
        #end
      #end
      Matt(srgb <0.17, 0.34, 0.24> * Between(0.8, 1.3))
    }
    rotate y * Between(0, 60)
  }
#end
#for (I, 0, 44)
  #local X = Between(-42, 44);
  #local Z = Between(-30, 40);
  object { Fir(Between(1.2, 2.4)) translate <X, Hill(X, Z), Z> }
#end
#for (I, 0, 22)
  #local X = Between(-24, 24);
  #local Z = Between(-44, 10);
  object { Boulder(Between(0.5, 1.7)) translate <X, Hill(X, Z), Z> Matt(srgb <0.60, 0.58, 0.55>) }
#end

// -- a lake in the hollow --------------------------------------------------------------------------
polygon {
  5, <-70, -60>, <70, -60>, <70, 60>, <-70, 60>, <-70, -60>
  rotate x * 90
  translate y * -0.2
  texture {
    pigment { color srgb <0.30, 0.42, 0.52> }
    finish { ambient rgb <0.17, 0.19, 0.24> diffuse 0.5 }
  }
}
