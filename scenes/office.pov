// SPDX-License-Identifier: AGPL-3.0-or-later
//
// An office on a late afternoon, made of flat polygons only.
//
// Tests: the ground the method was published on, a furnished room of polygons (about 8,800; the
//   count is printed after parsing). Every outline, hard shadow and flat reflection can be known
//   from geometry alone: boxes, prisms with linear splines, triangle meshes; two point lights; one
//   flat mirror. Hundreds of small parts (books, keys, leaves) beside large plain walls, and a few
//   textures (floor, rug, pictures, screen).
// Should be seen: a desk under a window with a village and hills behind it; the sun drawing the
//   window's bars on the floor and the rug; a pendant lamp that lights the room below its rim and
//   an octagon of the ceiling; in the mirror on the far wall the desk, the chair, the curtain and
//   the window from the other side, and a picture that hangs outside the camera's own view.
// Camera: aspect 4:3, meant for 640x480 and up.
// Options: Declare=Radiosity=1 replaces the constant ambient light by computed indirect light;
//   Declare=Untextured=1 leaves out the textures that draw edges of their own.
//
// Units are metres; x right along the far wall, y up, z into the picture. Furniture stands on
// y = 0 around its own origin with its front towards -z, and is then turned and put in place.

#version 3.7;

#ifndef (Radiosity)
  #declare Radiosity = 0;
#end
#ifndef (Untextured)
  #declare Untextured = 0;
#end

global_settings {
  assumed_gamma 1.0
  max_trace_level 5
  #if (Radiosity)
    radiosity {
      pretrace_start 0.08
      pretrace_end 0.01
      count 90
      nearest_count 8
      error_bound 0.5
      recursion_limit 2
      low_error_factor 0.6
      gray_threshold 0.1
      minimum_reuse 0.012
      brightness 1.5
    }
  #end
}

// ---------------------------------------------------------------------------------------------
// Size of the room, and of the opening for the window in its left wall (x = 0)
// ---------------------------------------------------------------------------------------------
#declare RoomW = 5.2;
#declare RoomD = 5.0;
#declare RoomH = 2.75;
#declare WallT = 0.25;
#declare WinZ0 = 1.75;
#declare WinZ1 = 4.05;
#declare WinY0 = 0.92;
#declare WinY1 = 2.35;

// ---------------------------------------------------------------------------------------------
// Camera and the two point lights
// ---------------------------------------------------------------------------------------------
camera {
  location <4.55, 1.62, 0.18>
  right x * 4 / 3
  angle 68
  look_at <1.95, 0.98, 3.6>
}

#declare Sun = <-9.0, 7.6, 2.5>;
#declare Pendant = <2.75, 2.02, 2.65>;

light_source {
  Sun
  color rgb <1.0, 0.85, 0.62> * 3.0
}

light_source {
  Pendant
  color rgb <1.0, 0.90, 0.76> * 0.65
  fade_distance 2.4
  fade_power 2
}

// ---------------------------------------------------------------------------------------------
// Materials
// ---------------------------------------------------------------------------------------------
#declare SkyFill = rgb <0.25, 0.28, 0.32>; // stands in for the indirect light

#declare Matt = finish { ambient SkyFill diffuse 0.75 }

#macro Plain(C)
  texture {
    pigment { color C }
    finish { Matt }
  }
#end

// Things out of doors, as an eye used to the room would see them under that sun.
#macro Distant(C)
  texture {
    pigment { color C }
    finish { ambient SkyFill * 1.5 emission SkyFill * 1.2 * Radiosity diffuse 0.26 }
  }
#end

#macro Glowing(C, Strength)
  texture {
    pigment { color C }
    finish { ambient 0 diffuse 0 emission Strength }
  }
#end

#declare White = srgb <0.93, 0.92, 0.89>;
#declare Plaster = srgb <0.91, 0.88, 0.82>;
#declare Sage = srgb <0.56, 0.66, 0.61>;
#declare Charcoal = srgb <0.17, 0.18, 0.20>;
#declare Steel = srgb <0.60, 0.62, 0.64>;
#declare Brass = srgb <0.78, 0.62, 0.33>;
#declare Oak = srgb <0.76, 0.58, 0.38>;
#declare Walnut = srgb <0.42, 0.28, 0.19>;
#declare Paper = srgb <0.96, 0.95, 0.91>;
#declare Mustard = srgb <0.86, 0.63, 0.20>;
#declare Rust = srgb <0.72, 0.33, 0.20>;
#declare Navy = srgb <0.16, 0.25, 0.38>;

// Grain along z, one plank's worth; every plank shows another part of it.
#macro PlankGrain(Shade, Where)
  wood
  turbulence 0.06
  octaves 3
  color_map {
    [0.0 color Shade]
    [0.7 color Shade * 0.86]
    [1.0 color Shade * 0.70]
  }
  scale <0.035, 0.035, 0.9>
  rotate <3, 2, 0>
  translate Where
#end

// One row of planks, cut twice per period of 2.4 m, with dark joints.
#macro PlankRow(K)
  gradient z
  pigment_map {
    [0.000 color srgb <0.25, 0.16, 0.10>]
    [0.003 color srgb <0.25, 0.16, 0.10>]
    [0.003 PlankGrain(srgb <0.74, 0.56, 0.37> * (0.80 + 0.07 * mod(K * 3, 4)), <K * 0.31, 0.2, 0>)]
    [0.540 PlankGrain(srgb <0.74, 0.56, 0.37> * (0.80 + 0.07 * mod(K * 3, 4)), <K * 0.31, 0.2, 0>)]
    [0.540 color srgb <0.25, 0.16, 0.10>]
    [0.543 color srgb <0.25, 0.16, 0.10>]
    [0.543 PlankGrain(srgb <0.72, 0.53, 0.34> * (0.84 + 0.06 * mod(K * 5, 3)), <0.1, K * 0.27, 0>)]
    [1.000 PlankGrain(srgb <0.72, 0.53, 0.34> * (0.84 + 0.06 * mod(K * 5, 3)), <0.1, K * 0.27, 0>)]
  }
  scale 2.4
  translate z * mod(K * 0.83, 2.4)
