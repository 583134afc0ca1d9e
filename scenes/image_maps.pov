// SPDX-License-Identifier: AGPL-3.0-or-later
//
// A map room: images on everything.
//
// Tests: image maps, all of them, so that a surface's colour at every pixel is known from the image
//   and the mapping alone. Planar (pictures, rug, floor, stamp), spherical (globe, ball),
//   cylindrical (columns, jar), toroidal (rings) and uv (the banner, a mesh2); once and repeated;
//   interpolation 2, 3, 4 and none of one small piece of an image (the four panels, left to right);
//   scaled, mirrored, sheared, turned and moved; images with a palette (files) and in true colour
//   (functions). Two lights throw sharp shadows over them all.
// Should be seen: a globe on a plinth with a stamp on its front, two pictures and four panels on the
//   wall behind, a banner that reads "Persistence of Vision" between them, columns, a rug, a crate
//   with rings, a jar and a ball. Of the panels only the last is of hard squares.
// Camera: aspect 4:3, meant for 640x480 and up.
//
// The images are those that come with POV-Ray's include files. Units are metres; x right, y up,
// z towards the wall.

#version 3.7;

global_settings { assumed_gamma 1.0 }

camera {
  location <0.25, 1.85, -5.3>
  right x * 4 / 3
  angle 50
  look_at <0.02, 1.27, 0>
}

light_source {
  <-3.4, 4.6, -5.0>
  color rgb <1.0, 0.93, 0.82> * 0.85
}

light_source {
  <3.6, 3.6, -3.4>
  color rgb <0.72, 0.84, 1.0> * 0.48
}

#declare Light = finish { ambient rgb <0.19, 0.19, 0.21> diffuse 0.75 }
#macro Matt(C)
  texture {
    pigment { color C }
    finish { Light }
  }
#end
#macro Printed(P)
  texture {
    pigment { P }
    finish { Light }
  }
#end

#declare Plaster = srgb <0.80, 0.77, 0.70>;
#declare Walnut = srgb <0.36, 0.23, 0.15>;
#declare Gilt = srgb <0.79, 0.63, 0.30>;
#declare Stone = srgb <0.78, 0.76, 0.72>;

// ---------------------------------------------------------------------------------------------
// Images in true colour, made from functions
// ---------------------------------------------------------------------------------------------

// One encaustic tile; its pattern goes on across its sides.
#declare TileWave = function(x, y) { cos(2 * pi * x) + cos(2 * pi * y) }
#declare Tile = pigment {
  image_map {
    function 128, 128 {
      pigment {
        function { 0.5 + TileWave(x, y) / 4 + 0.13 * cos(4 * pi * x) * cos(4 * pi * y) }
        color_map {
          [0.20 srgb <0.62, 0.33, 0.25>]
          [0.20 srgb <0.87, 0.82, 0.71>]
          [0.36 srgb <0.87, 0.82, 0.71>]
          [0.36 srgb <0.25, 0.34, 0.40>]
          [0.56 srgb <0.25, 0.34, 0.40>]
          [0.56 srgb <0.87, 0.82, 0.71>]
          [0.78 srgb <0.87, 0.82, 0.71>]
          [0.78 srgb <0.66, 0.50, 0.27>]
        }
      }
    }
    interpolate 2
  }
}

// A band that winds up the columns: once around is once across the image.
#declare Winding = pigment {
  image_map {
    function 256, 256 {
      pigment {
        function { abs(mod(4 * x + 4 * y + 0.03 * sin(24 * pi * y), 1)) }
        color_map {
          [0.12 srgb <0.72, 0.58, 0.30>]
          [0.12 srgb <0.86, 0.83, 0.76>]
          [0.50 srgb <0.86, 0.83, 0.76>]
          [0.50 srgb <0.72, 0.58, 0.30>]
          [0.62 srgb <0.72, 0.58, 0.30>]
          [0.62 srgb <0.30, 0.42, 0.45>]
        }
      }
    }
    map_type 2
    interpolate 2
  }
}

// A painted evening: sky, far hills, and water that shows both.
#declare Hills = function(x) { 0.44 + 0.07 * sin(9 * x) + 0.04 * sin(23 * x + 1) + 0.015 * sin(61 * x) }
#declare Evening = pigment {
  image_map {
    function 320, 200 {
      pigment {
        function {
          select(0.70 - y, 0.26 * (1 - y) / 0.30, // images have y downwards
            select(1 - y - Hills(x), 0.30, 0.40 + 0.55 * (0.64 - y) / 0.64
              + 0.02 * sin(40 * x + 9 * y) * sin(90 * y)))
        }
        color_map {
          [0.00 srgb <0.10, 0.15, 0.27>]
          [0.16 srgb <0.36, 0.33, 0.42>]
          [0.26 srgb <0.92, 0.60, 0.38>]
          [0.28 srgb <0.13, 0.14, 0.22>]
          [0.34 srgb <0.13, 0.14, 0.22>]
          [0.40 srgb <0.99, 0.83, 0.50>]
          [0.58 srgb <0.90, 0.50, 0.36>]
          [0.80 srgb <0.38, 0.36, 0.55>]
          [1.00 srgb <0.15, 0.21, 0.40>]
        }
      }
    }
    interpolate 3
  }
}

