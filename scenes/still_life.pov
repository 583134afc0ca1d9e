// SPDX-License-Identifier: AGPL-3.0-or-later
//
// A still life: fruit, a glass of wine, a jug and a crystal ball on a wooden table.
//
// Tests: what geometry alone cannot tell. Curved outlines (lathes, spheres, a sphere sweep), CSG
//   (the bowl, the cut lemon), refraction through nested glass and wine and through a ball, mirror
//   images on curved gloss, penumbrae of an area light, procedural wood, bumps on an orange, and
//   a cloth as a smooth mesh.
// Should be seen: soft light from a window on the left, which stands as a bright cross-barred
//   highlight on everything glossy; the room upside down in the ball; a reddish shadow where the
//   light went through the wine; a pale cloth that runs under the bowl and falls over the edge of
//   the table in folds.
// Camera: aspect 4:3, meant for 640x480 and up.
//
// Units are centimetres; x right, y up, z away; the table top is y = 0. The area light is not
// jittered, so that every pixel has one value, whatever the order of rendering.

#version 3.7;

global_settings {
  assumed_gamma 1.0
  max_trace_level 7
  adc_bailout 0.015
}

camera {
  location <3, 25, -74>
  right x * 4 / 3
  angle 41
  look_at <0.9, 5.3, 0>
}

// ---------------------------------------------------------------------------------------------
// Light: a window on the left, as an area light and as something to be mirrored
// ---------------------------------------------------------------------------------------------
#declare WindowAt = <-60, 62, -42>;
#declare WindowSide = vnormalize(<-42, 0, 60>);
#declare WindowUp = vnormalize(vcross(WindowSide, WindowAt));
#declare WindowUp = WindowUp * (WindowUp.y < 0 ? -1 : 1);

light_source {
  WindowAt
  color rgb <1.0, 0.93, 0.82> * 2.3
  area_light WindowSide * 26, WindowUp * 26, 9, 9
  adaptive 1
  fade_distance 75
  fade_power 2
}

light_source { // what the room gives back
  <60, 45, -80>
  color rgb <0.72, 0.82, 1.0> * 0.16
  shadowless
}

#macro Pane(U0, U1, V0, V1)
  polygon {
    5,
    WindowAt * 1.05 + WindowSide * U0 + WindowUp * V0,
    WindowAt * 1.05 + WindowSide * U1 + WindowUp * V0,
    WindowAt * 1.05 + WindowSide * U1 + WindowUp * V1,
    WindowAt * 1.05 + WindowSide * U0 + WindowUp * V1,
    WindowAt * 1.05 + WindowSide * U0 + WindowUp * V0
  }
#end

union {
  #for (I, 0, 1)
    #for (J, 0, 2)
      Pane(-19 + 20 * I, -1 + 20 * I, -28 + 19 * J, -11 + 19 * J)
    #end
  #end
  texture {
    pigment { rgb <0.92, 0.97, 1.0> }
    finish { ambient 0 diffuse 0 emission 4 }
  }
}

// ---------------------------------------------------------------------------------------------
// Materials
// ---------------------------------------------------------------------------------------------
#declare Fill = rgb <0.085, 0.08, 0.08>;

#macro Glossy(Shine)
  finish {
    ambient Fill
    diffuse 0.72
    specular 0.05 * Shine
    roughness 0.01
    reflection { 0.02 * Shine, 0.22 * Shine }
  }
#end

#declare DullFinish = finish { ambient Fill diffuse 0.75 }

#declare Glass = material {
  texture {
    pigment { rgbf <0.985, 0.995, 0.99, 0.98> }
    finish {
      ambient 0
      diffuse 0
      reflection { 0.03, 0.9 fresnel on }
      conserve_energy
    }
  }
  interior {
    ior 1.5
    caustics 0.7
  }
}

#declare Wine = material {
  texture {
    pigment { rgbf <0.72, 0.05, 0.08, 0.95> }
    finish { ambient 0 diffuse 0 reflection { 0.02, 0.5 fresnel on } conserve_energy }
  }
  interior {
    ior 1.34
    caustics 0.5
    fade_distance 3
    fade_power 1001
    fade_color rgb <0.55, 0.02, 0.05>
  }
}

