// SPDX-License-Identifier: AGPL-3.0-or-later
//
// A bench of samples whose colour is no single pigment.
//
// Tests: where albedo times illumination is not the whole story. Layered textures (dust on lacquer,
//   rust on paint), textures with filter (a window of stained glass, which colours its shadow) and
//   with transmit (a veil), texture_map between finishes from mirror to matt, pigment_map, averaged
//   pigments, material_map (a palette image chooses the texture), an image with alpha (leaves cut
//   out of an image made of a function), a floor of black and white tiles (where albedo is 0 the
//   light cannot be divided out), textures nested 20 deep, and a pane of glass in front of half of
//   it, so that the same things are seen twice as different.
// Should be seen: stained glass at the left throwing a coloured pattern on the chequered floor;
//   two rows of samples; a tile with the words of POV-Ray's povmap.png in gold on blue
//   lacquer; a twig with leaves against the wall; greenish glass before the right third.
// Camera: aspect 4:3, meant for 640x480 and up.
//
// povmap.png comes with POV-Ray's include files. Units are decimetres; x right, y up, z away.

#version 3.7;

global_settings {
  assumed_gamma 1.0
  max_trace_level 7
}

camera {
  location <0.6, 7.2, -19.5>
  right x * 4 / 3
  angle 44
  look_at <0.1, 2.35, 0>
}

light_source {
  <-10.5, 11.5, 5.2>
  color rgb <1.0, 0.94, 0.84> * 1.0
}

light_source {
  <9, 14, -16>
  color rgb <0.80, 0.87, 1.0> * 0.5
}

background { color srgb <0.55, 0.57, 0.60> }

#declare Fill = rgb <0.17, 0.17, 0.185>;
#declare Dull = finish { ambient Fill diffuse 0.74 }
#declare Gloss = finish {
  ambient Fill
  diffuse 0.68
  specular 0.5
  roughness 0.008
  reflection { 0.02, 0.25 }
}
#declare Mirror = finish { ambient 0.02 diffuse 0.10 specular 0.8 roughness 0.004 reflection 0.75 metallic }
#macro MattBody(C)
  pigment { color C }
  finish { Dull }
#end
#macro Matt(C)
  texture { MattBody(C) }
#end

// ---------------------------------------------------------------------------------------------
// Floor, wall
// ---------------------------------------------------------------------------------------------
plane {
  y, 0
  texture {
    pigment {
      checker
      color rgb 1,
      color rgb 0
      scale 1.6
      rotate y * 30
    }
    finish { Dull reflection 0.06 }
  }
}
plane { // plaster, its damp rising as an averaged pigment
  -z, -6
  texture {
    pigment {
      average
      pigment_map {
        [2 color srgb <0.78, 0.74, 0.68>]
        [1 bozo color_map { [0.3 srgb <0.70, 0.70, 0.66>] [0.7 srgb <0.86, 0.80, 0.72>] } scale 1.4]
        [1 gradient y color_map { [0 srgb <0.48, 0.50, 0.46>] [0.35 srgb <0.80, 0.76, 0.70>] } scale 12]
      }
    }
    finish { Dull }
  }
}

// ---------------------------------------------------------------------------------------------
// Textures
// ---------------------------------------------------------------------------------------------

// Lacquer over wood, dust over the lacquer.
#declare Lacquered =
  texture {
    pigment {
      wood
      turbulence 0.08
      color_map {
        [0.0 srgb <0.72, 0.45, 0.24>]
        [0.8 srgb <0.42, 0.22, 0.12>]
        [1.0 srgb <0.72, 0.45, 0.24>]
      }
      scale 0.32
      rotate <8, 70, 0>
    }
    finish { Dull }
  }
  texture { // what shines is red and lets the wood through
    pigment { color srgbf <1.0, 0.62, 0.48, 0.85> }
    finish { Gloss }
  }
  texture { // dust lies where the surface looks up
    pigment {
      slope { y }
      color_map {
        [0.70 srgbt <0.80, 0.79, 0.75, 1.0>]
        [0.95 srgbt <0.80, 0.79, 0.75, 0.1>]
      }
    }
    finish { Dull }
  }

// Rust under flaking paint: whole finishes differ, not colours alone.
#declare Rust = texture {
  pigment {
    granite
    color_map {
      [0.0 srgb <0.30, 0.13, 0.07>]
      [0.6 srgb <0.58, 0.29, 0.14>]
      [1.0 srgb <0.70, 0.42, 0.22>]
    }
    scale 0.7
  }
  normal { bumps 0.5 scale 0.05 }
  finish { Dull }
}
#declare Painted = texture {
  pigment { color srgb <0.16, 0.42, 0.48> }
  finish { Gloss }
}
#declare Chrome = texture {
  pigment { color srgb <0.86, 0.87, 0.90> }
  finish { Mirror }
}
#declare Flaking = texture {
  bozo
  turbulence 0.7
  texture_map {
    [0.46 Painted]
    [0.50 Rust]
    [0.72 Rust]
    [0.76 Chrome]
  }
  scale 0.9
}
#declare Banded = texture { // from a mirror to chalk without a step
  gradient y
  texture_map {
    [0.30 Chrome]
    [0.75 MattBody(srgb <0.88, 0.84, 0.74>)]
  }
  translate -y * 0.5
  scale 2.5
}

