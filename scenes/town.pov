// SPDX-License-Identifier: AGPL-3.0-or-later
//
// A small town in the morning, seen from the air without perspective.
//
// Tests: an orthographic camera and a parallel light, under which neither the eye nor the sun is a
//   point: some 130 houses of boxes and prisms (gables, hips), chimneys, a church with a pyramid on
//   its tower, a town wall with battlements. Outlines in three directions, over and over; long
//   shadows across roofs and streets, many of them thin.
// Should be seen: streets between rows of houses with red, brown and slate roofs around a market
//   square with a church and stalls; every shadow falls the same way.
// Camera: aspect 4:3, meant for 640x480 and up.
// Options: Declare=Untextured=1 leaves out the pavement of the square and the courses of the wall.
//
// Units are metres; x east, y up, z north. Houses stand on y = 0.

#version 3.7;

#ifndef (Untextured)
  #declare Untextured = 0;
#end

global_settings { assumed_gamma 1.0 }

camera {
  orthographic
  location <-60, 90, -110>
  right x * 136
  up y * 102
  look_at <0, 0, 2>
}

light_source {
  <120, 95, -70>
  color rgb <1.0, 0.93, 0.80> * 1.25
  parallel
  point_at <0, 0, 0>
}

background { color srgb <0.45, 0.53, 0.36> }

#declare Dice = seed(1997);
#macro Between(A, B) (A + (B - A) * rand(Dice)) #end

#macro Matt(C)
  texture {
    pigment { color C }
    finish { ambient rgb <0.23, 0.25, 0.30> diffuse 0.72 }
  }
#end

#declare Walls = array[5] {
  srgb <0.93, 0.89, 0.80>, srgb <0.88, 0.78, 0.62>, srgb <0.85, 0.72, 0.62>,
  srgb <0.80, 0.80, 0.76>, srgb <0.92, 0.84, 0.66>
}
#declare Roofs = array[4] {
  srgb <0.66, 0.30, 0.22>, srgb <0.58, 0.36, 0.26>, srgb <0.40, 0.43, 0.48>, srgb <0.71, 0.38, 0.26>
}
#declare Leaves = array[2] { srgb <0.36, 0.24, 0.17>, srgb <0.28, 0.34, 0.40> } // door, windows
#declare Stone = srgb <0.74, 0.71, 0.64>;

// A roof whose ridge runs along x, over W x D with eaves E, R high; Hip: its ends slope too.
//
//          ______            ridge
//         /      \  R
//        /________\          eaves, E out over the walls on every side
//
#macro Roof(W, D, R, Hip)
  #if (Hip)
    #local X = W / 2 + 0.4;
    #local Z = D / 2 + 0.4;
    #local I = X - min(X, Z) * 0.9;
    mesh {
      triangle { <-X, 0, -Z>, <X, 0, -Z>, <I, R, 0> }
      triangle { <-X, 0, -Z>, <I, R, 0>, <-I, R, 0> }
      triangle { <-X, 0, Z>, <X, 0, Z>, <I, R, 0> }
      triangle { <-X, 0, Z>, <I, R, 0>, <-I, R, 0> }
      triangle { <X, 0, -Z>, <X, 0, Z>, <I, R, 0> }
      triangle { <-X, 0, -Z>, <-X, 0, Z>, <-I, R, 0> }
    }
  #else
    prism {
      linear_sweep
      linear_spline
      -W / 2 - 0.35, W / 2 + 0.35, 4,
      <-D / 2 - 0.4, 0>, <D / 2 + 0.4, 0>, <0, R>, <-D / 2 - 0.4, 0>
      rotate z * -90 // the sweep runs along x ...
      rotate x * -90 // ... and the gable's height upwards
    }
  #end
#end

#macro House(W, D, H)
  #local R = D * Between(0.38, 0.55);
  union {
    box {
      <-W / 2, 0, -D / 2>, <W / 2, H, D / 2>
      Matt(Walls[int(5 * rand(Dice))])
    }
    object {
      Roof(W, D, R, (rand(Dice) < 0.3))
      translate y * H
      Matt(Roofs[int(4 * rand(Dice))] * Between(0.85, 1.1))
    }
    #local C = <W * Between(-0.3, 0.3), H + R * 0.3, D * 0.12>;
    box {
      C - <0.4, 0, 0.4>, C + <0.4, R * 0.7 + 0.7, 0.4>
      Matt(srgb <0.55, 0.38, 0.32>)
    }
    // door and windows stand out a little from the front
    #for (I, 0, 2)
      #local X = (I - 1) * W * 0.3;
      box {
        <X - 0.45, (I = 1 ? 0 : 1.0), -D / 2 - 0.1>, <X + 0.45, 2.2, -D / 2>
        Matt(Leaves[(I = 1 ? 0 : 1)])
      }
    #end
  }