// Bars along the small circle of a torus, rings along the large one.
#declare Wound = pigment {
  image_map {
    function 240, 80 {
      pigment {
        function { mod(floor(24 * x) + floor(4 * y), 3) / 3 + 0.1 }
        color_map {
          [0.3 srgb <0.90, 0.86, 0.76>]
          [0.3 srgb <0.68, 0.24, 0.20>]
          [0.6 srgb <0.68, 0.24, 0.20>]
          [0.6 srgb <0.16, 0.24, 0.36>]
        }
      }
    }
    map_type 5
    interpolate 4
  }
}

// ---------------------------------------------------------------------------------------------
// The room
// ---------------------------------------------------------------------------------------------
polygon {
  5, <-6, 0, -8>, <6, 0, -8>, <6, 0, 1.9>, <-6, 0, 1.9>, <-6, 0, -8>
  Printed(
    pigment {
      Tile
      rotate x * 90
      scale 0.62
      translate <0.1, 0, 0.04>
    }
  )
}
box { <-6, 0, 1.9>, <6, 4.4, 2.1> Matt(Plaster) }
box { <-6, 0, 1.84>, <6, 0.16, 1.9> Matt(Walnut) }
box { <-6, 0.74, 1.87>, <6, 0.79, 1.9> Matt(Walnut) }

polygon { // a rug: turned, sheared, and stretched in one direction
  5, <-1.7, 0.006, -2.0>, <1.1, 0.006, -2.263>, <1.231, 0.006, -0.863>, <-1.569, 0.006, -0.6>,
  <-1.7, 0.006, -2.0>
  Printed(
    pigment {
      image_map { png "mtmandj.png" interpolate 2 }
      translate <-0.5, -0.5, 0>
      scale <2.812, 1.406, 1>
      rotate x * 90
      matrix <1, 0, -0.094, 0, 1, 0, 0.094, 0, 1, -0.235, 0.006, -1.43>
    }
  )
}

#macro Column(X)
  union {
    cylinder {
      <0, 0.3, 0>, <0, 3.3, 0>, 0.24
      Printed(
        pigment {
          Winding
          scale <1, 1.5, 1>
          translate y * 0.3
          rotate y * 40 * X
        }
      )
    }
    box { <-0.36, 0, -0.36>, <0.36, 0.2, 0.36> Matt(Stone) }
    cylinder { <0, 0.2, 0>, <0, 0.3, 0>, 0.31 Matt(Stone) }
    cylinder { <0, 2.95, 0>, <0, 3.05, 0>, 0.27 Matt(Stone) }
    translate <X, 0, 1.15>
  }
#end
Column(-2.62)
Column(2.62)

// ---------------------------------------------------------------------------------------------
// On the wall
// ---------------------------------------------------------------------------------------------

// A picture W wide and H high in a frame, its image filling it.
#macro Framed(P, W, H, Bar, Where)
  union {
    polygon {
      5, <-W / 2, -H / 2, -0.02>, <W / 2, -H / 2, -0.02>, <W / 2, H / 2, -0.02>,
      <-W / 2, H / 2, -0.02>, <-W / 2, -H / 2, -0.02>
      Printed(
        pigment {
          P
          translate <-0.5, -0.5, 0>
          scale <W, H, 1>
        }
      )
    }
    difference {
      box { <-W / 2 - Bar, -H / 2 - Bar, -0.05>, <W / 2 + Bar, H / 2 + Bar, 0> }
      box { <-W / 2, -H / 2, -1>, <W / 2, H / 2, 1> }
      Matt(Gilt)
    }
    translate Where
  }