#end

#declare Planks = 7;
#declare FloorBoards = texture {
  pigment {
    #if (Untextured)
      color srgb <0.66, 0.48, 0.31>
    #else
      gradient x
      pigment_map {
        #for (K, 0, Planks - 1)
          [K / Planks color srgb <0.25, 0.16, 0.10>]
          [(K + 0.02) / Planks color srgb <0.25, 0.16, 0.10>]
          [(K + 0.02) / Planks PlankRow(K)]
          [(K + 1) / Planks PlankRow(K)]
        #end
      }
      scale Planks * 0.15
    #end
  }
  finish { Matt }
}

#declare MirrorGlass = texture {
  pigment { rgb <0.02, 0.025, 0.025> }
  finish { ambient 0 diffuse 0.5 reflection { rgb <0.90, 0.93, 0.92> } }
}

// ---------------------------------------------------------------------------------------------
// Building blocks. Each adds what it makes to Faces, the count of flat polygons.
// ---------------------------------------------------------------------------------------------
#declare Faces = 0;
#declare Dice = seed(1997);

#macro Between(Low, High)
  (Low + (High - Low) * rand(Dice))
#end

#macro Block(A, B)
  box { A, B }
  #declare Faces = Faces + 6;
#end

// Triangles and flat quadrilaterals A-B-C-D inside a mesh.
#macro Tri(A, B, C)
  triangle { A, B, C }
  #declare Faces = Faces + 1;
#end

#macro Quad(A, B, C, D)
  triangle { A, B, C }
  triangle { A, C, D }
  #declare Faces = Faces + 1;
#end

// An upright prism over a regular N-gon of radius R.
#macro Column(N, R, Y0, Y1)
  prism {
    linear_sweep
    linear_spline
    Y0, Y1, N + 1
    #for (I, 0, N)
      , <R * cos(2 * pi * I / N), R * sin(2 * pi * I / N)>
    #end
  }
  #declare Faces = Faces + N + 2;
#end

// Turns and moves the y axis onto the way from A to B, the x axis staying level.
#macro Along(A, B)
  #local Up = vnormalize(B - A);
  #local Side = vcross(Up, (abs(Up.y) > 0.99 ? z : y));
  #local Side = vnormalize(Side);
  #local Third = vcross(Side, Up);
  matrix <Side.x, Side.y, Side.z, Up.x, Up.y, Up.z, Third.x, Third.y, Third.z, A.x, A.y, A.z>
#end

// A rectangular bar from A to B, W wide (level) and T thick.
#macro Bar(A, B, W, T)
  box {
    <-W / 2, 0, -T / 2>, <W / 2, vlength(B - A), T / 2>
    Along(A, B)
  }
  #declare Faces = Faces + 6;
#end

// A rod from A to B over a regular N-gon.
#macro Rod(A, B, N, R)
  object {
    Column(N, R, 0, vlength(B - A))
    Along(A, B)
  }
#end

// A turned shape with N flat sides; Profile holds <radius, height> from one end to the other.
#macro Turned(N, Profile)
  mesh {
    #for (J, 0, dimension_size(Profile, 1) - 2)
      #for (I, 0, N - 1)
        #local C0 = vrotate(x, y * 360 * I / N);
        #local C1 = vrotate(x, y * 360 * (I + 1) / N);
        #local R0 = Profile[J].u;
        #local R1 = Profile[J + 1].u;
        #local Y0 = y * Profile[J].v;
        #local Y1 = y * Profile[J + 1].v;
        #if (R0 < 1e-6)
          Tri(Y0, C0 * R1 + Y1, C1 * R1 + Y1)
        #elseif (R1 < 1e-6)
          Tri(C0 * R0 + Y0, C1 * R0 + Y0, Y1)
        #else
          Quad(C0 * R0 + Y0, C1 * R0 + Y0, C1 * R1 + Y1, C0 * R1 + Y1)
        #end
      #end
    #end
  }
#end

// A box from A to B whose edges and corners are cut off by Cut: 26 faces.
//
//      ______
//     /______\     Corner(S, Axis): near the corner with signs S, the point
//    |        |    that still lies on the face across Axis.
//    |        |
//     \______/
#macro Chamfered(A, B, Cut)
  #local Mid = (A + B) / 2;
  #local Full = (B - A) / 2;
  #local Axes = array[3] { x, y, z }
  #macro Corner(S, Axis)
    (Mid + S * (Full - Cut * (<1, 1, 1> - Axes[Axis])))
  #end
  mesh {
    #for (K, 0, 2)
      #local U = Axes[K];
      #local V = Axes[mod(K + 1, 3)];
      #local W = Axes[mod(K + 2, 3)];
      #for (P, -1, 1, 2)
        Quad(Corner(U*P + V + W, K), Corner(U*P - V + W, K), Corner(U*P - V - W, K), Corner(U*P + V - W, K))
        #for (Q, -1, 1, 2)
          #local E0 = V*P + W*Q + U;
          #local E1 = V*P + W*Q - U;
          Quad(Corner(E0, mod(K + 1, 3)), Corner(E1, mod(K + 1, 3)),
               Corner(E1, mod(K + 2, 3)), Corner(E0, mod(K + 2, 3)))
          #if (K = 0)
            Tri(Corner(E0, 0), Corner(E0, 1), Corner(E0, 2))
            Tri(Corner(E1, 0), Corner(E1, 1), Corner(E1, 2))
          #end
        #end
      #end
    #end
  }
#end

// A frame in the plane z = 0 around an opening of size W x H centred on the origin.
#macro Frame(W, H, Width, Depth)
  union {
    Block(<-W / 2 - Width, H / 2, -Depth>, <W / 2 + Width, H / 2 + Width, 0>)
    Block(<-W / 2 - Width, -H / 2 - Width, -Depth>, <W / 2 + Width, -H / 2, 0>)
    Block(<-W / 2 - Width, -H / 2, -Depth>, <-W / 2, H / 2, 0>)
    Block(<W / 2, -H / 2, -Depth>, <W / 2 + Width, H / 2, 0>)
  }
