// SPDX-License-Identifier: AGPL-3.0-or-later
//
// A chess board in the Italian game, two pawns already off.
//
// Tests: textures where samples are dear. Pieces turned from wood and cut from marble stand on a
//   board of two woods with a frame, all procedural and each piece with a grain of its own; an area
//   light throws penumbrae over the squares, the board and the marble mirror, so a sample costs many
//   times what the colour of a surface costs. What is known of texture without light is worth most
//   here.
// Should be seen: a board turned a little, light pieces of wood nearer, dark marble beyond; the two
//   captured pawns to the right, one of them fallen, on a table of slate; soft light from the left.
// Camera: aspect 4:3, meant for 640x480 and up.
//
// One unit is one square; x right, y up, z from white to black; the board's top is y = 0. The area
// light is not jittered, so that every pixel has one value, whatever the order of rendering.

#version 3.7;

global_settings {
  assumed_gamma 1.0
  max_trace_level 5
  adc_bailout 0.02
}

camera {
  location <-3.4, 6.2, -10.8>
  right x * 4 / 3
  angle 45
  look_at <0.25, 0.1, -0.55>
}

light_source {
  <-10, 13, 2>
  color rgb <1.0, 0.94, 0.84> * 1.15
  area_light <2.4, 0, -0.8>, <0.7, 1.9, 1.6>, 7, 7
  adaptive 1
}

light_source { // what the room gives back
  <9, 11, -13>
  color rgb <0.72, 0.82, 1.0> * 0.22
  shadowless
}

sky_sphere { // what the polish shows
  pigment {
    gradient y
    color_map {
      [0.0 srgb <0.30, 0.28, 0.27>]
      [0.6 srgb <0.62, 0.62, 0.62>]
      [1.0 srgb <0.92, 0.90, 0.86>]
    }
  }
}

#declare Dice = seed(64);
#macro Between(A, B) (A + (B - A) * rand(Dice)) #end
#declare Fill = rgb <0.15, 0.15, 0.16>;
#declare Waxed = finish {
  ambient Fill
  diffuse 0.74
  specular 0.30
  roughness 0.02
  reflection { 0.01, 0.10 }
}
#declare Polished = finish {
  ambient Fill
  diffuse 0.66
  specular 0.6
  roughness 0.006
  reflection { 0.05, 0.35 }
}

// ---------------------------------------------------------------------------------------------
// Materials
// ---------------------------------------------------------------------------------------------
#macro Timber(Light, Dark)
  pigment {
    wood
    turbulence <0.10, 0.10, 1.2>
    octaves 4
    omega 0.55
    color_map {
      [0.00 color Light]
      [0.40 color Light * 0.8 + Dark * 0.2]
      [0.85 color Light * 0.3 + Dark * 0.7]
      [0.97 color Dark]
      [1.00 color Light]
    }
    scale <0.12, 0.12, 1.6>
  }
#end
#declare Maple = texture {
  Timber(srgb <0.90, 0.76, 0.54>, srgb <0.81, 0.64, 0.42>)
  finish { Waxed }
}
#declare Walnut = texture {
  Timber(srgb <0.42, 0.25, 0.15>, srgb <0.22, 0.12, 0.08>)
  finish { Waxed }
}
#declare Boxwood = texture {
  Timber(srgb <0.93, 0.77, 0.50>, srgb <0.78, 0.55, 0.30>)
  finish { Waxed }
}
#declare Marble = texture {
  pigment {
    marble
    turbulence 1.0
    octaves 5
    lambda 2.2
    color_map {
      [0.00 srgb <0.08, 0.15, 0.14>]
      [0.55 srgb <0.13, 0.25, 0.22>]
      [0.82 srgb <0.22, 0.36, 0.31>]
      [0.93 srgb <0.66, 0.74, 0.67>]
      [1.00 srgb <0.10, 0.19, 0.17>]
    }
    scale 0.42
  }
  finish { Polished }
}
#declare Slate = texture {
  pigment {
    granite
    color_map {
      [0.0 srgb <0.19, 0.20, 0.23>]
      [0.5 srgb <0.27, 0.28, 0.31>]
      [1.0 srgb <0.36, 0.36, 0.38>]
    }
    scale 2.5
  }
  finish { ambient Fill diffuse 0.7 reflection { 0.02, 0.15 } }
}

