// SPDX-License-Identifier: AGPL-3.0-or-later
//
// A staircase hall between two mirrors that face each other.
//
// Tests: mirrors in mirrors. Both long walls carry a large flat mirror, so every step, rail and
//   shadow comes back again and again, each time smaller and dimmer; what is found of it depends on
//   --mirror-depth. Also thin balusters, their shadows, and steps whose nosings pierce the risers.
// Should be seen: a stair in the middle of a hall climbing away from the camera to a landing with a
//   door, a balustrade on both sides, a chequered floor, a lamp above; in the mirror at the right
//   the hall again, and in that the mirror of the left wall with a third and a fourth hall.
// Camera: aspect 4:3, meant for 640x480 and up.
// Options: Declare=Untextured=1 makes the floor and the runner plain.
//
// Units are metres; x right, y up, z into the hall.

#version 3.7;

#ifndef (Untextured)
  #declare Untextured = 0;
#end

global_settings {
  assumed_gamma 1.0
  max_trace_level 8
}

#declare HallW = 7;
#declare HallD = 11;
#declare HallH = 4.6;

camera {
  location <-2.5, 1.75, -3.3>
  right x * 4 / 3
  angle 66
  look_at <1.25, 1.45, 2>
}

light_source {
  <0.9, 3.75, 0.4>
  color rgb <1.0, 0.92, 0.78> * 0.85
}

light_source {
  <-2.6, 3.9, 6.6>
  color rgb <0.70, 0.82, 1.0> * 0.45
}

#declare Fill = rgb <0.21, 0.22, 0.24>;
#macro Matt(C)
  texture {
    pigment { color C }
    finish { ambient Fill diffuse 0.70 }
  }
#end

#declare Plaster = srgb <0.90, 0.86, 0.77>;
#declare Panel = srgb <0.42, 0.52, 0.50>;
#declare Marble = srgb <0.86, 0.84, 0.82>;
#declare Wood = srgb <0.46, 0.28, 0.18>;
#declare Gold = srgb <0.80, 0.63, 0.32>;
#declare Carpet = srgb <0.62, 0.16, 0.17>;

// -- the hall ----------------------------------------------------------------------------------
box {
  <-HallW / 2 - 1, -0.2, -5>, <HallW / 2 + 1, 0, HallD>
  texture {
    #if (Untextured)
      pigment { color Marble * 0.8 }
    #else
      pigment { checker color Marble, color srgb <0.33, 0.35, 0.37> scale 0.7 }
    #end
    finish { ambient Fill diffuse 0.70 }
  }
}
box { <-HallW / 2 - 1, HallH, -5>, <HallW / 2 + 1, HallH + 0.2, HallD> Matt(Plaster) }
box { <-HallW / 2 - 1, 0, HallD - 1>, <HallW / 2 + 1, HallH, HallD> Matt(Plaster) }
box { <-HallW / 2 - 1, 0, -5>, <HallW / 2 + 1, HallH, -4.8> Matt(Panel) }
#for (S, -1, 1, 2)
  box { <S * HallW / 2, 0, -5>, <S * (HallW / 2 + 0.5), HallH, HallD> Matt(Plaster) }
#end
#for (I, -5, 5) // beams under the ceiling
  box { <-HallW / 2, HallH - 0.22, I * 1.5 - 0.1>, <HallW / 2, HallH, I * 1.5 + 0.1> Matt(Wood) }
#end

// -- a mirror on each long wall, in a frame of four bars -------------------------------------------
#macro Mirror(S)
  union {
    box {
      <S * HallW / 2, 0.5, -1.6>, <S * (HallW / 2 - 0.03), 3.5, 4.6>
      texture {
        pigment { rgb 0.02 }
        finish { ambient 0 diffuse 0.5 reflection { rgb <0.86, 0.90, 0.88> } }
      }
    }
    union {
      box { <S * HallW / 2, 0.35, -1.75>, <S * (HallW / 2 - 0.09), 0.5, 4.75> }
      box { <S * HallW / 2, 3.5, -1.75>, <S * (HallW / 2 - 0.09), 3.65, 4.75> }
      box { <S * HallW / 2, 0.5, -1.75>, <S * (HallW / 2 - 0.09), 3.5, -1.6> }
      box { <S * HallW / 2, 0.5, 4.6>, <S * (HallW / 2 - 0.09), 3.5, 4.75> }
      Matt(Gold)
    }
  }
#end
Mirror(-1)
Mirror(1)

// -- the stair: from z = 1 upwards, with a balustrade on each side -----------------------------------
#declare Steps = 14;
#declare Rise = 0.16;
#declare Tread = 0.30;
#declare StairX = 1.25; // half its width
#declare StairZ = 1.2;