#end

// ---------------------------------------------------------------------------------------------
// The room
// ---------------------------------------------------------------------------------------------
#macro Room()
  object {
    Block(<-WallT, -0.1, -WallT>, <RoomW + WallT, 0, RoomD + WallT>)
    texture { FloorBoards }
  }
  object {
    Block(<-WallT, RoomH, -WallT>, <RoomW + WallT, RoomH + 0.1, RoomD + WallT>)
    texture {
      pigment { color White }
      finish { ambient SkyFill * 1.6 diffuse 0.75 }
    }
  }
  object { // far wall
    Block(<0, 0, RoomD>, <RoomW, RoomH, RoomD + WallT>)
    Plain(Sage)
  }
  union { // right wall, wall behind the camera, left wall around the window
    Block(<RoomW, 0, 0>, <RoomW + WallT, RoomH, RoomD>)
    Block(<0, 0, -WallT>, <RoomW, RoomH, 0>)
    Block(<-WallT, 0, 0>, <0, WinY0, RoomD>)
    Block(<-WallT, WinY1, 0>, <0, RoomH, RoomD>)
    Block(<-WallT, WinY0, 0>, <0, WinY1, WinZ0>)
    Block(<-WallT, WinY0, WinZ1>, <0, WinY1, RoomD>)
    Plain(Plaster)
  }
  union { // skirting
    Block(<0, 0, RoomD - 0.018>, <RoomW, 0.10, RoomD>)
    Block(<0, 0, 0>, <0.018, 0.10, RoomD - 0.018>)
    Block(<RoomW - 0.018, 0, 0>, <RoomW, 0.10, RoomD - 0.018>)
    Block(<0.018, 0, 0>, <RoomW - 0.018, 0.10, 0.018>)
    Plain(White)
  }
#end

// Casement of two sashes with a bar each, sill, seen along -x.
#macro Window()
  #local Mid = (WinZ0 + WinZ1) / 2;
  #local BarY = WinY0 + (WinY1 - WinY0) * 0.68;
  #local X0 = -0.16;
  #local X1 = -0.10;
  union {
    Block(<X0, WinY0, WinZ0>, <X1, WinY0 + 0.06, WinZ1>)
    Block(<X0, WinY1 - 0.06, WinZ0>, <X1, WinY1, WinZ1>)
    Block(<X0, WinY0 + 0.06, WinZ0>, <X1, WinY1 - 0.06, WinZ0 + 0.06>)
    Block(<X0, WinY0 + 0.06, WinZ1 - 0.06>, <X1, WinY1 - 0.06, WinZ1>)
    Block(<X0, WinY0 + 0.06, Mid - 0.05>, <X1, WinY1 - 0.06, Mid + 0.05>)
    Block(<X0 + 0.01, BarY - 0.02, WinZ0 + 0.06>, <X1 - 0.01, BarY + 0.02, Mid - 0.05>)
    Block(<X0 + 0.01, BarY - 0.02, Mid + 0.05>, <X1 - 0.01, BarY + 0.02, WinZ1 - 0.06>)
    Block(<-0.10, WinY0 - 0.03, WinZ0 - 0.06>, <0.09, WinY0, WinZ1 + 0.06>)
    Plain(White)
  }
#end

// A curtain hanging in flat folds from Z0 to Z1, drawn together.
#macro Curtain(Z0, Z1, Folds)
  mesh {
    #for (I, 0, 2 * Folds - 1)
      #local ZA = Z0 + (Z1 - Z0) * I / (2 * Folds);
      #local ZB = Z0 + (Z1 - Z0) * (I + 1) / (2 * Folds);
      #local XA = 0.06 + 0.07 * mod(I, 2);
      #local XB = 0.06 + 0.07 * mod(I + 1, 2);
      Quad(<XA, 0.06, ZA>, <XB, 0.06, ZB>, <XB, 2.47, ZB>, <XA, 2.47, ZA>)
    #end
  }
#end

#macro Curtains()
  union {
    Curtain(WinZ0 - 0.50, WinZ0 - 0.02, 7)
    Curtain(WinZ1 + 0.02, WinZ1 + 0.50, 7)
    Plain(srgb <0.90, 0.80, 0.66>)
  }
  object {
    Rod(<0.095, 2.49, WinZ0 - 0.6>, <0.095, 2.49, WinZ1 + 0.6>, 6, 0.014)
    Plain(Brass)
  }
#end

// A lamp shade hung from the ceiling, open above and below; the light hangs at its lower rim.
#macro PendantLamp()
  union {
    object {
      Turned(8, array[3] { <0.30, -0.005>, <0.28, 0.07>, <0.13, 0.17> })
      Plain(srgb <0.20, 0.30, 0.30>)
    }
    object { // its bright inside
      Turned(8, array[3] { <0.297, -0.004>, <0.277, 0.07>, <0.128, 0.169> })
      Glowing(srgb <1.0, 0.93, 0.78>, 0.95)
    }
    object {
      Block(<-0.006, 0.17, -0.006>, <0.006, RoomH - Pendant.y, 0.006>)
      Plain(Charcoal)
    }
    union {
      Bar(<-0.13, 0.17, 0>, <0.13, 0.17, 0>, 0.008, 0.008)
      Bar(<0, 0.17, -0.13>, <0, 0.17, 0.13>, 0.008, 0.008)
      Plain(Charcoal)
    }
    translate Pendant
  }
#end

