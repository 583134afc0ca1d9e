// SPDX-License-Identifier: AGPL-3.0-or-later
//
// A gallery of solids, each cut from another material.
//
// Tests: procedural textures, which only POV-Ray can evaluate: wood, marble, checker, granite,
//   agate, brick, hexagon, leopard, crackle, spotted, and bumps in normals, on spheres, a cone, a
//   torus, boxes, a lathe and a superellipsoid; beside them plain things, whose colour must not be
//   asked for. Sharp shadows of two lights fall across all of it. The hexagons of the floor, of
//   three marbles, mirror weakly; so does a dark pane in the corner, flat both.
// Should be seen: a hall with a brick wall behind an arch, a hexagon floor, and on plinths from left
//   to right a wooden baluster, an agate ball, a granite obelisk in the middle, a marble ring, and a
//   chequered cube on its corner; in front a bumpy golden ball, a plain white egg and a box of wood.
// Camera: aspect 4:3, meant for 640x480 and up.
//
// Units are metres; x right, y up, z into the hall.

#version 3.7;

global_settings {
  assumed_gamma 1.0
  max_trace_level 4
}

background { color srgb <0.46, 0.47, 0.46> }

camera {
  location <-0.35, 1.75, -6.3>
  right x * 4 / 3
  angle 50
  look_at <-0.05, 1.25, 0>
}

light_source {
  <-3.6, 5.2, -4.4>
  color rgb <1.0, 0.93, 0.82> * 0.95
}

light_source {
  <2.4, 4.3, -3.6>
  color rgb <0.70, 0.82, 1.0> * 0.40
}

#declare Fill = rgb <0.18, 0.18, 0.20>;
#declare Dull = finish { ambient Fill diffuse 0.74 }
#declare Polished = finish {
  ambient Fill
  diffuse 0.70
  specular 0.45
  roughness 0.012
}
#macro Matt(C)
  texture {
    pigment { color C }
    finish { Dull }
  }
#end

// ---------------------------------------------------------------------------------------------
// Materials
// ---------------------------------------------------------------------------------------------
#declare WhiteMarble = pigment {
  marble
  turbulence 0.9
  octaves 5
  color_map {
    [0.00 srgb <0.93, 0.92, 0.89>]
    [0.55 srgb <0.88, 0.87, 0.85>]
    [0.82 srgb <0.70, 0.70, 0.72>]
    [0.92 srgb <0.45, 0.46, 0.50>]
    [1.00 srgb <0.86, 0.85, 0.83>]
  }
  rotate <10, 35, 25>
  scale 0.35
}
#declare GreenMarble = pigment {
  marble
  turbulence 1.1
  octaves 6
  color_map {
    [0.00 srgb <0.10, 0.22, 0.19>]
    [0.60 srgb <0.17, 0.35, 0.29>]
    [0.85 srgb <0.30, 0.48, 0.40>]
    [0.95 srgb <0.75, 0.83, 0.74>]
    [1.00 srgb <0.14, 0.29, 0.24>]
  }
  rotate <20, 60, 15>
  scale 0.25
}
#declare RedMarble = pigment {
  marble
  turbulence 0.8
  octaves 5
  color_map {
    [0.00 srgb <0.60, 0.40, 0.33>]
    [0.60 srgb <0.66, 0.47, 0.38>]
    [0.90 srgb <0.78, 0.65, 0.55>]
    [1.00 srgb <0.52, 0.33, 0.28>]
  }
  rotate <0, 20, 50>
  scale 0.30
}
#declare Oak = pigment {
  wood
  turbulence <0.05, 0.05, 0.5>
  octaves 4
  color_map {
    [0.0 srgb <0.70, 0.49, 0.29>]
    [0.5 srgb <0.62, 0.41, 0.22>]
    [0.9 srgb <0.43, 0.26, 0.14>]
    [1.0 srgb <0.70, 0.49, 0.29>]
  }
  scale <0.07, 0.07, 0.8>
}
#declare Agate = pigment {
  agate
  agate_turb 0.9
  color_map {
    [0.00 srgb <0.97, 0.90, 0.80>]
    [0.35 srgb <0.86, 0.58, 0.36>]
    [0.60 srgb <0.58, 0.24, 0.17>]
    [0.80 srgb <0.94, 0.82, 0.70>]
    [1.00 srgb <0.30, 0.12, 0.12>]
  }
  scale 0.33
}
#declare Granite = pigment {
  granite
  color_map {
    [0.00 srgb <0.16, 0.15, 0.17>]
    [0.30 srgb <0.50, 0.42, 0.42>]
    [0.55 srgb <0.72, 0.58, 0.55>]
    [0.80 srgb <0.86, 0.80, 0.77>]
    [1.00 srgb <0.30, 0.28, 0.30>]
  }
  scale 0.6
}