#macro Timber(Light, Dark, Where)
  texture {
    pigment {
      wood
      turbulence 0.09
      octaves 4
      omega 0.6
      color_map {
        [0.0 color Light]
        [0.45 color Light * 0.6 + Dark * 0.4]
        [0.85 color Dark]
        [1.0 color Light]
      }
      scale <1.7, 1.7, 40>
      rotate <2, 88, 0>
      translate Where
    }
    finish {
      ambient Fill
      diffuse 0.68
      specular 0.08
      roughness 0.04
      reflection { 0.01, 0.16 }
    }
  }
#end

// ---------------------------------------------------------------------------------------------
// Table and wall
// ---------------------------------------------------------------------------------------------
#declare Edge = -19; // z of the table's front edge

#macro Plank(Z0, Z1, Where)
  box {
    <-90, -4, Z0 + 0.06>, <90, 0, Z1 - 0.06>
    Timber(srgb <0.58, 0.38, 0.22>, srgb <0.36, 0.21, 0.12>, Where)
  }
#end

Plank(Edge, -4, <0, 5, 3>)
Plank(-4, 10, <7, -9, 11>)
Plank(10, 26, <-20, 12, -2>)
box { // below the planks: the dark of the joints, and the rail under the edge
  <-88, -14, Edge + 4>, <88, -0.8, 26>
  texture {
    pigment { srgb <0.24, 0.15, 0.10> }
    finish { DullFinish }
  }
}

plane {
  -z, -60
  texture {
    pigment {
      bozo
      turbulence 0.8
      color_map {
        [0.0 color srgb <0.42, 0.42, 0.36>]
        [1.0 color srgb <0.33, 0.34, 0.31>]
      }
      scale 30
    }
    finish { DullFinish }
  }
}

// ---------------------------------------------------------------------------------------------
// The cloth: a rectangle laid on the table, bent over its edge
//
//     -------------.        flat as far as the edge, then around a bend of radius Bend,
//                   \       then down, where folds grow with the depth they hang
//                    |
// ---------------------------------------------------------------------------------------------
#declare Bend = 1.5;
#declare ClothW = 34;
#declare ClothL = 46;
#declare ClothNU = 84;
#declare ClothNV = 56;

#macro ClothPoint(U, V)
  #local Flat = vrotate(<(U - 0.5) * ClothW, 0, -V * ClothL>, y * -14) + <-4.5, 0, 15>;
  #local Over = Edge - Flat.z;
  #local Lift = 0.12 + 0.10 * (1 + sin(Flat.x * 0.42 + Flat.z * 0.23)) * (1 + sin(Flat.z * 0.31 - Flat.x * 0.13));
  #local Turn = max(0, min(Over / Bend, pi / 2));
  #local Hang = max(0, Over - Bend * pi / 2);
  #local Fold = (1 - exp(-0.045 * Hang * Hang))
    * (1.1 + sin(Flat.x * 0.66 + 0.4 * sin(Flat.x * 0.31)) + 0.25 * sin(Flat.x * 1.31 + Hang * 0.10));
  <Flat.x + 0.25 * Fold,
   (Bend + Lift) * cos(Turn) - Bend - Hang,
   max(Flat.z, Edge) - (Bend + Lift) * sin(Turn) - 0.9 * Fold>
#end

// A grid of points with a margin of one all round, so that every corner's normal can be had
// from its neighbours.
#macro Cloth()
  #local P = array[ClothNU + 3][ClothNV + 3]
  #local N = array[ClothNU + 3][ClothNV + 3]
  #for (I, 0, ClothNU + 2)
    #for (J, 0, ClothNV + 2)
      #local P[I][J] = ClothPoint((I - 1) / ClothNU, (J - 1) / ClothNV);
    #end
  #end
  #for (I, 1, ClothNU + 1)
    #for (J, 1, ClothNV + 1)
      #local N[I][J] = vcross(P[I][J + 1] - P[I][J - 1], P[I + 1][J] - P[I - 1][J]);
    #end
  #end
  mesh {
    #for (I, 1, ClothNU)
      #for (J, 1, ClothNV)
        smooth_triangle { P[I][J], N[I][J], P[I + 1][J], N[I + 1][J], P[I + 1][J + 1], N[I + 1][J + 1] }
        smooth_triangle { P[I][J], N[I][J], P[I + 1][J + 1], N[I + 1][J + 1], P[I][J + 1], N[I][J + 1] }
      #end
    #end
  }