// ---------------------------------------------------------------------------------------------
// What the window shows
// ---------------------------------------------------------------------------------------------
// A ridge as a prism along x, its outline given over z by a sum of waves.
#macro Ridge(X, Base, Height, Phase, C)
  #local N = 44;
  prism {
    linear_sweep
    linear_spline
    X - 0.5, X, N + 4
    , <-210, -20>
    #for (I, 0, N)
      #local Z = -210 + 460 * I / N;
      , <Z, Base + Height * (0.5 + 0.3 * sin(Z * 0.055 + Phase) + 0.2 * sin(Z * 0.17 + 2 * Phase))>
    #end
    , <250, -20>
    , <-210, -20>
    // prism space (u, along, v) -> (along, v, u)
    matrix <0, 0, 1, 1, 0, 0, 0, 1, 0, 0, 0, 0>
    Distant(C)
  }
  #declare Faces = Faces + N + 5;
#end

#macro House(Where, W, D, H, Turn, Walls)
  union {
    object {
      Block(<-W / 2, 0, -D / 2>, <W / 2, H, D / 2>)
      Distant(Walls)
    }
    mesh {
      #local E = 0.25;
      #local R0 = <0, H + W * 0.45, -D / 2 - E>;
      #local R1 = <0, H + W * 0.45, D / 2 + E>;
      #local L0 = <-W / 2 - E, H - 0.1, -D / 2 - E>;
      #local L1 = <-W / 2 - E, H - 0.1, D / 2 + E>;
      #local M0 = <W / 2 + E, H - 0.1, -D / 2 - E>;
      #local M1 = <W / 2 + E, H - 0.1, D / 2 + E>;
      Quad(L0, L1, R1, R0)
      Quad(M0, M1, R1, R0)
      Tri(L0, M0, R0)
      Tri(L1, M1, R1)
      Distant(srgb <0.66, 0.32, 0.22>)
    }
    union {
      #for (I, -1, 1)
        Block(<W / 2, H * 0.35, I * D * 0.3 - 0.3>, <W / 2 + 0.03, H * 0.7, I * D * 0.3 + 0.3>)
      #end
      Distant(srgb <0.25, 0.29, 0.34>)
    }
    rotate y * Turn
    translate Where
  }
#end

#macro Church(Where)
  union {
    object {
      Block(<-1.6, 0, -1.6>, <1.6, 8, 1.6>)
      Distant(srgb <0.93, 0.90, 0.84>)
    }
    object {
      Turned(4, array[2] { <2.6, 8>, <0, 14> })
      rotate y * 45
      Distant(srgb <0.36, 0.42, 0.46>)
    }
    House(<0, 0, 5>, 4.4, 9, 4, 0, srgb <0.93, 0.90, 0.84>)
    translate Where
  }
#end

#macro Tree(Where, H)
  union {
    object {
      Column(5, 0.07 * H, 0, 0.4 * H)
      Distant(srgb <0.35, 0.25, 0.18>)
    }
    object {
      Turned(7, array[5] { <0, 0.25 * H>, <0.26 * H, 0.38 * H>, <0.30 * H, 0.60 * H>, <0.18 * H, 0.86 * H>, <0, H> })
      Distant(srgb <0.30, 0.44, 0.20> * Between(0.75, 1.15))
    }
    rotate y * Between(0, 360)
    translate Where
  }
#end

#macro Outside()
  mesh { // the sky, behind the sun: its glow is its own
    Quad(<-125, -20, -220>, <-125, -20, 260>, <-125, 90, 260>, <-125, 90, -220>)
    texture {
      pigment {
        gradient y
        color_map {
          [0.0 color srgb <0.98, 0.91, 0.78>]
          [0.25 color srgb <0.80, 0.88, 0.93>]
          [1.0 color srgb <0.36, 0.58, 0.86>]
        }
        scale 48
        translate y * -1
      }
      finish { ambient 0 diffuse 0 emission 0.95 }
    }
  }
  object {
    Block(<-124, -4.2, -210>, <-WallT - 0.5, -4, 250>)
    Distant(srgb <0.55, 0.62, 0.32>)
  }
  Ridge(-112, -2, 22, 1.9, srgb <0.60, 0.71, 0.84>)
  Ridge(-96, -4, 15, 2.6, srgb <0.50, 0.64, 0.64>)
  Ridge(-80, -5, 10, 4.6, srgb <0.48, 0.62, 0.42>)
  House(<-52, -4, 20>, 5, 7, 3.2, 12, srgb <0.95, 0.90, 0.80>)
  House(<-58, -4, 31>, 5, 8, 3.4, -24, srgb <0.90, 0.76, 0.60>)
  House(<-66, -4, 43>, 5, 9, 3.6, 16, srgb <0.92, 0.88, 0.84>)
  House(<-50, -4, -26>, 5, 7, 3.2, 30, srgb <0.92, 0.86, 0.76>)
  Church(<-70, -4, 35>)
  #for (I, 0, 35)
    Tree(<-27 - 42 * rand(Dice), -4, -56 + 3.4 * I + rand(Dice)>, Between(2.4, 4.4))
  #end
#end

// ---------------------------------------------------------------------------------------------
// The desk and what stands on it. Desk: 1.8 x 0.8 m, top at DeskY; the user sits at -z.
// ---------------------------------------------------------------------------------------------
#declare DeskY = 0.74;

#macro Drawer(Y0, Y1)
  object {
    Block(<0.44, Y0, -0.365>, <0.86, Y1, -0.345>)
    Plain(White)
  }
  object {
    Block(<0.58, (Y0 + Y1) / 2 + 0.015, -0.385>, <0.72, (Y0 + Y1) / 2 + 0.03, -0.365>)
    Plain(Brass)
  }
#end