// ---------------------------------------------------------------------------------------------
// Pieces, one square wide at most
// ---------------------------------------------------------------------------------------------

// The foot all pieces share, and a stem that narrows to Waist and ends at High with a collar.
#macro Stem(Foot, Waist, High)
  union {
    sor {
      10,
      <Foot * 0.98, -0.05>, <Foot, 0.00>, <Foot, 0.07>, <Foot * 0.84, 0.13>, <Foot * 0.80, 0.17>,
      <Waist * 1.45, 0.12 + 0.30 * High>, <Waist, 0.06 + 0.65 * High>, <Waist, High - 0.03>, <Waist * 1.25, High>,
      <Waist * 1.4, High + 0.05>
    }
    torus { Foot * 0.93, 0.05 translate y * 0.055 }
    torus { Waist * 1.15, 0.045 translate y * High }
    torus { Waist * 0.95, 0.035 translate y * (High - 0.085) }
    cylinder { <0, High - 0.02, 0>, <0, High + 0.03, 0>, Waist * 1.3 }
  }
#end

#declare Pawn = union {
  Stem(0.29, 0.115, 0.50)
  sphere { <0, 0.66, 0>, 0.175 }
}
#declare Rook = union {
  Stem(0.34, 0.19, 0.58)
  difference {
    cone { <0, 0.58, 0>, 0.20, <0, 0.90, 0>, 0.27 }
    cylinder { <0, 0.79, 0>, <0, 1, 0>, 0.175 }
    #for (I, 0, 2)
      box { <-0.055, 0.80, -1>, <0.055, 1, 1> rotate y * 60 * I }
    #end
  }
}
#declare Bishop = union {
  Stem(0.32, 0.13, 0.74)
  difference {
    sphere { 0, 1 scale <0.175, 0.26, 0.175> translate y * 0.99 }
    box { <-1, -0.022, -1>, <1, 0.022, 0> rotate x * -52 translate <0, 1.05, -0.02> }
  }
  sphere { <0, 1.265, 0>, 0.05 }
}
#declare Queen = union {
  Stem(0.36, 0.145, 0.98)
  difference {
    cone { <0, 0.98, 0>, 0.13, <0, 1.26, 0>, 0.245 }
    cone { <0, 1.12, 0>, 0.08, <0, 1.30, 0>, 0.215 }
    #for (I, 0, 7)
      sphere { <0.25, 1.285, 0>, 0.062 rotate y * 45 * I }
    #end
  }
  sphere { 0, 1 scale <0.17, 0.12, 0.17> translate y * 1.19 }
  sphere { <0, 1.345, 0>, 0.055 }
}
#declare King = union {
  Stem(0.37, 0.155, 1.06)
  cone { <0, 1.06, 0>, 0.14, <0, 1.34, 0>, 0.235 }
  sphere { 0, 1 scale <0.235, 0.075, 0.235> translate y * 1.34 }
  box { <-0.035, 1.38, -0.03>, <0.035, 1.64, 0.03> }
  box { <-0.105, 1.475, -0.0301>, <0.105, 1.545, 0.0301> }
}

