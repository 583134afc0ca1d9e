// SPDX-License-Identifier: AGPL-3.0-or-later
//
// A chair and its reflection in a mirror, after the first figure of Pighin, Lischinski and
// Salesin (1997). Flat polygons only.
//
// Tests: outlines, hard shadows and one flat reflection, with nothing else in the way: a few
//   hundred polygons, one strong and one weak point light, plain colours. Thin slats and rods make
//   long straight edges, direct, in shadow, in the mirror, and in shadow in the mirror.
// Should be seen: a ladder-back chair half turned away, with a rush-coloured seat, on a bare
//   floor; its shadow falling towards the wall; a large mirror leaning there, slightly tilted,
//   in which the chair shows its other side and the room its other wall with a doorway.
// Camera: aspect 4:3, meant for 640x480 and up.
//
// Units are metres; x right, y up, z towards the wall that the mirror leans on.

#version 3.7;

global_settings {
  assumed_gamma 1.0
  max_trace_level 4
}

camera {
  location <2.05, 1.42, -2.35>
  right x * 4 / 3
  angle 44
  look_at <0.50, 0.67, 0.80>
}

light_source {
  <-2.1, 3.3, -2.0>
  color rgb <1.0, 0.94, 0.84> * 1.15
}

light_source {
  <2.6, 2.5, 1.0>
  color rgb <0.75, 0.85, 1.0> * 0.42
}

// ---------------------------------------------------------------------------------------------
// Materials
// ---------------------------------------------------------------------------------------------
#macro Plain(C)
  texture {
    pigment { color C }
    finish { ambient rgb <0.20, 0.21, 0.23> diffuse 0.78 }
  }
#end

#declare Wall = srgb <0.74, 0.79, 0.80>;
#declare FarWall = srgb <0.86, 0.80, 0.68>;
#declare Ground = srgb <0.72, 0.64, 0.54>;
#declare Lacquer = srgb <0.62, 0.22, 0.15>;
#declare Rush = srgb <0.88, 0.74, 0.46>;
#declare Gilt = srgb <0.70, 0.54, 0.28>;
#declare White = srgb <0.93, 0.92, 0.89>;

#declare MirrorGlass = texture {
  pigment { rgb 0.02 }
  finish { ambient 0 diffuse 0.5 reflection { rgb <0.90, 0.93, 0.92> } }
}

// ---------------------------------------------------------------------------------------------
// Building blocks; Faces counts flat polygons
// ---------------------------------------------------------------------------------------------
#declare Faces = 0;

#macro Block(A, B)
  box { A, B }
  #declare Faces = Faces + 6;
#end

#macro Quad(A, B, C, D)
  triangle { A, B, C }
  triangle { A, C, D }
  #declare Faces = Faces + 1;
#end

// A tapering rod from A (radius RA) to B (radius RB) over a regular N-gon, with flat ends.
#macro Taper(A, B, RA, RB, N)
  #local Up = vnormalize(B - A);
  #local Side = vcross(Up, (abs(Up.y) > 0.9 ? z : y));
  #local Side = vnormalize(Side);
  #local Third = vcross(Side, Up);
  mesh {
    #for (I, 0, N - 1)
      #local U0 = Side * cos(2 * pi * (I + 0.5) / N) + Third * sin(2 * pi * (I + 0.5) / N);
      #local U1 = Side * cos(2 * pi * (I + 1.5) / N) + Third * sin(2 * pi * (I + 1.5) / N);
      Quad(A + U0 * RA, A + U1 * RA, B + U1 * RB, B + U0 * RB)
      triangle { A, A + U0 * RA, A + U1 * RA }
      triangle { B, B + U0 * RB, B + U1 * RB }
    #end
  }
  #declare Faces = Faces + 2;
#end