union {
  #for (I, 0, Steps - 1)
    box { <-StairX, 0, StairZ + I * Tread>, <StairX, (I + 1) * Rise, StairZ + Steps * Tread + 2> }
    box { // nosing
      <-StairX - 0.03, (I + 1) * Rise - 0.03, StairZ + I * Tread - 0.03>,
      <StairX + 0.03, (I + 1) * Rise + 0.001, StairZ + (I + 1) * Tread>
    }
  #end
  Matt(Marble)
}
union { // the runner
  #for (I, 0, Steps - 1)
    box {
      <-0.7, (I + 1) * Rise - 0.02, StairZ + I * Tread - 0.045>,
      <0.7, (I + 1) * Rise + 0.012, StairZ + (I + 1) * Tread>
    }
    box {
      <-0.7, I * Rise, StairZ + I * Tread - 0.012>, <0.7, (I + 1) * Rise, StairZ + I * Tread + 0.05>
    }
  #end
  texture {
    #if (Untextured)
      pigment { color Carpet }
    #else
      pigment {
        gradient x
        color_map {
          [0.08 color Carpet] [0.08 color Gold] [0.14 color Gold] [0.14 color Carpet]
          [0.86 color Carpet] [0.86 color Gold] [0.92 color Gold] [0.92 color Carpet]
        }
        scale 1.4
        translate x * 0.7
      }
    #end
    finish { ambient Fill diffuse 0.70 }
  }
}
box { // the landing
  <-HallW / 2, 0, StairZ + Steps * Tread>, <HallW / 2, Steps * Rise, HallD>
  Matt(Marble * 0.92)
}

// A square rod from A to B, T thick.
#macro Rod(A, B, T)
  #local L = vlength(B - A);
  #local Up = (B - A) / L;
  #local Side = vnormalize(vcross(Up, <0.1, 0.2, 1>));
  #local Third = vcross(Side, Up);
  box {
    <-T / 2, 0, -T / 2>, <T / 2, L, T / 2>
    matrix <Side.x, Side.y, Side.z, Up.x, Up.y, Up.z, Third.x, Third.y, Third.z, A.x, A.y, A.z>
  }
#end

#for (S, -1, 1, 2)
  #local X = S * (StairX - 0.12);
  union {
    #for (I, 0, 2 * Steps - 1)
      #local Y = (int(I / 2) + 1) * Rise;
      #local Z = StairZ + (I / 2 + 0.25) * Tread;
      box {
        <X - 0.018, Y, Z - 0.018>, <X + 0.018, (Z - StairZ) / Tread * Rise + 0.97, Z + 0.018>
      }
    #end
    Matt(srgb <0.90, 0.89, 0.85>)
  }
  union {
    object {
      Rod(<X, 0.97, StairZ - 0.05>, <X, Steps * Rise + 0.97, StairZ + Steps * Tread>, 0.07)
    }
    box { <X - 0.09, 0, StairZ - 0.2>, <X + 0.09, 1.12, StairZ - 0.02> }
    box { <X - 0.13, 1.12, StairZ - 0.24>, <X + 0.13, 1.18, StairZ + 0.02> }
    box { <X - 0.09, Steps * Rise, StairZ + Steps * Tread>, <X + 0.09, Steps * Rise + 1.12, StairZ + Steps * Tread + 0.18> }
    // along the landing to the wall
    box {
      <min(X, S * HallW / 2), Steps * Rise + 0.95, StairZ + Steps * Tread + 0.05>,
      <max(X, S * HallW / 2), Steps * Rise + 1.01, StairZ + Steps * Tread + 0.13>
    }
    Matt(Wood)
  }
  union {
    #for (I, 1, 12)
      #local XB = S * (StairX - 0.12 + I * (HallW / 2 - StairX + 0.12) / 13);
      box {
        <XB - 0.018, Steps * Rise, StairZ + Steps * Tread + 0.07>,
        <XB + 0.018, Steps * Rise + 0.95, StairZ + Steps * Tread + 0.11>
      }
    #end
    Matt(srgb <0.90, 0.89, 0.85>)
  }
#end

// -- a door on the landing, a bench, a chest and a lamp ------------------------------------------------
union {
  #local Y = Steps * Rise;
  #local Z = HallD - 1;
  box { <-0.62, Y, Z - 0.05>, <0.62, Y + 2.12, Z> Matt(Plaster * 1.05) }
  box { <-0.52, Y, Z - 0.07>, <0.52, Y + 2.02, Z> Matt(Wood) }
  #for (I, 0, 3)
    box {
      <-0.42 + 0.45 * mod(I, 2), Y + 0.2 + 0.95 * int(I / 2), Z - 0.09>,
      <-0.03 + 0.45 * mod(I, 2), Y + 1.0 + 0.85 * int(I / 2), Z - 0.06>
      Matt(Wood * 1.25)
    }
  #end
}
union {
  box { <-0.7, 0.42, -0.2>, <0.7, 0.48, 0.2> }
  #for (X, -1, 1, 2)
    box { <X * 0.6 - 0.04, 0, -0.18>, <X * 0.6 + 0.04, 0.42, 0.18> }
  #end
  rotate y * 82
  translate <2.7, 0, 1.0>
  Matt(Panel)
}
union {
  box { <-0.45, 0.05, -0.25>, <0.45, 0.5, 0.25> Matt(Wood * 1.1) }
  box { <-0.48, 0.5, -0.28>, <0.48, 0.58, 0.28> Matt(Wood) }
  box { <-0.06, 0.35, -0.28>, <0.06, 0.5, -0.25> Matt(Gold) }
  rotate y * -55
  translate <-2.35, 0, 1.6>
}
union { // the lamp: a hexagonal hoop with a chain; the light hangs below it
  #for (I, 0, 5)
    box {
      <-0.27, 0, 0.42>, <0.27, 0.09, 0.46>
      rotate y * 60 * I
    }
  #end
  box { <-0.47, 0.03, -0.02>, <0.47, 0.06, 0.02> }
  box { <-0.02, 0.03, -0.47>, <0.02, 0.06, 0.47> }
  box { <-0.02, 0.06, -0.02>, <0.02, 0.9, 0.02> }
  translate <0.9, 3.85, 0.4>
  Matt(Gold * 0.8)
}