#macro Desk()
  union {
    object {
      Chamfered(<-0.90, DeskY - 0.035, -0.40>, <0.90, DeskY, 0.40>, 0.006)
      texture {
        pigment {
          #if (Untextured)
            color Oak * 0.9
          #else
            PlankGrain(Oak, <0, 0.1, 0>)
            rotate y * 90
            scale <2, 1, 2>
          #end
        }
        finish { Matt }
      }
    }
    object { // pedestal
      Block(<0.43, 0.06, -0.345>, <0.87, DeskY - 0.035, 0.36>)
      Plain(White)
    }
    Drawer(0.08, 0.34)
    Drawer(0.35, 0.52)
    Drawer(0.53, 0.69)
    union {
      Bar(<-0.82, 0, -0.33>, <-0.82, DeskY - 0.035, -0.33>, 0.05, 0.05)
      Bar(<-0.82, 0, 0.33>, <-0.82, DeskY - 0.035, 0.33>, 0.05, 0.05)
      Block(<-0.80, 0.36, 0.30>, <0.43, DeskY - 0.035, 0.32>)
      Block(<-0.835, 0.10, -0.30>, <-0.805, 0.14, 0.30>)
      Plain(White)
    }
  }
#end

// What the screen shows: a landscape behind two windows of text.
#macro ScreenPage(X0, Y0, W, H, Lines)
  union {
    object {
      Block(<X0, Y0, -0.0265>, <X0 + W, Y0 + H, -0.026>)
      Glowing(srgb <0.97, 0.97, 0.98>, 0.9)
    }
    object {
      Block(<X0, Y0 + H - 0.016, -0.0275>, <X0 + W, Y0 + H, -0.0265>)
      Glowing(srgb <0.30, 0.45, 0.62>, 0.9)
    }
    union {
      #for (I, 1, Lines)
        #local Y = Y0 + (H - 0.02) * (1 - I / (Lines + 1));
        Block(<X0 + 0.012, Y - 0.002, -0.0275>, <X0 + W * Between(0.55, 0.93), Y + 0.002, -0.0265>)
      #end
      Glowing(srgb <0.35, 0.37, 0.42>, 0.9)
    }
  }
#end

#macro Monitor()
  union {
    object {
      Chamfered(<-0.31, 0.10, -0.02>, <0.31, 0.48, 0.02>, 0.006)
      Plain(Charcoal)
    }
    object {
      Block(<-0.30, 0.115, -0.026>, <0.30, 0.47, -0.01>)
      texture {
        pigment {
          #if (Untextured)
            color srgb <0.40, 0.50, 0.56>
          #else
            gradient y
            turbulence <0, 0.12, 0>
            color_map {
              [0.0 color srgb <0.13, 0.20, 0.32>]
              [0.5 color srgb <0.27, 0.47, 0.60>]
              [0.8 color srgb <0.92, 0.62, 0.45>]
              [1.0 color srgb <0.97, 0.82, 0.60>]
            }
            scale 0.37
            translate y * 0.11
          #end
        }
        finish { ambient 0 diffuse 0.05 emission 0.85 }
      }
    }
    ScreenPage(-0.27, 0.20, 0.27, 0.24, 13)
    ScreenPage(0.03, 0.15, 0.23, 0.19, 9)
    union {
      Bar(<0, 0.012, 0.06>, <0, 0.30, 0.025>, 0.06, 0.02)
      Block(<-0.12, 0, -0.07>, <0.12, 0.012, 0.11>)
      Plain(Steel)
    }
  }
#end

// A key is a flat pyramid cut off at the top.
#macro Key(X, Z, W, D)
  #local T = 0.0025;
  mesh {
    #local A0 = <X, 0.012, Z>;
    #local B0 = <X + W, 0.012, Z>;
    #local C0 = <X + W, 0.012, Z + D>;
    #local D0 = <X, 0.012, Z + D>;
    #local A1 = <X + T, 0.019, Z + T>;
    #local B1 = <X + W - T, 0.019, Z + T>;
    #local C1 = <X + W - T, 0.019, Z + D - T>;
    #local D1 = <X + T, 0.019, Z + D - T>;
    Quad(A1, B1, C1, D1)
    Quad(A0, B0, B1, A1)
    Quad(B0, C0, C1, B1)
    Quad(C0, D0, D1, C1)
    Quad(D0, A0, A1, D1)
  }
#end

#macro Keyboard()
  union {
    object {
      Block(<-0.215, 0, -0.07>, <0.215, 0.013, 0.07>)
      Plain(srgb <0.80, 0.80, 0.79>)
    }
    union {
      #for (Row, 0, 4)
        #for (I, 0, 18)
          #local Wide = (Row = 0 ? (I >= 4 & I <= 9) : 0);
          #if (!Wide)
            Key(-0.207 + I * 0.0218, -0.062 + Row * 0.025, 0.0195, 0.022)
          #end
        #end
      #end
      Key(-0.207 + 4 * 0.0218, -0.062, 6 * 0.0218 - 0.0023, 0.022)
      Plain(Paper)
    }
  }
#end

#macro Mouse()
  object {
    Chamfered(<-0.03, 0, -0.05>, <0.03, 0.03, 0.05>, 0.012)
    Plain(Paper)
  }
#end

#macro DeskLamp()
  #local Elbow = <0, 0.40, 0.10>;
  #local Head = <0, 0.52, -0.20>;
  union {
    object {
      Column(12, 0.085, 0, 0.02)
      Plain(Rust)
    }
    union {
      Rod(<0, 0.02, 0>, Elbow, 6, 0.008)
      Rod(Elbow, Head, 6, 0.008)
      Rod(Elbow - x * 0.016, Elbow + x * 0.016, 8, 0.018)
      Plain(Brass)
    }
    object {
      Turned(12, array[5] { <0, 0.055>, <0.03, 0.05>, <0.045, 0.01>, <0.095, -0.075>, <0.097, -0.082> })
      rotate x * 28
      translate Head
      Plain(Rust)
    }
  }
#end

#macro PenMug()
  union {
    object {
      Turned(10, array[4] { <0, 0>, <0.038, 0>, <0.042, 0.10>, <0.036, 0.098> })
      Plain(Navy)
    }
    #local Colours = array[5] { Mustard, Rust, srgb <0.2, 0.5, 0.4>, Charcoal, Paper }
    #for (I, 0, 4)
      #local Foot = vrotate(<0.015, 0.01, 0>, y * I * 72);
      #local Top = vrotate(<0.045, Between(0.15, 0.18), 0>, y * (I * 72 + 25));
      object {
        Rod(Foot, Top, 6, 0.0042)
        Plain(Colours[I])
      }
    #end
  }