#declare Patched = texture {
  pigment {
    hexagon
    pigment { marble turbulence 0.7 color_map { [0 srgb <0.9, 0.88, 0.84>] [0.8 srgb <0.6, 0.6, 0.62>] [1 srgb <0.25, 0.26, 0.3>] } scale 0.4 },
    pigment { agate color_map { [0 srgb <0.86, 0.62, 0.35>] [1 srgb <0.45, 0.16, 0.12>] } scale 0.5 },
    pigment { checker srgb <0.20, 0.32, 0.42>, srgb <0.72, 0.78, 0.76> scale 0.13 }
    scale 0.42
    rotate <60, 20, 0>
  }
  finish { Gloss }
}
#declare Blended = texture {
  pigment {
    spherical
    pigment_map {
      [0.0 granite color_map { [0 srgb <0.15, 0.2, 0.25>] [1 srgb <0.7, 0.8, 0.85>] } scale 0.5]
      [0.5 leopard color_map { [0.2 srgb <0.12, 0.16, 0.10>] [0.8 srgb <0.80, 0.76, 0.42>] } scale 0.05]
      [1.0 wood turbulence 0.1 color_map { [0 srgb <0.8, 0.5, 0.3>] [1 srgb <0.4, 0.15, 0.1>] } scale 0.1]
    }
    scale 1.7
    translate <-0.5, 0.7, -1.0>
  }
  finish { Dull }
}

// Twenty textures, each in a map of the next: turn by turn the half nearer to the axis is again cut.
#macro Nested(Depth)
  #if (Depth = 0)
    pigment { color srgb <0.95, 0.78, 0.30> }
    finish { Gloss }
  #else
    #local Hue = 0.9 * Depth + <0, 2, 4>;
    gradient <cos(Depth * 1.1), sin(Depth * 1.1), 0>
    texture_map {
      [0.5 MattBody(srgb <0.5 + 0.35 * cos(Hue.x), 0.5 + 0.3 * cos(Hue.y), 0.5 + 0.3 * cos(Hue.z)>)]
      [0.5 Nested(Depth - 1)]
    }
    scale 0.90 // of its parent
    rotate z * 9
  #end
#end

// ---------------------------------------------------------------------------------------------
// Samples: three on plinths behind, four balls before
// ---------------------------------------------------------------------------------------------
#macro Plinth(X, Z, High)
  box { <X - 1.35, 0, Z - 1.35>, <X + 1.35, High, Z + 1.35> Matt(srgb <0.62, 0.61, 0.60>) }
#end
Plinth(-1.9, 2.6, 1.1)
Plinth(1.7, 2.6, 1.1)
Plinth(5.3, 2.6, 1.1)
sphere { 0, 1.25 texture { Lacquered } translate <-1.9, 2.35, 2.6> }
box {
  -1, 1
  texture { Flaking }
  rotate y * 33
  translate <1.7, 2.1, 2.6>
}
sphere { 0, 1.25 texture { Banded } translate <5.3, 2.35, 2.6> }

sphere { 0, 1.05 texture { Patched } rotate y * 20 translate <-1.0, 1.05, -1.4> }
sphere { 0, 1.05 texture { Blended } translate <0.75, 1.05, -4.0> }
sphere { 0, 1.05 texture { Nested(20) } translate <2.9, 1.05, -1.8> }

// Words chosen by a palette: material_map takes the texture with the number of the pixel's colour.
#declare Blue = texture {
  pigment { color srgb <0.12, 0.19, 0.40> }
  finish { Gloss }
}
#declare Gold = texture {
  pigment { color srgb <0.95, 0.75, 0.32> }
  finish { ambient 0.12 diffuse 0.4 specular 0.8 roughness 0.03 reflection 0.35 metallic }
}
#declare Cream = texture {
  pigment { marble turbulence 0.8 color_map { [0 srgb <0.9, 0.86, 0.76>] [1 srgb <0.62, 0.56, 0.46>] } scale 0.12 }
  finish { Dull }
}
#declare Black = texture {
  pigment { color rgb 0 }
  finish { Dull }
}
box {
  <0, 0, 0>, <1, 1, 0.06>
  texture {
    material_map {
      png "povmap.png"
      texture { Black }
      texture { Cream }
      texture { Gold }
      texture { Blue }
      texture { Cream }
      texture { Gold }
    }
  }
  translate -0.5 * x
  scale <3.4, 2.1, 2>
  rotate x * 18
  rotate y * -18
  translate <5.6, 0, -2.6>
}