// ---------------------------------------------------------------------------------------------
// The hall
// ---------------------------------------------------------------------------------------------
#macro Flag(P)
  texture {
    pigment { P }
    finish { Dull reflection 0.13 }
  }
#end
plane {
  y, 0
  texture {
    hexagon
    Flag(WhiteMarble),
    Flag(GreenMarble),
    Flag(RedMarble)
    scale 0.42
    rotate y * 12
  }
}

// A plastered wall with an arch, and bricks seen through it.
difference {
  union {
    box { <-5, 0, 1.7>, <5, 4.6, 2.0> }
    box { <-5, 0, 1.66>, <5, 0.24, 1.7> }
  }
  box { <-1.45, -1, 1>, <1.45, 2.0, 3> }
  cylinder { <0, 2.0, 1>, <0, 2.0, 3>, 1.45 }
  Matt(srgb <0.74, 0.71, 0.64>)
}
#declare Voussoirs = texture {
  pigment {
    radial
    frequency 42
    color_map {
      [0.07 srgb <0.46, 0.44, 0.40>]
      [0.07 srgb <0.82, 0.80, 0.75>]
    }
    rotate x * 90
    translate y * 2
  }
  finish { Dull }
}
union { // the arch's stones
  difference {
    cylinder { <0, 2.0, 1.64>, <0, 2.0, 2.0>, 1.68 }
    cylinder { <0, 2.0, 1>, <0, 2.0, 3>, 1.44 }
    box { <-3, -1, 1>, <3, 2.0, 3> }
    texture { Voussoirs }
  }
  #for (Side, -1, 1, 2)
    box {
      <1.44 * Side, 0, 1.64>, <1.68 * Side, 2.0, 2.0>
      texture {
        pigment {
          brick
          color srgb <0.46, 0.44, 0.40>,
          color srgb <0.82, 0.80, 0.75>
          brick_size <2, 0.25, 2>
          mortar 0.015
          translate <0.5, 0, 0.5>
        }
        finish { Dull }
      }
    }
  #end
}
box {
  <-3, 0, 3.1>, <3, 4.6, 3.3>
  texture {
    pigment {
      brick
      color srgb <0.72, 0.68, 0.62>,
      color srgb <0.58, 0.27, 0.20>
      brick_size <0.30, 0.10, 0.15>
      mortar 0.014
    }
    finish { Dull }
  }
  texture { // weathered
    pigment {
      spotted
      turbulence 0.4
      color_map {
        [0.3 srgbt <0, 0, 0, 1>]
        [0.8 srgbt <0.12, 0.08, 0.06, 0.45>]
      }
      scale 0.35
    }
    finish { Dull }
  }
}

box { <3.05, 0, -9>, <3.25, 4.6, 2> Matt(srgb <0.50, 0.55, 0.56>) }

union { // a dark pane that leans in the corner
  box {
    <-0.62, 0.08, 0>, <0.62, 2.25, 0.02>
    texture {
      pigment { color srgb <0.20, 0.22, 0.24> }
      finish { ambient Fill diffuse 0.55 reflection 0.45 }
    }
  }
  difference {
    box { <-0.70, 0, -0.03>, <0.70, 2.33, 0.04> }
    box { <-0.62, 0.08, -1>, <0.62, 2.25, 1> }
    texture {
      pigment { Oak rotate x * 90 }
      finish { Polished }
    }
  }
  rotate x * 4
  rotate y * -50
  translate <-2.98, 0, 0.90>
}

// ---------------------------------------------------------------------------------------------
// The solids
// ---------------------------------------------------------------------------------------------
#macro Plinth(High, Turned, Where)
  union {
    box { <-0.30, 0, -0.30>, <0.30, 0.08, 0.30> }
    box { <-0.25, 0.08, -0.25>, <0.25, High - 0.07, 0.25> }
    box { <-0.29, High - 0.07, -0.29>, <0.29, High, 0.29> }
    Matt(srgb <0.70, 0.68, 0.64>)
    rotate y * Turned
    translate Where
  }
#end

#declare LeftBack = <-1.85, 0, 0.45>;
#declare LeftFront = <-1.12, 0, -0.55>;
#declare Middle = <0.05, 0, 0.55>;
#declare RightFront = <1.12, 0, -0.45>;
#declare RightBack = <2.08, 0, 0.75>;

