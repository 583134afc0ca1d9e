// SPDX-License-Identifier: AGPL-3.0-or-later
//
// A workshop corner as modelling programs write it: nothing but loose triangles.
//
// Tests: a soup without shared points, edges or normals. Walls and table tops are cut into
//   triangles of uneven size whose corners lie in the middle of neighbours' edges (T-junctions);
//   coplanar neighbours of one surface must not draw edges across it. Some triangles come twice,
//   some are slivers, parts go through one another, and the corners of parts are rounded to tenths
//   of millimetres, so that neighbours do not meet exactly. About 3,600 triangles.
// Should be seen: a workbench with a vice, boxes and a toolbox, a stool, a shelf with crates and
//   planks leaning on the wall beside a ladder; one lamp, so clear shadows; walls without any seam.
// Camera: aspect 4:3, meant for 640x480 and up.
// Options: Declare=Untextured=1 makes the floor plain.
//
// Units are metres; x right, y up, z into the picture.

#version 3.7;

#ifndef (Untextured)
  #declare Untextured = 0;
#end

global_settings { assumed_gamma 1.0 }

camera {
  location <1.9, 1.75, -2.7>
  right x * 4 / 3
  angle 58
  look_at <0.15, 0.95, 0.5>
}

light_source {
  <1.5, 2.6, -0.9>
  color rgb <1.0, 0.94, 0.84> * 0.95
}

#declare Dice = seed(7);
#macro Between(A, B) (A + (B - A) * rand(Dice)) #end
#declare Light = finish { ambient rgb <0.24, 0.25, 0.27> diffuse 0.72 }
#macro Matt(C)
  texture {
    pigment { color C }
    finish { Light }
  }
#end

#macro Tenths(P)
  <floor(P.x * 10000 + 0.5), floor(P.y * 10000 + 0.5), floor(P.z * 10000 + 0.5)> / 10000
#end

// A parallelogram A, A + U, A + U + V, A + V in Depth times 2 triangles: cut into two unequal parts
// again and again, now across, now along, so that corners of one part lie on edges of the other.
//
//      .-----.---------.
//      |   .'|       .'|
//      | .'  |-----.'--|     <- T-junctions
//      .'----|  .'     |
//      |  .' |.'       |
//      '-----'---------'
//
#macro Cut(A, U, V, Depth)
  #if (Depth > 1)
    #local T = Between(0.3, 0.7);
    #local First = int(Depth / 2);
    #if (vlength(U) > vlength(V))
      Cut(A, U * T, V, First)
      Cut(A + U * T, U * (1 - T), V, Depth - First)
    #else
      Cut(A, U, V * T, First)
      Cut(A + V * T, U, V * (1 - T), Depth - First)
    #end
  #else
    #if (rand(Dice) < 0.5)
      triangle { A, A + U, A + U + V }
      triangle { A, A + U + V, A + V }
    #else
      triangle { A, A + U, A + V }
      triangle { A + U, A + U + V, A + V }
    #end
    #if (rand(Dice) < 0.06)
      triangle { A, A + U, A + V } // drawn twice, as copies in models are
    #end
  #end
#end

// A block of three pairs of parallelograms from the corner O; each side cut into Depth parts.
#macro Part(O, U, V, W, Depth)
  Cut(O, U, V, Depth)
  Cut(O + W, U, V, Depth)
  Cut(O, U, W, Depth)
  Cut(O + V, U, W, Depth)
  Cut(O, V, W, Depth)
  Cut(O + U, V, W, Depth)
#end
#macro Block(A, B, Depth)
  Part(Tenths(A), (B.x - A.x) * x, (B.y - A.y) * y, (B.z - A.z) * z, Depth)
#end

