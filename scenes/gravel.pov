// SPDX-License-Identifier: AGPL-3.0-or-later
//
// A dry garden: a bed of pebbles, a verge of grass and fallen leaves beside smooth sand and a pool.
//
// Tests: places too busy for any mesh. Some 7,600 pebbles, 2,600 blades of grass and 240 leaves are
//   as small as pixels, none of them textured: there is nothing to interpolate, and every pixel there
//   has to be traced, in squares. Beside them lie calm areas, where almost none has to be: smooth
//   sand, three large stones, a wall, a still pool that mirrors weakly. The borders between busy and
//   calm are what a previewer should find. One low sun, so pebbles shade each other.
// Should be seen: a path of grey and white pebbles that winds from the lower left to a gate in a
//   plastered wall, a pool at the right with a rim of stones, sand with three boulders at the left,
//   grass along the wall, red leaves strewn over path, sand and water.
// Camera: aspect 4:3, meant for 640x480 and up.
// Options: Declare=Share=0.2 strews a fifth of it all.
//
// Units are metres; x right, y up, z away.

#version 3.7;

#ifndef (Share)
  #declare Share = 1;
#end

global_settings {
  assumed_gamma 1.0
  max_trace_level 4
}

camera {
  location <-0.6, 2.6, -5.4>
  right x * 4 / 3
  angle 52
  look_at <-0.05, 0.52, 0.2>
}

light_source {
  <-22, 20, -13>
  color rgb <1.0, 0.92, 0.78> * 1.15
}

background { color srgb <0.62, 0.74, 0.85> }

#declare Dice = seed(1998);
#macro Between(A, B) (A + (B - A) * rand(Dice)) #end
#declare Light = finish { ambient rgb <0.20, 0.22, 0.26> diffuse 0.75 }
#macro Matt(C)
  texture {
    pigment { color C }
    finish { Light }
  }
#end

// ---------------------------------------------------------------------------------------------
// Calm: sand, wall, pool, boulders
// ---------------------------------------------------------------------------------------------
#declare Sand = srgb <0.83, 0.77, 0.65>;
#declare PoolAt = <1.75, 0, -0.75>;
#declare PoolR = <1.15, 1, 0.85>;
#declare PoolX = PoolAt.x;
#declare PoolZ = PoolAt.z;
#declare PoolRX = PoolR.x;
#declare PoolRZ = PoolR.z;

difference {
  box { <-12, -0.5, -8>, <12, 0, 3> }
  cylinder { <0, -0.3, 0>, <0, 1, 0>, 1 scale PoolR translate PoolAt }
  Matt(Sand)
}
cylinder { // water
  <0, -0.4, 0>, <0, -0.045, 0>, 1
  scale PoolR * 1.05
  translate PoolAt
  texture {
    pigment { color srgb <0.13, 0.22, 0.25> }
    finish { ambient 0.2 diffuse 0.5 specular 0.4 roughness 0.002 reflection { 0.12, 0.7 fresnel } }
  }
  interior { ior 1.33 }
}
difference { // the wall with a round gate
  box { <-9, -0.6, 3>, <9, 1.8, 3.3> }
  cylinder { <0.5, 0.78, 2>, <0.5, 0.78, 4>, 0.8 }
  Matt(srgb <0.88, 0.85, 0.79>)
}
prism { // its roof
  linear_spline
  -9, 9, 4, <-1.8, -0.3>, <-1.8, 0.3>, <-2.0, 0>, <-1.8, -0.3>
  rotate z * -90
  translate <0, 0, 3.15>
  Matt(srgb <0.32, 0.34, 0.37>)
}
plane { y, -0.6 Matt(srgb <0.42, 0.50, 0.30>) }
sphere { 0, 1 scale <16, 2.9, 9> translate <-9, -0.6, 24> Matt(srgb <0.33, 0.44, 0.34>) } // hills beyond
sphere { 0, 1 scale <18, 3.6, 9> translate <14, -0.6, 33> Matt(srgb <0.42, 0.53, 0.52>) }

#macro Boulder(Where, Size, Turn, C)
  blob {
    threshold 0.5
    sphere { <0, 0, 0>, 1.3, 1 scale <1, 0.8, 0.8> }
    sphere { <0.55, 0.1, 0.1>, 1.0, 0.8 }
    sphere { <-0.5, -0.1, 0.2>, 1.0, 0.7 }
    sphere { <0.1, 0.45, -0.1>, 0.8, 0.6 }
    scale Size
    rotate y * Turn
    translate Where
    Matt(C)
  }