#end

#macro PaperStack(Sheets)
  union {
    #for (I, 0, Sheets - 1)
      object {
        Block(<-0.105, I * 0.004, -0.148>, <0.105, I * 0.004 + 0.0032, 0.148>)
        rotate y * Between(-9, 9)
        translate <Between(-0.008, 0.008), 0, Between(-0.008, 0.008)>
      }
    #end
    Plain(Paper)
  }
#end

// A book lying or standing: two boards, a spine at -x and the pages between them.
//    .__________.
//    |__________|  height (y), thickness along z, width along x
#macro Book(W, H, T, C)
  union {
    union {
      Block(<0, 0, 0>, <W, H, 0.003>)
      Block(<0, 0, T - 0.003>, <W, H, T>)
      Block(<0, 0, 0.003>, <0.003, H, T - 0.003>)
      Plain(C)
    }
    object {
      Block(<0.003, 0.004, 0.003>, <W - 0.005, H - 0.004, T - 0.003>)
      Plain(Paper)
    }
  }
#end

#declare Spines = array[9] {
  srgb <0.62, 0.20, 0.17>, srgb <0.18, 0.28, 0.42>, srgb <0.82, 0.68, 0.42>,
  srgb <0.24, 0.38, 0.30>, srgb <0.88, 0.84, 0.76>, srgb <0.76, 0.45, 0.22>,
  srgb <0.35, 0.24, 0.30>, srgb <0.46, 0.58, 0.62>, srgb <0.25, 0.23, 0.22>
}

#declare Labels = array[2] { Brass, Paper }
#declare Glazes = array[2] { srgb <0.30, 0.48, 0.52>, srgb <0.88, 0.86, 0.80> }

#macro BookStack(N)
  union {
    #local Y = 0;
    #for (I, 0, N - 1)
      #local T = Between(0.018, 0.038);
      object {
        Book(Between(0.15, 0.18), Between(0.21, 0.25), T, Spines[mod(I * 4 + 2, 9)])
        translate <-0.08, -0.11, 0>
        rotate x * -90 // lay it down: thickness along y
        translate y * T
        scale <1, -1, 1>
        translate y * T
        rotate y * Between(-20, 20)
        translate y * Y
      }
      #local Y = Y + T;
    #end
  }
#end

// ---------------------------------------------------------------------------------------------
// Seats
// ---------------------------------------------------------------------------------------------
#macro SwivelChair()
  union {
    union {
      #for (I, 0, 4)
        #local Foot = vrotate(<0, 0.075, 0.30>, y * I * 72);
        Bar(<0, 0.11, 0>, Foot, 0.045, 0.03)
        object {
          Column(8, 0.03, -0.02, 0.02)
          rotate z * 90
          rotate y * (I * 72 + 35)
          translate Foot * <1, 0, 1> + y * 0.03
        }
      #end
      Column(8, 0.028, 0.08, 0.40)
      Bar(<0, 0.40, 0.05>, <0, 0.42, 0.27>, 0.07, 0.02)
      Bar(<0, 0.42, 0.26>, <0, 0.80, 0.31>, 0.07, 0.02)
      #for (S, -1, 1, 2)
        Bar(<S * 0.20, 0.42, 0.05>, <S * 0.29, 0.43, 0.05>, 0.05, 0.02)
        Bar(<S * 0.285, 0.42, 0.05>, <S * 0.285, 0.64, 0.07>, 0.05, 0.02)
        Chamfered(<S * 0.285 - 0.03, 0.64, -0.10>, <S * 0.285 + 0.03, 0.665, 0.16>, 0.01)
      #end
      Plain(Charcoal)
    }
    union {
      Chamfered(<-0.25, 0.42, -0.25>, <0.25, 0.50, 0.24>, 0.028)
      object {
        Chamfered(<-0.23, 0, -0.035>, <0.23, 0.52, 0.035>, 0.025)
        rotate x * 8
        translate <0, 0.58, 0.25>
      }
      Plain(srgb <0.20, 0.42, 0.44>)
    }
  }
#end

#macro Armchair()
  union {
    union {
      Chamfered(<-0.29, 0.16, -0.36>, <0.29, 0.30, 0.30>, 0.02) // base
      Chamfered(<-0.285, 0.30, -0.38>, <0.285, 0.43, 0.22>, 0.035) // seat cushion
      Chamfered(<-0.41, 0.14, -0.37>, <-0.29, 0.60, 0.34>, 0.03) // arms
      Chamfered(<0.29, 0.14, -0.37>, <0.41, 0.60, 0.34>, 0.03)
      object { // back
        Chamfered(<-0.40, 0, -0.07>, <0.40, 0.68, 0.07>, 0.035)
        rotate x * 10
        translate <0, 0.20, 0.28>
      }
      object { // back cushion
        Chamfered(<-0.27, 0, -0.06>, <0.27, 0.42, 0.06>, 0.04)
        rotate x * 14
        translate <0, 0.42, 0.17>
      }
      Plain(Mustard)
    }
    union {
      #for (SX, -1, 1, 2)
        #for (SZ, -1, 1, 2)
          Rod(<SX * 0.33, 0.15, SZ * 0.29>, <SX * 0.36, 0, SZ * 0.33>, 8, 0.018)
        #end
      #end
      Plain(Walnut)
    }
  }
#end