// -- the room -----------------------------------------------------------------------------------
mesh {
  Cut(<-2.5, 0, -4>, 6 * x, 5.6 * z, 60)
  texture {
    #if (Untextured)
      pigment { color srgb <0.58, 0.55, 0.51> }
    #else
      pigment {
        brick color srgb <0.47, 0.38, 0.30>, color srgb <0.62, 0.49, 0.36>
        brick_size <0.9, 0.4, 0.14> mortar 0.006
      }
    #end
    finish { Light }
  }
}
mesh { Cut(<-2.5, 0, 1.6>, 6 * x, 2.8 * y, 50) Matt(srgb <0.80, 0.79, 0.72>) }
mesh { Cut(<-2.5, 0, -4>, 5.6 * z, 2.8 * y, 40) Matt(srgb <0.62, 0.71, 0.72>) }
mesh { // skirting
  Block(<-2.5, 0, 1.57>, <3.5, 0.1, 1.61>, 12)
  Block(<-2.51, 0, -4>, <-2.47, 0.1, 1.6>, 12)
  Matt(srgb <0.90, 0.88, 0.82>)
}

// -- the bench ----------------------------------------------------------------------------------
mesh {
  Block(<-0.9, 0.82, 0.72>, <1.3, 0.88, 1.5>, 14)
  Block(<-0.82, 0.30, 0.84>, <1.22, 0.33, 1.42>, 8)
  #for (I, 0, 3)
    #local X = -0.84 + 1.98 * mod(I, 2);
    #local Z = 0.78 + 0.58 * int(I / 2);
    Block(<X, 0, Z>, <X + 0.1, 0.83, Z + 0.08>, 4) // goes into the top
  #end
  Matt(srgb <0.73, 0.55, 0.36>)
}
mesh { // the vice
  Block(<-0.62, 0.80, 0.62>, <-0.36, 0.95, 0.66>, 3)
  Block(<-0.62, 0.80, 0.53>, <-0.36, 0.95, 0.57>, 3)
  Block(<-0.51, 0.84, 0.42>, <-0.47, 0.88, 0.74>, 3)
  Block(<-0.60, 0.85, 0.43>, <-0.38, 0.87, 0.45>, 2)
  Matt(srgb <0.25, 0.37, 0.52>)
}
mesh { // a toolbox with a handle
  Block(<0.45, 0.88, 0.92>, <1.0, 1.06, 1.2>, 4)
  Block(<0.43, 1.06, 0.90>, <1.02, 1.09, 1.22>, 4)
  Block(<0.56, 1.09, 1.05>, <0.59, 1.19, 1.08>, 2)
  Block(<0.86, 1.09, 1.05>, <0.89, 1.19, 1.08>, 2)
  Block(<0.54, 1.17, 1.045>, <0.91, 1.2, 1.085>, 2)
  Matt(srgb <0.72, 0.20, 0.16>)
}
#for (I, 0, 5) // tins
  #local X = -0.16 + 0.13 * mod(I, 3) + Between(0, 0.02);
  #local Z = 1.0 + 0.16 * int(I / 3);
  #local R = 0.05;
  #local H = Between(0.08, 0.19);
  mesh {
    #for (K, 0, 8)
      #local A = Tenths(<R * cos(K * 2 * pi / 9), 0, R * sin(K * 2 * pi / 9)>) + <X, 0.88, Z>;
      #local B = Tenths(<R * cos((K + 1) * 2 * pi / 9), 0, R * sin((K + 1) * 2 * pi / 9)>) + <X, 0.88, Z>;
      triangle { A, B, B + y * H }
      triangle { A, B + y * H, A + y * H }
      triangle { A + y * H, B + y * H, <X, 0.88 + H, Z> }
    #end
    Matt(srgb <Between(0.3, 0.9), Between(0.4, 0.8), Between(0.2, 0.6)>)
  }
#end
mesh { // boxes below
  Block(<-0.6, 0.33, 0.9>, <-0.1, 0.62, 1.3>, 5)
  Block(<0.1, 0.33, 0.95>, <0.5, 0.52, 1.35>, 5)
  Block(<0.55, 0.33, 0.88>, <0.95, 0.70, 1.3>, 5)
  Matt(srgb <0.67, 0.60, 0.46>)
}