#end

object {
  Cloth()
  texture {
    pigment { srgb <0.90, 0.88, 0.83> }
    finish { DullFinish }
  }
}

// ---------------------------------------------------------------------------------------------
// Fruit, each standing on y = 0
// ---------------------------------------------------------------------------------------------
#declare Stalk = union {
  cone { <0, 0, 0>, 0.16, <0.15, 1.0, 0>, 0.13 }
  sphere { <0.15, 1.0, 0>, 0.13 }
  cone { <0.15, 1.0, 0>, 0.13, <0.50, 1.8, 0.1>, 0.22 }
  texture {
    pigment { srgb <0.32, 0.22, 0.13> }
    finish { DullFinish }
  }
}

#macro Apple(Sunny, Shady, Turn)
  union {
    lathe {
      cubic_spline
      11,
      <-0.8, 0.3>, <0, 0.75>, <1.0, 0.15>, <2.6, 0.45>, <3.75, 2.5>, <4.05, 4.4>,
      <3.3, 6.3>, <2.0, 7.0>, <0.9, 6.6>, <0, 5.6>, <-0.8, 5.2>
      texture {
        pigment {
          radial
          turbulence 0.25
          color_map {
            [0.00 color Sunny]
            [0.45 color Sunny * 0.8]
            [0.60 color Shady]
            [0.75 color Shady]
            [1.00 color Sunny]
          }
          scale <1, 6, 1>
        }
        Glossy(1)
      }
      texture { // flecks
        pigment {
          granite
          color_map {
            [0.0 color srgbt <0.95, 0.88, 0.60, 0.45>]
            [0.16 color srgbt <0.95, 0.88, 0.60, 1>]
            [1.0 color srgbt <0.95, 0.88, 0.60, 1>]
          }
          scale 1.3
        }
        Glossy(1)
      }
    }
    object { Stalk translate y * 5.7 }
    rotate y * Turn
  }
#end

#declare Pear = union {
  lathe {
    cubic_spline
    11,
    <-1, 0.6>, <0, 0.7>, <1.1, 0.15>, <2.9, 0.8>, <3.95, 3.2>, <3.5, 5.6>,
    <2.25, 7.7>, <1.75, 9.3>, <1.15, 10.4>, <0, 10.8>, <-1.2, 10.4>
    texture {
      pigment {
        bozo
        turbulence 0.5
        color_map {
          [0.0 color srgb <0.80, 0.74, 0.30>]
          [0.6 color srgb <0.72, 0.70, 0.28>]
          [1.0 color srgb <0.70, 0.50, 0.22>]
        }
        scale 4
      }
      Glossy(0.6)
    }
  }
  object { Stalk scale <0.9, 1.1, 0.9> translate y * 10.5 }
}

#declare Orange = sphere {
  <0, 3.7, 0>, 3.8
  scale <1, 0.96, 1>
  texture {
    pigment { srgb <0.93, 0.53, 0.13> }
    normal { bumps 0.25 scale 0.28 }
    Glossy(0.6)
  }
}

#declare LemonPeel = texture {
  pigment { srgb <0.95, 0.80, 0.20> }
  normal { bumps 0.2 scale 0.25 }
  Glossy(0.7)
}

#declare LemonShape = lathe {
  cubic_spline
  10,
  <-0.5, -4.2>, <0, -4.3>, <0.5, -4.0>, <1.6, -3.0>, <2.85, 0>, <2.6, 1.6>, <1.6, 3.0>,
  <0.6, 3.9>, <0, 4.2>, <-0.5, 4.1>
  texture { LemonPeel }
}

// Half a lemon, cut in the plane y = 0; the cut faces up.
#declare Pith = srgb <0.96, 0.93, 0.76>;
#declare LemonFlesh = pigment {
  radial
  frequency 9
  color_map {
    [0.00 color Pith]
    [0.06 color srgb <0.95, 0.86, 0.42>]
    [0.50 color srgb <0.93, 0.80, 0.30>]
    [0.94 color srgb <0.95, 0.86, 0.42>]
    [1.00 color Pith]
  }
}