// A slat bent back in plan and arched on top, between the posts at x = -Half and x = Half.
//
//   from above:  .                 .        from the front:    _.-----._
//                 '-._________.-'                             |_________|
//
#macro Slat(Half, Y0, Height, Arch, Bow, Thick)
  #local N = 12;
  #macro At(S, Top, Back)
    <S * Half, Y0 + Top * (Height + Arch * (1 - S * S)), Bow * (1 - S * S) + Back * Thick>
  #end
  mesh {
    #for (I, 0, N - 1)
      #local S0 = 2 * I / N - 1;
      #local S1 = 2 * (I + 1) / N - 1;
      Quad(At(S0, 0, 0), At(S1, 0, 0), At(S1, 1, 0), At(S0, 1, 0))
      Quad(At(S0, 0, 1), At(S1, 0, 1), At(S1, 1, 1), At(S0, 1, 1))
      Quad(At(S0, 1, 0), At(S1, 1, 0), At(S1, 1, 1), At(S0, 1, 1))
      Quad(At(S0, 0, 0), At(S1, 0, 0), At(S1, 0, 1), At(S0, 0, 1))
    #end
    Quad(At(-1, 0, 0), At(-1, 1, 0), At(-1, 1, 1), At(-1, 0, 1))
    Quad(At(1, 0, 0), At(1, 1, 0), At(1, 1, 1), At(1, 0, 1))
  }
#end

// ---------------------------------------------------------------------------------------------
// The chair: origin on the floor under the middle of the seat, its front towards -z
// ---------------------------------------------------------------------------------------------
#declare SeatY = 0.45;
#declare FrontX = 0.225;
#declare BackX = 0.185;
#declare FrontZ = -0.20;
#declare BackZ = 0.19;

// The seat is woven from four sides: each side a slightly sunken triangle about the middle.
#macro Seat()
  #local Corner = array[5] {
    <-FrontX - 0.02, SeatY, FrontZ - 0.02>, <FrontX + 0.02, SeatY, FrontZ - 0.02>,
    <BackX + 0.01, SeatY, BackZ + 0.015>, <-BackX - 0.01, SeatY, BackZ + 0.015>,
    <-FrontX - 0.02, SeatY, FrontZ - 0.02>
  }
  #local Mid = <0, SeatY - 0.012, 0>;
  #local Rows = 6;
  #for (K, 0, 3)
    #for (J, 0, Rows - 1)
      #local F0 = J / Rows;
      #local F1 = (J + 1) / Rows;
      mesh {
        Quad(Corner[K] + (Mid - Corner[K]) * F0, Corner[K + 1] + (Mid - Corner[K + 1]) * F0,
             Corner[K + 1] + (Mid - Corner[K + 1]) * F1, Corner[K] + (Mid - Corner[K]) * F1)
        Plain(Rush * (mod(J, 2) ? 0.86 : 1.0))
      }
    #end
    mesh {
      Quad(Corner[K], Corner[K + 1], Corner[K + 1] - y * 0.035, Corner[K] - y * 0.035)
      Plain(Rush * 0.9)
    }
  #end
  mesh {
    Quad(Corner[0] - y * 0.035, Corner[1] - y * 0.035, Corner[2] - y * 0.035, Corner[3] - y * 0.035)
    Plain(Rush * 0.8)
  }
#end

#macro Chair()
  union {
    union {
      #for (S, -1, 1, 2)
        // front leg, back leg, and the post that leans back above it
        Taper(<S * (FrontX + 0.015), 0, FrontZ - 0.02>, <S * FrontX, SeatY + 0.012, FrontZ>, 0.014, 0.022, 8)
        Taper(<S * (BackX + 0.005), 0, BackZ + 0.05>, <S * BackX, SeatY, BackZ>, 0.014, 0.021, 8)
        Taper(<S * BackX, SeatY, BackZ>, <S * (BackX + 0.01), 1.03, BackZ + 0.115>, 0.021, 0.014, 8)
        Taper(<S * (BackX + 0.01), 1.03, BackZ + 0.115>, <S * (BackX + 0.011), 1.075, BackZ + 0.123>, 0.019, 0.006, 8)
        // side stretchers
        Taper(<S * 0.232, 0.15, FrontZ - 0.01>, <S * 0.19, 0.15, BackZ + 0.03>, 0.009, 0.009, 6)
        Taper(<S * 0.230, 0.28, FrontZ - 0.005>, <S * 0.188, 0.28, BackZ + 0.02>, 0.009, 0.009, 6)
      #end
      Taper(<-0.23, 0.21, FrontZ - 0.01>, <0.23, 0.21, FrontZ - 0.01>, 0.010, 0.010, 6)
      Taper(<-0.23, 0.32, FrontZ - 0.005>, <0.23, 0.32, FrontZ - 0.005>, 0.010, 0.010, 6)
      Taper(<-0.19, 0.24, BackZ + 0.02>, <0.19, 0.24, BackZ + 0.02>, 0.009, 0.009, 6)
      // four slats, growing towards the top, leaning with the posts
      #for (I, 0, 3)
        #local Y = 0.54 + 0.125 * I;
        object {
          Slat(BackX + 0.004, 0, 0.045 + 0.006 * I, 0.012 + 0.006 * I, 0.028, 0.011)
          rotate x * 11
          translate <0, Y, BackZ - 0.006 + 0.115 * (Y - SeatY) / 0.58>
        }
      #end
      Plain(Lacquer)
    }
    Seat()
  }