// -- shelf with crates -----------------------------------------------------------------------------
mesh {
  #for (I, 0, 1)
    Block(<-1.1, 1.42 + 0.42 * I, 1.3>, <1.5, 1.45 + 0.42 * I, 1.6>, 10)
    #for (J, 0, 2)
      Block(<-1.0 + 1.17 * J, 1.28 + 0.42 * I, 1.34>, <-0.96 + 1.17 * J, 1.43 + 0.42 * I, 1.6>, 2)
    #end
  #end
  Matt(srgb <0.52, 0.37, 0.26>)
}
#for (I, 0, 13)
  #local X = -1.02 + 0.36 * mod(I, 7) + Between(-0.02, 0.02);
  #local Y = 1.45 + 0.42 * int(I / 7);
  #local W = Between(0.18, 0.3);
  #local H = Between(0.12, 0.3);
  mesh {
    Part(
      <X, Y, 1.36>, <W * 0.99, 0, Between(-0.03, 0.03)>, y * H, <0.02, 0, Between(0.12, 0.18)>, 3
    )
    Matt(srgb <Between(0.35, 0.85), Between(0.35, 0.75), Between(0.25, 0.6)>)
  }
#end

// -- ladder, planks, stool -----------------------------------------------------------------------------
mesh {
  #local Lean = vnormalize(<0, 2.3, 0.62>);
  #local Deep = vnormalize(<0, -0.62, 2.3>);
  #for (S, 0, 1)
    Part(<-2.0 + 0.5 * S, 0, 0.9>, 0.045 * x, Lean * 2.36, Deep * 0.07, 6)
  #end
  #for (I, 1, 7)
    Part(<-1.99, 0, 0.9> + Lean * 0.31 * I, 0.53 * x, Lean * 0.035, Deep * 0.05, 3)
  #end
  Matt(srgb <0.86, 0.72, 0.40>)
}
#for (I, 0, 4)
  mesh {
    #local D = vnormalize(<Between(0.02, 0.12), 1, 0.22>);
    Part(
      <1.5 + 0.14 * I, 0, 1.12 + Between(0, 0.08)>, <0.11, 0, 0>, D * Between(1.4, 2.1),
      vnormalize(<0, -0.22, 1>) * 0.025, 5
    )
    Matt(srgb <0.80, 0.64, 0.44> * Between(0.8, 1.15))
  }
#end
mesh {
  #local N = 8;
  #for (K, 0, N - 1)
    #local A = <0.19 * cos(2 * pi * K / N), 0.5, 0.19 * sin(2 * pi * K / N)>;
    #local B = <0.19 * cos(2 * pi * (K + 1) / N), 0.5, 0.19 * sin(2 * pi * (K + 1) / N)>;
    triangle { A, B, <0, 0.5, 0> }
    triangle { A - y * 0.04, B - y * 0.04, <0, 0.46, 0> }
    triangle { A, B, A - y * 0.04 }
    triangle { B, B - y * 0.04, A - y * 0.04 }
  #end
  #for (K, 0, 2)
    #local A = <0.2 * cos(2.1 * K + 0.4), 0, 0.2 * sin(2.1 * K + 0.4)>;
    Part(A - <0.02, 0, 0.02>, 0.04 * x, <-A.x * 0.5, 0.49, -A.z * 0.5>, 0.04 * z, 4)
  #end
  translate <0.15, 0, -0.15>
  Matt(srgb <0.42, 0.50, 0.34>)
}

// -- shavings on the floor: slivers ------------------------------------------------------------------
mesh {
  #for (I, 0, 79)
    #local P = <Between(-0.9, 1.3), 0.002 + 0.0005 * I / 80, Between(-0.7, 0.7)>;
    #local A = Between(0, 2 * pi);
    triangle {
      P, P + <0.09 * cos(A), 0.012, 0.09 * sin(A)>, P + <0.085 * cos(A + 0.12), 0.004, 0.085 * sin(A + 0.12)>
    }
  #end
  Matt(srgb <0.93, 0.82, 0.60>)
}