// The knight's head is sawn from a board and its cheeks are rounded; it looks towards +x.
#declare Knight = union {
  Stem(0.33, 0.17, 0.34)
  difference {
    intersection {
      prism {
        cubic_spline
        -0.17, 0.17, 19,
        <-0.20, 0.42>,
        <-0.17, 0.34>, <0.18, 0.34>, <0.20, 0.42>, <0.12, 0.54>, <0.06, 0.66>, <0.13, 0.70>,
        <0.26, 0.66>, <0.33, 0.70>, <0.32, 0.78>, <0.22, 0.88>, <0.14, 0.98>, <0.07, 1.10>,
        <0.02, 1.00>, <-0.10, 0.95>, <-0.20, 0.82>, <-0.24, 0.60>,
        <-0.17, 0.34>, <0.18, 0.34>
        rotate x * -90
      }
      sphere { 0, 1 scale <0.62, 0.62, 0.185> translate <0.02, 0.62, 0> }
    }
    sphere { <0.12, 0.885, -0.16>, 0.036 }
    sphere { <0.12, 0.885, 0.16>, 0.036 }
    box { <0.20, 0.715, -1>, <0.5, 0.728, 1> rotate z * 4 }
  }
}

// ---------------------------------------------------------------------------------------------
// The position, as seen by white; capitals are white
// ---------------------------------------------------------------------------------------------
#declare Ranks = array[8] {
  "r.bq.rk.",
  "ppp..pp.",
  ".bnp.n.p",
  "........",
  "..BPP...",
  ".....N..",
  "PP...PPP",
  "RNBQ.RK."
}

#macro Put(Shape, White, Where, Turn)
  object {
    Shape
    #if (White)
      texture {
        Boxwood
        rotate x * Between(80, 100)
        rotate y * Between(0, 360)
        translate <Between(-0.2, 0.2), Between(-9, 9), Between(-0.2, 0.2)>
      }
    #else
      texture {
        Marble
        rotate <Between(0, 360), Between(0, 360), 0>
        translate <Between(-9, 9), Between(-9, 9), Between(-9, 9)>
      }
    #end
    rotate Turn
    translate Where
  }
#end

#for (Row, 0, 7)
  #for (File, 0, 7)
    #local Letter = substr(Ranks[Row], File + 1, 1);
    #local Where = <File - 3.5 + Between(-0.04, 0.04), 0, 3.5 - Row + Between(-0.04, 0.04)>;
    #local White = (strcmp(Letter, strupr(Letter)) = 0);
    #local Turn = (White ? -25 : 150) + Between(-18, 18);
    #switch (asc(strupr(Letter)))
      #case (asc("P")) Put(Pawn, White, Where, y * Turn) #break
      #case (asc("R")) Put(Rook, White, Where, y * Turn) #break
      #case (asc("N")) Put(Knight, White, Where, y * Turn) #break
      #case (asc("B")) Put(Bishop, White, Where, y * Turn) #break
      #case (asc("Q")) Put(Queen, White, Where, y * Turn) #break
      #case (asc("K")) Put(King, White, Where, y * Turn) #break
    #end
  #end
#end

// ---------------------------------------------------------------------------------------------
// Board and table
// ---------------------------------------------------------------------------------------------
box { // inlaid squares: the grain runs along the files in one wood and across in the other
  <-4, -0.3, -4>, <4, 0, 4>
  texture {
    checker
    texture { Walnut rotate y * 90 rotate z * 1.5 translate <0, 0.07, 0.3> },
    texture { Maple rotate x * 2 translate <0.2, 0.07, 0> }
    translate <0, 0.5, 0>
  }
}
#for (I, 0, 3)
  intersection { // mitred
    box { <-4.7, -0.36, -4.7>, <4.7, 0.06, -4.0> }
    plane { <1, 0, 1>, 0 }
    plane { <-1, 0, 1>, 0 }
    texture { Walnut rotate y * 90 translate <I * 3, 0.25, 0.37> }
    rotate y * 90 * I
  }
#end
box { <-4.03, -0.3, -4.03>, <4.03, 0.012, 4.03> // a line of maple round the squares
  texture { Maple translate y * 0.4 }
  clipped_by { box { <-4.001, -1, -4.001>, <4.001, 1, 4.001> inverse } }
}
plane { y, -0.36 texture { Slate } }

Put(Pawn, 0, <5.3, -0.36, 0.4>, y * 20)
Put(Pawn, 1, <5.2, -0.08, 1.6>, <93, 65, 0>)