#end

// ---------------------------------------------------------------------------------------------
// The mirror: its foot at the origin, its face towards -z, W x H of glass
// ---------------------------------------------------------------------------------------------
// A moulded side of the frame from A to B: a flat inner step, a bevel and an outer edge. In and
// Out are the unit vectors of the mitres at both ends, scaled so that they step by whole widths.
#macro Moulding(A, B, MitreA, MitreB)
  #local Steps = array[5] { <-0.002, 0.01>, <0.005, -0.014>, <0.045, -0.035>, <0.07, -0.028>, <0.07, 0.02> }
  #for (I, 0, 3)
    #local P = Steps[I];
    #local Q = Steps[I + 1];
    Quad(A + MitreA * P.u + z * P.v, B + MitreB * P.u + z * P.v,
         B + MitreB * Q.u + z * Q.v, A + MitreA * Q.u + z * Q.v)
  #end
#end

#macro Mirror(W, H)
  union {
    object {
      Block(<-W / 2, 0.07, 0>, <W / 2, 0.07 + H, 0.02>)
      texture { MirrorGlass }
    }
    object { // back board
      Block(<-W / 2 - 0.069, 0.001, 0.006>, <W / 2 + 0.069, H + 0.139, 0.0195>)
      Plain(Gilt * 0.6)
    }
    mesh {
      #local P = array[5] {
        <-W / 2, 0.07, 0>, <W / 2, 0.07, 0>, <W / 2, 0.07 + H, 0>, <-W / 2, 0.07 + H, 0>, <-W / 2, 0.07, 0>
      }
      #local M = array[5] { <-1, -1, 0>, <1, -1, 0>, <1, 1, 0>, <-1, 1, 0>, <-1, -1, 0> }
      #for (I, 0, 3)
        Moulding(P[I], P[I + 1], M[I], M[I + 1])
      #end
      Plain(Gilt)
    }
  }
#end

// ---------------------------------------------------------------------------------------------
// The room: a wall behind the mirror, another behind the camera with an open doorway
// ---------------------------------------------------------------------------------------------
#declare WallZ = 1.55;

#macro Room()
  object {
    Block(<-8, -0.1, -6>, <8, 0, WallZ>)
    Plain(Ground)
  }
  object {
    Block(<-8, 0, WallZ>, <8, 4, WallZ + 0.1>)
    Plain(Wall)
  }
  object { // skirting
    Block(<-8, 0, WallZ - 0.018>, <8, 0.12, WallZ>)
    Plain(White)
  }
  // the wall behind the camera around a doorway
  union {
    Block(<-8, 0, -4.1>, <-2.6, 4, -4>)
    Block(<-1.7, 0, -4.1>, <8, 4, -4>)
    Block(<-2.6, 2.1, -4.1>, <-1.7, 4, -4>)
    Plain(FarWall)
  }
  union {
    Block(<-2.68, 0, -4>, <-2.6, 2.18, -3.97>)
    Block(<-1.7, 0, -4>, <-1.62, 2.18, -3.97>)
    Block(<-2.6, 2.1, -4>, <-1.7, 2.18, -3.97>)
    Block(<-8, 0, -4>, <-2.68, 0.12, -3.982>)
    Block(<-1.62, 0, -4>, <8, 0.12, -3.982>)
    Plain(White)
  }
  object {
    Block(<-8, 0, -6.1>, <8, 4, -6>)
    Plain(srgb <0.45, 0.55, 0.60>)
  }
#end

Room()
object {
  Mirror(1.30, 1.50)
  rotate x * 5 // leans back: its head touches the wall
  translate <0.72, 0.002, WallZ - 0.17>
}
object {
  Chair()
  rotate y * 38
  translate <0.26, 0, 0.10>
}

#debug concat("chair_mirror.pov: ", str(Faces, 0, 0), " polygons\n")