#end
Boulder(<-2.55, 0.16, 0.75>, <0.60, 0.75, 0.55>, 20, srgb <0.44, 0.45, 0.46>)
Boulder(<-1.72, 0.10, 0.02>, <0.34, 0.36, 0.36>, 110, srgb <0.50, 0.48, 0.46>)
Boulder(<-2.75, 0.08, -0.65>, <0.22, 0.24, 0.24>, 65, srgb <0.40, 0.42, 0.44>)

// ---------------------------------------------------------------------------------------------
// Busy: pebbles, grass, leaves
// ---------------------------------------------------------------------------------------------

// The middle of the path at depth z, and half its width there.
#declare PathX = function(z) { 0.05 - 0.52 * cos(0.72 * z + 0.35) + 0.17 * z }
#declare PathHalf = function(z) { 0.62 - 0.03 * z }
#declare Inside = function(x, z) { // below 1 in the pool
  pow((x - PoolX) / PoolRX, 2) + pow((z - PoolZ) / PoolRZ, 2)
}

#declare Greys = array[16];
#for (I, 0, 15)
  #declare Greys[I] = pigment {
    color srgb Between(0.30, 0.92) * <Between(0.97, 1.06), 1, Between(0.90, 1.03)>
  }
#end

#macro Pebble(X, Z, Size)
  sphere {
    0, 1
    scale Size * <0.8 + 0.6 * rand(Dice), 0.55 + 0.25 * rand(Dice), 1>
    rotate y * 180 * rand(Dice)
    translate <X, Size * (0.1 + 0.6 * rand(Dice)), Z>
    pigment { Greys[int(16 * rand(Dice))] }
  }
#end

union {
  #for (I, 1, 6400 * Share)
    #local Z = Between(-4.6, 3.6);
    #local Across = Between(-1, 1);
    Pebble(PathX(Z) + PathHalf(Z) * Across, Z, Between(0.018, 0.038))
  #end
  #for (I, 1, 1200 * Share) // the rim of the pool
    #local A = Between(0, 2 * pi);
    #local R = Between(0.98, 1.16);
    Pebble(PoolAt.x + R * PoolR.x * cos(A), PoolAt.z + R * PoolR.z * sin(A), Between(0.02, 0.05))
  #end
  finish { Light }
}

#macro Blade(X, Z, High)
  #local Lean = <0.8 * rand(Dice) - 0.4, 0, 0.6 * rand(Dice) - 0.4> * High;
  #local Side = vrotate(x * (0.008 + 0.006 * rand(Dice)), y * 180 * rand(Dice));
  #local Foot = <X, 0, Z>;
  #local Knee = Foot + Lean * 0.35 + y * High * 0.6;
  #local Tip = Foot + Lean + y * High;
  triangle { Foot - Side, Foot + Side, Knee + Side * 0.7 }
  triangle { Foot - Side, Knee + Side * 0.7, Knee - Side * 0.7 }
  triangle { Knee - Side * 0.7, Knee + Side * 0.7, Tip }
#end
#macro Tuft(N, X0, X1, Z0, Z1, C)
  mesh {
    #for (I, 1, N * Share)
      #local X = X0 + (X1 - X0) * rand(Dice);
      #local Z = Z0 + (Z1 - Z0) * rand(Dice);
      #if (abs(X - PathX(Z)) > PathHalf(Z) * 0.97 & Inside(X, Z) > 1.1)
        Blade(X, Z, 0.16 + 0.26 * rand(Dice))
      #end
    #end
    Matt(C)
  }
#end
Tuft(1100, -5.0, 5.0, 2.35, 2.98, srgb <0.34, 0.48, 0.17>)
Tuft(900, -5.0, 5.0, 2.45, 2.98, srgb <0.52, 0.60, 0.25>)
Tuft(900, 2.0, 3.6, 0.2, 1.6, srgb <0.42, 0.55, 0.20>)

#declare Palette = array[4] { <0.75, 0.22, 0.12>, <0.86, 0.42, 0.14>, <0.62, 0.14, 0.12>, <0.88, 0.60, 0.20> };
union { // maple leaves: five points each
  #for (I, 1, 240 * Share)
    #local X = Between(-3.4, 3.2);
    #local Z = Between(-3.6, 2.4);
    polygon {
      11
      #for (K, 0, 10)
        #local A = K * pi / 5;
        #local R = (mod(K, 2) = 0 ? 0.075 : 0.030);
        , <R * cos(A), 0, R * sin(A)>
      #end
      rotate <Between(-25, 25), Between(0, 360), Between(-25, 25)>
      scale Between(0.7, 1.25)
      translate <X, (Inside(X, Z) < 1 ? -0.02 : 0.06), Z>
      pigment { color srgb Palette[int(Between(0, 3.99))] * Between(0.8, 1.1) }
    }
  #end
  finish { Light }
}