#macro LowTable()
  union {
    union {
      Column(10, 0.36, 0.405, 0.43)
      #for (I, 0, 2)
        #local Foot = vrotate(<0.30, 0, 0>, y * (I * 120 + 20));
        Bar(Foot * 0.75 + y * 0.405, Foot, 0.035, 0.035)
      #end
      Plain(Walnut)
    }
    object {
      BookStack(3)
      rotate y * 35
      translate <0.06, 0.43, -0.12>
    }
    object { // a vase with a few twigs
      Turned(10, array[6] { <0, 0>, <0.045, 0>, <0.075, 0.06>, <0.06, 0.13>, <0.028, 0.19>, <0.036, 0.22> })
      translate <-0.13, 0.43, 0.06>
      Plain(srgb <0.86, 0.84, 0.80>)
    }
    union {
      #for (I, 0, 4)
        #local Tip = <Between(-0.10, 0.10), Between(0.42, 0.55), Between(-0.10, 0.10)>;
        Rod(<0, 0.05, 0>, Tip, 4, 0.003)
        #for (J, 0, 4)
          object {
            Turned(4, array[3] { <0, -0.02>, <0.011, 0>, <0, 0.024> })
            translate Tip * (0.62 + 0.095 * J) + <Between(-0.015, 0.015), 0, Between(-0.015, 0.015)>
          }
        #end
      #end
      translate <-0.13, 0.43, 0.06>
      Plain(srgb <0.74, 0.30, 0.28>)
    }
  }
#end

// ---------------------------------------------------------------------------------------------
// Shelves, plants, pictures, mirror, rug
// ---------------------------------------------------------------------------------------------
// One row of standing books from X0 until X1 is full, spines towards -z; some lean, some gape.
#macro BookRow(X0, X1, Space)
  #local X = X0;
  #while (X < X1 - 0.05)
    #local T = Between(0.018, 0.046);
    #local H = Space * Between(0.66, 0.93);
    #local C = Spines[int(rand(Dice) * 8.999)];
    union {
      object {
        Block(<0, 0, 0>, <T - 0.001, H, 0.20>)
        Plain(C)
      }
      object { // the pages, seen from above
        Block(<0.003, H - 0.01, 0.004>, <T - 0.004, H + 0.001, 0.199>)
        Plain(Paper)
      }
      #if (rand(Dice) < 0.55)
        object {
          Block(<0.003, H * 0.72, -0.001>, <T - 0.004, H * 0.82, 0.001>)
          Plain(Labels[int(2 * rand(Dice))])
        }
      #end
      #if (rand(Dice) < 0.07)
        translate x * -T
        rotate z * 9 // leans on the book before it
        translate x * (T + H * 0.15)
        #local X = X + H * 0.16;
      #end
      translate <X, 0, Between(0.01, 0.03)>
    }
    #local X = X + T + (rand(Dice) < 0.04 ? 0.07 : 0);
  #end
#end

#macro Bookcase(W, H, Shelves)
  #local D = 0.29;
  #local T = 0.022;
  #local Pitch = (H - T - 0.08) / Shelves;
  union {
    union {
      Block(<0, 0, 0>, <T, H, D>)
      Block(<W - T, 0, 0>, <W, H, D>)
      Block(<T, 0, D - 0.01>, <W - T, H, D>)
      Block(<W / 2 - T / 2, 0.08, 0.004>, <W / 2 + T / 2, H - T, D - 0.01>)
      Block(<T, 0, 0.03>, <W - T, 0.08, 0.05>)
      #for (I, 0, Shelves)
        Block(<T, 0.08 + I * Pitch - T / 2, 0.002>, <W - T, 0.08 + I * Pitch + T / 2, D - 0.01>)
      #end
      Plain(Walnut * 1.15)
    }
    #for (I, 0, Shelves - 1)
      #for (Half, 0, 1)
        #local A = (Half ? W / 2 + T / 2 : T);
        #local B = (Half ? W - T : W / 2 - T / 2);
        #local Keep = (mod(I * 2 + Half * 3, 5) = 3 ? 0.26 : 0); // room for an ornament
        union {
          BookRow(A + 0.005, B - Keep, Pitch - T)
          #if (Keep > 0)
            object {
              Turned(9, array[6] { <0, 0>, <0.05, 0>, <0.085, 0.07>, <0.06, 0.15>, <0.03, 0.18>, <0.042, 0.21> })
              translate <B - 0.11, 0, 0.14>
              Plain(Glazes[mod(I, 2)])
            }
          #end
          translate y * (0.08 + I * Pitch + T / 2)
        }
      #end
    #end
  }
#end

// A leaf of two folded halves along an arc that rises from the stem and bows under its weight.
#macro Leaf(Base, Turn, Rise, Length, Width)
  #local N = 6;
  #local Out = vrotate(x, y * Turn);
  #local Across = vrotate(z, y * Turn);
  #macro Rib(S) (Base + Length * (Out * S * 0.85 + y * (Rise * S - 0.75 * S * S))) #end
  #macro Edge(S, Sign) (Rib(S) + (Across * Sign + y * 0.35) * Width * pow(sin(pi * min(1, S * 0.94 + 0.06)), 0.8)) #end
  #for (I, 0, N - 1)
    #local S0 = I / N;
    #local S1 = (I + 1) / N;
    #for (Sign, -1, 1, 2)
      Tri(Rib(S0), Rib(S1), Edge(S1, Sign))
      Tri(Rib(S0), Edge(S1, Sign), Edge(S0, Sign))
    #end
  #end
#end

#macro Plant(Stems, Height, LeavesPerStem, Length)
  union {
    object {
      Turned(12, array[6] { <0, 0>, <0.13, 0>, <0.18, 0.30>, <0.19, 0.32>, <0.17, 0.32>, <0, 0.28> })
      Plain(srgb <0.82, 0.80, 0.76>)
    }
    #for (I, 0, Stems - 1)
      #local Foot = vrotate(<0.05, 0.26, 0>, y * 360 * I / Stems);
      #local Top = vrotate(<Between(0.08, 0.16), Height * Between(0.75, 1.0), 0>, y * (360 * I / Stems + 20));
      object {
        Rod(Foot, Top, 5, 0.011)
        Plain(srgb <0.40, 0.36, 0.24>)
      }
      #for (J, 0, LeavesPerStem - 1)
        #local F = 0.35 + 0.65 * J / (LeavesPerStem - 1);
        mesh {
          Leaf(Foot + (Top - Foot) * F, J * 137.5 + I * 50, Between(0.6, 1.1) + 0.3 * F,
               Length * Between(0.7, 1.05), Length * 0.16)
          Plain(srgb <0.25, 0.43, 0.20> * Between(0.75, 1.25))
        }
      #end
    #end
  }