#declare HalfLemon = intersection {
  sphere {
    0, 1
    scale <2.86, 3.6, 2.86>
    texture { LemonPeel }
  }
  plane {
    y, 0
    texture {
      pigment {
        cylindrical
        pigment_map {
          [0.00 color srgb <0.95, 0.80, 0.20>]
          [0.06 color srgb <0.95, 0.80, 0.20>]
          [0.06 color Pith]
          [0.14 color Pith]
          [0.15 LemonFlesh]
          [0.90 LemonFlesh]
          [0.93 color Pith]
        }
        scale 2.86
      }
      normal { bumps 0.15 scale 0.4 }
      Glossy(0.7)
    }
  }
}

// Grapes in three layers, each on the hollows of the one below, narrowing towards the tip at +x.
#declare Dice = seed(1632);

#declare Grapes = union {
  #for (Layer, 0, 2)
    #for (I, -4, 5)
      #for (J, -3, 3)
        #local X = 1.78 * (I + 0.5 * mod(J + 4, 2)) + 0.9 * Layer;
        #local Z = 1.55 * J + 0.5 * Layer;
        #local Reach = (7.4 - 2.0 * Layer - X) * 0.42 - 0.3 * Layer;
        #if (X > -6.8 + 1.6 * Layer & X < 7.2 - 2.4 * Layer & abs(Z) < min(Reach, 4.4 - 1.1 * Layer))
          sphere {
            <X + 0.25 * (rand(Dice) - 0.5), 0.95 + 1.42 * Layer + 0.2 * rand(Dice), Z + 0.25 * (rand(Dice) - 0.5)>,
            0.92 + 0.10 * rand(Dice)
          }
        #end
      #end
    #end
  #end
  texture {
    pigment {
      bozo
      color_map {
        [0.0 color srgb <0.20, 0.07, 0.20>]
        [0.5 color srgb <0.30, 0.10, 0.24>]
        [1.0 color srgb <0.40, 0.32, 0.46>]
      }
      scale 1.2
    }
    Glossy(1)
  }
}

#declare Cherry = union {
  sphere {
    0, 1.15
    scale <1, 0.92, 1>
    translate y * 1.06
    texture {
      pigment { srgb <0.62, 0.06, 0.09> }
      Glossy(1.6)
    }
  }
  #for (I, 0, 5)
    #local A = <0.10 * I * I * 0.55, 1.95 + 0.72 * I, 0>;
    #local B = <0.10 * (I + 1) * (I + 1) * 0.55, 1.95 + 0.72 * (I + 1), 0>;
    cone {
      A, 0.085, B, 0.085 + 0.03 * (I = 5)
      texture {
        pigment { srgb <0.42, 0.47, 0.18> }
        finish { DullFinish }
      }
    }
  #end
}

// ---------------------------------------------------------------------------------------------
// Vessels: each profile is one closed run of Bezier pieces, outside upwards, inside downwards
// ---------------------------------------------------------------------------------------------
#declare WineGlass = union {
  lathe {
    bezier_spline
    36,
    <0, 0.12>, <1.2, 0.12>, <2.6, 0>, <3.5, 0>,
    <3.5, 0>, <3.62, 0>, <3.62, 0.16>, <3.5, 0.16>,
    <3.5, 0.16>, <2.0, 0.3>, <0.5, 0.5>, <0.36, 1.6>,
    <0.36, 1.6>, <0.30, 3.5>, <0.30, 6.0>, <0.36, 7.6>,
    <0.36, 7.6>, <0.5, 8.6>, <3.9, 8.9>, <4.1, 13>,
    <4.1, 13>, <4.2, 15.5>, <3.6, 17.5>, <3.3, 19.5>,
    <3.3, 19.5>, <3.28, 19.58>, <3.2, 19.58>, <3.2, 19.5>,
    <3.2, 19.5>, <3.5, 17.5>, <4.08, 15.4>, <3.98, 13>,
    <3.98, 13>, <3.8, 9.3>, <1.2, 9.0>, <0, 8.9>
    material { Glass }
  }
  lathe { // reaches a hair into the glass, so that no air lies between
    bezier_spline
    8,
    <0, 8.86>, <1.22, 8.96>, <3.84, 9.26>, <4.03, 13>,
    <4.03, 13>, <3, 13>, <1, 13>, <0, 13>
    material { Wine }
  }
}