#end

// Rows of houses around the square, back to back.
#for (Row, -5, 5)
  #local Z = Row * 11;
  #local X = -62;
  #while (X < 60)
    #local W = Between(6, 10);
    #local Square = (abs(X + W / 2) < 19 & abs(Z) < 17);
    #local Street = (abs(mod(abs(X + W / 2), 34) - 17) > 14.5);
    #if (!Square & !Street)
      object {
        House(W - 0.2, Between(5.5, 7), Between(3, 6.5))
        #if (mod(abs(Row), 2)) rotate y * 180 #end
        translate <X + W / 2, 0, Z + Between(-0.4, 0.4)>
      }
    #end
    #local X = X + W;
  #end
#end

box {
  <-200, -1, -200>, <200, 0, 200>
  Matt(srgb <0.66, 0.62, 0.54>)
}

box { // the square
  <-17, 0, -14>, <17, 0.15, 14>
  texture {
    #if (Untextured)
      pigment { color srgb <0.78, 0.74, 0.66> }
    #else
      pigment { checker color srgb <0.80, 0.76, 0.68>, color srgb <0.74, 0.70, 0.62> scale 2 }
    #end
    finish { ambient rgb <0.23, 0.25, 0.30> diffuse 0.72 }
  }
}

union { // the church: nave, aisles, apse of a hexagon, tower with a spire
  box { <-9, 0, -3.5>, <7, 8, 3.5> Matt(Stone) }
  object { Roof(16, 7, 5.5, 0) translate <-1, 8, 0> Matt(Roofs[2]) }
  box { <-7.5, 0, -6>, <5, 4, 6> Matt(Stone * 0.95) }
  prism {
    linear_sweep linear_spline 0, 7, 7,
    <7, -3>, <9.6, -1.5>, <9.6, 1.5>, <7, 3>, <6, 1.5>, <6, -1.5>, <7, -3>
    Matt(Stone)
  }
  box { <-13.5, 0, -2.5>, <-8.5, 16, 2.5> Matt(Stone) }
  mesh {
    #local P = array[5] { <-2.8, 0, -2.8>, <2.8, 0, -2.8>, <2.8, 0, 2.8>, <-2.8, 0, 2.8>, <-2.8, 0, -2.8> }
    #for (I, 0, 3)
      triangle { P[I], P[I + 1], <0, 12, 0> }
    #end
    translate <-11, 16, 0>
    Matt(Roofs[2])
  }
  #for (I, -2, 2)
    #for (S, -1, 1, 2)
      box { <I * 2.4 - 0.35, 0, S * 6 - 0.5>, <I * 2.4 + 0.35, 3.2, S * 6 + 0.5> Matt(Stone * 0.9) }
    #end
  #end
  rotate y * 12
  translate <2, 0.15, 4>
}

#for (I, 0, 8) // market stalls
  union {
    #local C = srgb <Between(0.5, 0.9), Between(0.3, 0.8), Between(0.2, 0.5)>;
    object { Roof(2.2, 2.4, 0.8, 0) translate y * 2.2 Matt(C) }
    #for (X, -1, 1, 2)
      #for (Z, -1, 1, 2)
        box { <X - 0.08, 0, Z - 0.08>, <X + 0.08, 2.2, Z + 0.08> Matt(srgb <0.5, 0.4, 0.3>) }
      #end
    #end
    box { <-1.1, 0.7, -0.9>, <1.1, 0.85, 0.2> Matt(srgb <0.6, 0.5, 0.36>) }
    translate <-13 + mod(I, 5) * 5.6, 0.15, -10.5 + 4.2 * int(I / 5)>
  }
#end

union { // the wall in front
  box { <-90, 0, -68>, <90, 5, -66> }
  #for (X, -90, 89, 1.8)
    box { <X, 5, -68>, <X + 1.0, 6, -66.6> }
  #end
  #for (X, -60, 60, 30)
    box { <X - 3, 0, -70>, <X + 3, 8.5, -64> }
    #for (I, -1, 1)
      box { <X + 2 * I - 0.6, 8.5, -70>, <X + 2 * I + 0.6, 9.5, -69.4> }
      box { <X + 2 * I - 0.6, 8.5, -64.6>, <X + 2 * I + 0.6, 9.5, -64> }
    #end
  #end
  texture {
    #if (Untextured)
      pigment { color Stone }
    #else
      pigment { brick color Stone * 0.8, color Stone brick_size <2, 0.9, 1> mortar 0.08 }
    #end
    finish { ambient rgb <0.23, 0.25, 0.30> diffuse 0.72 }
  }
}