#end

// A picture in the plane z = 0 facing -z; the caller gives its pigment.
#macro Picture(W, H, Art, FrameColour)
  union {
    object {
      Frame(W, H, 0.03, 0.035)
      Plain(FrameColour)
    }
    object {
      Block(<-W / 2, -H / 2, -0.012>, <W / 2, H / 2, 0>)
      Plain(Paper)
    }
    object {
      Block(<-W / 2 + 0.05, -H / 2 + 0.05, -0.014>, <W / 2 - 0.05, H / 2 - 0.05, -0.011>)
      texture {
        pigment { Art }
        finish { Matt }
      }
    }
  }
#end

#if (Untextured)
#declare ArtDunes = pigment { color srgb <0.85, 0.60, 0.35> }
#declare ArtTiles = pigment { color srgb <0.60, 0.55, 0.42> }
#else
#declare ArtDunes = pigment {
  gradient y
  turbulence <0.15, 0.20, 0>
  octaves 3
  color_map {
    [0.00 color srgb <0.30, 0.16, 0.15>]
    [0.28 color srgb <0.75, 0.35, 0.20>]
    [0.28 color srgb <0.88, 0.58, 0.30>]
    [0.52 color srgb <0.95, 0.80, 0.55>]
    [0.52 color srgb <0.55, 0.68, 0.70>]
    [1.00 color srgb <0.25, 0.42, 0.55>]
  }
  scale 1.02
  translate y * -0.52
}

#declare ArtTiles = pigment {
  checker
  pigment {
    checker color srgb <0.87, 0.72, 0.35>, color srgb <0.75, 0.30, 0.22>
    scale 0.5
  },
  pigment {
    gradient x
    color_map {
      [0.5 color srgb <0.20, 0.32, 0.42>]
      [0.5 color srgb <0.90, 0.87, 0.80>]
    }
    scale 0.25
  }
  scale 0.2
  translate <0.1, 0.1, 0.05>
}
#end

#macro WallMirror(W, H)
  union {
    object {
      Frame(W, H, 0.06, 0.05)
      Plain(Brass)
    }
    object {
      Frame(W - 0.03, H - 0.03, 0.015, 0.032)
      Plain(Walnut)
    }
    object {
      Block(<-W / 2, -H / 2, -0.02>, <W / 2, H / 2, 0>)
      texture { MirrorGlass }
    }
  }
#end

// A rug with a border: a woven pattern inside a plain field.
#macro Rug(W, D)
  union {
    object {
      Block(<-W / 2, 0, -D / 2>, <W / 2, 0.012, D / 2>)
      Plain(srgb <0.55, 0.22, 0.20>)
    }
    object {
      Block(<-W / 2 + 0.08, 0.011, -D / 2 + 0.08>, <W / 2 - 0.08, 0.013, D / 2 - 0.08>)
      Plain(srgb <0.90, 0.82, 0.68>)
    }
    object {
      Block(<-W / 2 + 0.11, 0.012, -D / 2 + 0.11>, <W / 2 - 0.11, 0.014, D / 2 - 0.11>)
      texture {
        pigment {
          #if (Untextured)
            color srgb <0.45, 0.32, 0.31>
          #else
            checker
            pigment { color srgb <0.24, 0.30, 0.40> },
            pigment {
              checker color srgb <0.60, 0.26, 0.22>, color srgb <0.72, 0.42, 0.28>
              scale <0.5, 1, 0.5>
            }
            scale <0.125, 1, 0.125>
            rotate y * 45
            translate y * -0.5
          #end
        }
        finish { Matt }
      }
    }
  }
#end

#macro WastePaper()
  object {
    Turned(10, array[4] { <0, 0.005>, <0.11, 0.005>, <0.15, 0.30>, <0.14, 0.30> })
    Plain(Steel)
  }
#end

// ---------------------------------------------------------------------------------------------
// The picture
// ---------------------------------------------------------------------------------------------
Room()
Window()
Curtains()
PendantLamp()
Outside()

union { // the desk under the window, its user facing -x
  Desk()
  object { Monitor() rotate y * 12 translate <-0.20, DeskY, 0.15> }
  object { Keyboard() rotate y * 4 translate <-0.18, DeskY, -0.17> }
  object { Mouse() rotate y * -8 translate <0.14, DeskY, -0.18> }
  object { DeskLamp() rotate y * 50 translate <0.66, DeskY, 0.20> }
  object { PenMug() translate <0.36, DeskY, 0.16> }
  object { PaperStack(8) rotate y * -12 translate <0.48, DeskY, -0.16> }
  object { BookStack(5) rotate y * 80 translate <-0.68, DeskY, 0.16> }
  rotate y * -90
  translate <0.46, 0, 2.85>
}
object { SwivelChair() rotate y * 62 translate <1.28, 0, 2.72> }
object { WastePaper() translate <0.30, 0, 1.60> }

object { Bookcase(1.84, 2.15, 6) translate <2.78, 0, RoomD - 0.30> }
object { WallMirror(1.30, 1.45) translate <1.75, 1.42, RoomD> }
object { Plant(4, 1.25, 8, 0.42) translate <0.55, 0, 4.45> }

object { Rug(2.3, 1.7) rotate y * 4 translate <3.05, 0, 3.0> }
object { Armchair() rotate y * 38 translate <3.75, 0.012, 3.55> }
object { LowTable() translate <2.62, 0.012, 3.30> }

object { Picture(0.55, 0.75, ArtDunes, Walnut) rotate y * -90 translate <0, 1.55, 0.85> } // in the mirror
object { Picture(0.55, 0.55, ArtTiles, Charcoal) translate <0.55, 1.95, RoomD> }

#debug concat("office.pov: ", str(Faces, 0, 0), " polygons\n")