#declare Glaze = texture {
  pigment {
    gradient y
    turbulence 0.03
    color_map {
      [0.00 color srgb <0.72, 0.64, 0.52>]
      [0.30 color srgb <0.72, 0.64, 0.52>]
      [0.33 color srgb <0.20, 0.38, 0.42>]
      [0.60 color srgb <0.14, 0.30, 0.37>]
      [1.00 color srgb <0.10, 0.24, 0.32>]
    }
    scale 25
  }
  Glossy(1.3)
}

#declare Jug = union {
  lathe {
    bezier_spline
    32,
    <0, 0>, <2, 0>, <3, 0>, <5, 0>,
    <5, 0>, <5.4, 0>, <5.3, 0.6>, <5.2, 0.8>,
    <5.2, 0.8>, <9.5, 4>, <10.2, 11.5>, <6, 16.5>,
    <6, 16.5>, <4.0, 18.9>, <3.7, 20.5>, <4.6, 23.5>,
    <4.6, 23.5>, <4.75, 24>, <4.35, 24>, <4.2, 23.5>,
    <4.2, 23.5>, <3.3, 20.5>, <3.6, 18.7>, <5.4, 16.5>,
    <5.4, 16.5>, <9.4, 11.5>, <8.8, 4>, <4.8, 1.5>,
    <4.8, 1.5>, <3, 1.2>, <1, 1.2>, <0, 1.2>
    texture { Glaze }
  }
  sphere_sweep { // the handle
    b_spline
    8,
    <2.5, 21.0, 0>, 0.70, <4.3, 21.8, 0>, 0.70, <7.6, 22.8, 0>, 0.68, <10.2, 20.4, 0>, 0.66,
    <10.4, 16.0, 0>, 0.64, <9.2, 12.6, 0>, 0.66, <7.2, 10.8, 0>, 0.74, <4.5, 9.5, 0>, 0.74
    texture { Glaze }
  }
}

#declare Bowl = difference {
  union {
    intersection {
      sphere { 0, 1 scale <13, 8.6, 13> translate y * 8.4 }
      plane { y, 7.4 }
      plane { -y, -0.6 }
    }
    cylinder { <0, 0, 0>, <0, 1.4, 0>, 5.2 }
    torus { 12.62, 0.32 translate y * 7.4 }
  }
  sphere { 0, 1 scale <12.35, 7.9, 12.35> translate y * 8.4 }
  texture {
    pigment { srgb <0.84, 0.86, 0.82> }
    Glossy(1.2)
  }
}

// ---------------------------------------------------------------------------------------------
// The arrangement
// ---------------------------------------------------------------------------------------------
#declare OnCloth = 0.3;

object { Jug rotate y * 155 translate <-17.5, 0, 10> }

union { // the bowl and what it holds
  object { Bowl }
  object {
    Apple(srgb <0.74, 0.13, 0.10>, srgb <0.84, 0.66, 0.24>, 130)
    rotate <-14, 0, 12>
    translate <-5.6, 4.0, -4.4>
  }
  object { Orange translate <3.0, 4.6, -5.4> }
  object {
    Apple(srgb <0.52, 0.62, 0.18>, srgb <0.76, 0.70, 0.28>, 20)
    rotate <8, 0, -14>
    translate <6.4, 4.4, 2.2>
  }
  object {
    Apple(srgb <0.70, 0.16, 0.10>, srgb <0.86, 0.62, 0.22>, 250)
    rotate <10, 0, 10>
    translate <-4.5, 4.6, 4.6>
  }
  object { Pear rotate <-8, 40, 16> translate <1.2, 5.8, 0.8> }
  translate <-2.5, OnCloth, 3>
}

object { WineGlass rotate y * 20 translate <15.5, 0, 5> }
object { Grapes rotate y * 24 translate <-12.5, OnCloth, -11.5> }
object { HalfLemon rotate <-62, 0, 0> rotate y * -18 translate <7.6, 2.95, -12.5> }
object { LemonShape rotate z * 84 rotate y * 35 translate <12.6, 2.75, -9.4> }
sphere {
  <20.5, 4.2, -7>, 4.2
  material { Glass }
}
object { Cherry rotate y * 160 translate <0.4, OnCloth, -15.0> }
object { Cherry rotate <0, 0, 4> rotate y * 200 translate <2.9, OnCloth, -14.2> }