// ---------------------------------------------------------------------------------------------
// Stained glass in a lead frame, at the left in the light's way
// ---------------------------------------------------------------------------------------------
#declare Stained = texture {
  pigment {
    crackle
    solid
    color_map {
      [0.30 srgbf <0.92, 0.14, 0.10, 0.92>]
      [0.42 srgbf <0.98, 0.78, 0.12, 0.92>]
      [0.52 srgbf <0.12, 0.50, 0.90, 0.92>]
      [0.62 srgbf <0.20, 0.72, 0.30, 0.92>]
      [0.75 srgbf <0.65, 0.20, 0.75, 0.92>]
    }
    scale 0.85
  }
  finish { ambient 0.12 diffuse 0.25 specular 0.3 roughness 0.01 }
}
#declare Leads = texture { // clear between the leads
  pigment {
    crackle
    color_map {
      [0.05 srgb <0.10, 0.10, 0.11>]
      [0.05 srgbt <0, 0, 0, 1>]
    }
    scale 0.85
  }
  finish { Dull }
}
union {
  polygon {
    5, <-2.4, 0.35, 0>, <2.4, 0.35, 0>, <2.4, 5.6, 0>, <-2.4, 5.6, 0>, <-2.4, 0.35, 0>
    texture { Stained }
    texture { Leads }
  }
  difference {
    box { <-2.6, 0, -0.14>, <2.6, 5.8, 0.14> }
    box { <-2.4, 0.35, -1>, <2.4, 5.6, 1> }
    Matt(srgb <0.23, 0.20, 0.18>)
  }
  rotate y * -24
  translate <-5.4, 0, 2.6>
}

// ---------------------------------------------------------------------------------------------
// Leaves: alpha of an image
// ---------------------------------------------------------------------------------------------
#declare Leaf = texture {
  pigment {
    image_map {
      function 160, 320 {
        pigment {
          function {
            // below 0 outside; else how far from the midrib, with side veins
            select(0.46 * pow(sin(pi * y), 0.8) * (1 - 0.35 * y) + 0.018 * sin(60 * y) - abs(x - 0.5), 0,
              0.2 + 0.8 * abs(x - 0.5) / 0.46 + 0.12 * sin(70 * y + 45 * abs(x - 0.5)))
          }
          color_map {
            [0.08 srgbt <0.2, 0.3, 0.1, 1>]
            [0.08 srgb <0.72, 0.80, 0.42>]
            [0.24 srgb <0.60, 0.72, 0.34>]
            [0.34 srgb <0.26, 0.48, 0.18>]
            [1.00 srgb <0.14, 0.34, 0.13>]
          }
        }
      }
      once
      interpolate 2
    }
  }
  finish { Dull }
}
#macro LeafAt(Where, Turn, Size)
  polygon {
    5, <0, 0, 0>, <1, 0, 0>, <1, 1, 0>, <0, 1, 0>, <0, 0, 0>
    texture { Leaf }
    translate <-0.5, 0, 0>
    scale <0.5, 1, 1> * Size
    rotate x * 14
    rotate z * Turn
    translate Where
  }
#end
#declare Twig = function(x) { 5.1 + 0.45 * sin(x * 0.55) }
sphere_sweep {
  cubic_spline
  9
  #for (I, -1, 7)
    , <-1.6 + I * 1.3, Twig(-1.6 + I * 1.3), 5.5>, 0.085 - 0.006 * I
  #end
  Matt(srgb <0.33, 0.23, 0.15>)
}
#for (I, 0, 8)
  #local X = -1.4 + 0.86 * I;
  LeafAt(<X, Twig(X), 5.4 - 0.03 * I>, (mod(I, 2) = 0 ? -38 : -150) + 11 * sin(I * 2), 1.75 - 0.06 * I)
#end

// ---------------------------------------------------------------------------------------------
// In front: a veil of transmit, and glass
// ---------------------------------------------------------------------------------------------
box {
  <3.9, 0, -5.9>, <7.4, 4.4, -5.75>
  texture {
    pigment { color rgbf <0.90, 0.98, 0.94, 0.95> }
    finish { ambient 0 diffuse 0.03 specular 0.6 roughness 0.003 reflection { 0.04, 0.6 fresnel } conserve_energy }
  }
  interior { ior 1.5 }
  rotate y * 6
}
polygon { // clear and milky stripes
  5, <-5.9, 0.0, -4.6>, <-3.9, 0.0, -5.2>, <-3.9, 1.8, -5.2>, <-5.9, 1.8, -4.6>, <-5.9, 0.0, -4.6>
  texture {
    pigment {
      gradient <1, 1, 0>
      color_map {
        [0.5 srgbt <0.95, 0.95, 0.97, 0.35>]
        [0.5 srgbt <0.95, 0.95, 0.97, 0.80>]
      }
      scale 0.6
    }
    finish { Dull }
  }
}