Plinth(0.75, 8, LeftBack)
lathe { // a baluster, turned from oak
  cubic_spline
  17,
  <0.00, -0.05>, <0.00, 0.00>, <0.20, 0.00>, <0.21, 0.06>, <0.16, 0.10>, <0.09, 0.16>, <0.07, 0.24>,
  <0.13, 0.38>, <0.19, 0.52>, <0.16, 0.68>, <0.08, 0.84>, <0.06, 0.98>, <0.10, 1.04>, <0.11, 1.10>,
  <0.07, 1.14>, <0.00, 1.16>, <0.00, 1.20>
  sturm
  texture {
    pigment { Oak rotate x * 86 rotate y * 30 translate <0.05, 0, 0.02> }
    finish { Polished }
  }
  translate LeftBack + 0.75 * y
}

Plinth(0.85, -10, LeftFront)
sphere {
  0, 0.31
  texture {
    pigment { Agate rotate <30, 20, 0> }
    finish { Polished }
  }
  translate LeftFront + (0.85 + 0.305) * y
}

Plinth(0.62, 14, Middle)
union { // an obelisk
  prism {
    conic_sweep linear_spline
    0.62, 1, 5, <-0.24, -0.24>, <0.24, -0.24>, <0.24, 0.24>, <-0.24, 0.24>, <-0.24, -0.24>
    scale <1, -3.7, 1>
    translate y * 3.7
  }
  prism {
    conic_sweep linear_spline
    0, 1, 5, <-0.149, -0.149>, <0.149, -0.149>, <0.149, 0.149>, <-0.149, 0.149>, <-0.149, -0.149>
    scale <1, -0.2, 1>
    translate y * 1.606
  }
  texture {
    pigment { Granite }
    finish { Polished }
  }
  rotate y * 38
  translate Middle + 0.62 * y
}

Plinth(0.72, 6, RightFront)
torus {
  0.27, 0.105
  texture {
    pigment { GreenMarble }
    finish { Polished }
  }
  rotate x * 90
  rotate y * 28
  translate RightFront + (0.72 + 0.37) * y
}

Plinth(0.80, -12, RightBack)
box { // a cube on its corner
  -0.27, 0.27
  texture {
    pigment {
      checker
      color srgb <0.90, 0.87, 0.78>,
      color srgb <0.16, 0.15, 0.17>
      translate <0.5, 0.5, 0.5>
      scale 0.1351
    }
    finish { Dull }
  }
  rotate <45, 0, 0>
  rotate z * degrees(atan2(1, sqrt(2)))
  rotate y * 25
  translate RightBack + (0.80 + 0.27 * sqrt(3)) * y
}

// On the floor
sphere {
  0, 0.30
  texture {
    pigment { color srgb <0.85, 0.66, 0.27> }
    normal { bumps 0.7 scale 0.055 }
    finish { ambient Fill diffuse 0.6 specular 0.7 roughness 0.02 metallic }
  }
  translate <-0.30, 0.30, -1.75>
}
sphere { // plain
  0, 1
  Matt(srgb <0.92, 0.90, 0.86>)
  scale <0.19, 0.25, 0.19>
  translate <0.62, 0.25, -1.55>
}
cone { <-2.35, 0, -0.7>, 0.27, <-2.35, 0.72, -0.7>, 0 Matt(srgb <0.72, 0.30, 0.22>) } // plain
union { // a box of wood, its lid ajar; the grain runs along each board
  box {
    <-0.38, 0, -0.24>, <0.38, 0.26, 0.24>
    texture {
      pigment { Oak rotate y * 88 translate y * 0.9 }
      finish { Dull }
    }
  }
  box {
    <-0.41, 0, -0.27>, <0.41, 0.04, 0.27>
    texture {
      pigment { Oak rotate y * 87 rotate x * 2 translate <0, 0.3, 0.2> }
      finish { Dull }
    }
    rotate z * 5
    rotate y * 9
    translate y * 0.29
  }
  rotate y * -22
  translate <1.75, 0, -1.35>
}
superellipsoid { // a leopard cushion of stone
  <0.6, 0.5>
  scale <0.26, 0.12, 0.2>
  texture {
    pigment {
      leopard
      turbulence 0.3
      color_map {
        [0.1 srgb <0.20, 0.15, 0.12>]
        [0.5 srgb <0.83, 0.68, 0.42>]
        [1.0 srgb <0.90, 0.78, 0.55>]
      }
      scale 0.018
    }
    finish { Dull }
  }
  rotate y * 25
  translate <-1.35, 0.12, -1.75>
}
sphere { // crackled glaze
  0, 0.17
  texture {
    pigment {
      crackle
      color_map {
        [0.04 srgb <0.12, 0.17, 0.22>]
        [0.10 srgb <0.55, 0.72, 0.74>]
        [1.00 srgb <0.70, 0.84, 0.83>]
      }
      scale 0.07
    }
    finish { Polished }
  }
  translate <0.22, 0.17, -0.85>
}