#end
#macro File(Name, How)
  image_map { png Name #if (How > 0) interpolate How #end }
#end
Framed(pigment { File("bumpmap_.png", 0) }, 1.16, 0.74, 0.06, <-1.40, 2.24, 1.89>)
Framed(pigment { Evening }, 1.16, 0.74, 0.06, <1.40, 2.24, 1.89>)

// The same sixteen by sixteen pixels in each panel.
#declare Ways = array[4] { 2, 3, 4, 0 };
#for (I, 0, 3)
  Framed(
    pigment { File("mtmandj.png", Ways[I]) translate <-0.385, -0.80, 0> scale <20, 12.5, 1> translate 0.5 },
    0.50, 0.50, 0.03, <-1.71 + 0.62 * I + (I > 1 ? 1.56 : 0), 1.30, 1.89>
  )
#end

// The banner: u runs across the image, v up.
#declare Columns = 24;
#declare Rows = 16;
#macro Cloth(U, V)
  <-0.60 + 1.2 * U + 0.02 * sin(7 * V + 1), 2.24 + 0.74 * V + 0.02 * cos(8.5 * U),
    1.62 + (1.15 - V) * 0.10 * sin(9.5 * U + 2.2 * V)>
#end
#macro Swell(U, V)
  #local Step = 0.01;
  vnormalize(vcross(Cloth(U + Step, V) - Cloth(U - Step, V), Cloth(U, V + Step) - Cloth(U, V - Step)))
#end
#macro Grid(What)
  (Columns + 1) * (Rows + 1)
  #for (J, 0, Rows)
    #for (I, 0, Columns)
      , #switch (What)
          #case (0) Cloth(I / Columns, J / Rows) #break
          #case (1) Swell(I / Columns, J / Rows) #break
          #case (2) <I / Columns, J / Rows> #break
        #end
    #end
  #end
#end
mesh2 {
  vertex_vectors { Grid(0) }
  normal_vectors { Grid(1) }
  uv_vectors { Grid(2) }
  face_indices {
    2 * Columns * Rows
    #for (J, 0, Rows - 1)
      #for (I, 0, Columns - 1)
        #local A = J * (Columns + 1) + I;
        , <A, A + 1, A + Columns + 2>, <A, A + Columns + 2, A + Columns + 1>
      #end
    #end
  }
  texture {
    uv_mapping
    pigment { image_map { png "povmap.png" interpolate 2 } }
    finish { Light }
  }
}
cylinder { <-0.72, 3.0, 1.62>, <0.72, 3.0, 1.62>, 0.022 Matt(Gilt) }
sphere { <-0.72, 3.0, 1.62>, 0.045 Matt(Gilt) }
sphere { <0.72, 3.0, 1.62>, 0.045 Matt(Gilt) }

// ---------------------------------------------------------------------------------------------
// Globe on a plinth
// ---------------------------------------------------------------------------------------------
union {
  box {
    <-0.42, 0.08, -0.42>, <0.42, 0.84, 0.42>
    Matt(Stone)
  }
  box { // once: what lies outside the image stays clear
    <-0.42, 0.08, -0.4205>, <0.42, 0.84, -0.42>
    Matt(Stone)
    texture {
      pigment {
        image_map { png "test.png" once interpolate 2 }
        translate <-0.5, -0.5, 0>
        scale <0.48, 0.30, 1>
        rotate z * 8
        translate <0.02, 0.46, 0>
      }
      finish { Light }
    }
  }
  box { <-0.49, 0, -0.49>, <0.49, 0.08, 0.49> Matt(Stone) }
  box { <-0.48, 0.84, -0.48>, <0.48, 0.92, 0.48> Matt(Stone) }
  rotate y * -14
}
union {
  sphere {
    0, 0.44
    Printed(pigment { image_map { png "fract003.png" map_type 1 interpolate 2 } })
    rotate y * 105
  }
  torus { 0.49, 0.018 rotate x * 90 Matt(Gilt) }
  cylinder { <0, -0.5, 0>, <0, 0.5, 0>, 0.014 Matt(Gilt) }
  rotate <-6, 0, -23>
  translate <0, 1.55, 0>
}
union {
  cone { <0, 0.92, 0>, 0.20, <0, 0.98, 0>, 0.06 }
  cylinder { <0, 0.96, 0>, <0, 1.09, 0>, 0.035 }
  Matt(Walnut)
}

// ---------------------------------------------------------------------------------------------
// On the floor
// ---------------------------------------------------------------------------------------------
box { // a crate: the front shows the image, the other sides its columns or rows drawn out
  <-0.36, 0, -0.36>, <0.36, 0.72, 0.36>
  Printed(
    pigment {
      image_map { png "test.png" }
      scale <-0.36, 0.36, 1> // mirrored
    }
  )
  rotate y * 24
  translate <1.50, 0, 0.45>
}

#macro Ring(Major, Minor)
  torus {
    Major, Minor
    Printed(pigment { Wound scale Major })
  }
#end
object { Ring(0.36, 0.11) rotate x * -70 rotate y * 24 translate <1.93, 0.45, -0.06> }
object { Ring(0.30, 0.085) translate <1.22, 0.086, -0.82> }

union { // a jar
  cylinder {
    <0, 0.06, 0>, <0, 0.62, 0>, 0.21
    Printed(
      pigment {
        image_map { png "plasma3.png" map_type 2 interpolate 4 }
        scale <1, 0.56, 1>
        translate y * 0.06
        rotate y * 60
      }
    )
  }
  cone { <0, 0, 0>, 0.15, <0, 0.06, 0>, 0.21 Matt(Walnut) }
  cone { <0, 0.62, 0>, 0.21, <0, 0.72, 0>, 0.12 Matt(Walnut) }
  sphere { <0, 0.75, 0>, 0.06 Matt(Gilt) }
  translate <-1.55, 0, 0.35>
}
sphere {
  0, 0.24
  Printed(
    pigment {
      image_map { png "mtmandj.png" map_type 1 }
      rotate <30, 120, -25>
    }
  )
  translate <-1.0, 0.24, -0.35>
}
