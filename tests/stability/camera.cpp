// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Cameras: angles, axes, sizes of pictures, places.
#include "tests/stability/series.h"

// A scene that every camera here looks at.
#define SUBJECT                                                                         \
    "light_source { <5, 8, -6>, 1 }\n"                                                  \
    "plane { y, 0 pigment { checker rgb 1, rgb .3 } }\n"                                \
    "box { <-1.5, 0, 0>, <-.3, 1.2, 1> pigment { rgb <.3, .5, 1> } }\n"                 \
    "sphere { <.8, .7, 0>, .7 pigment { rgb <1, .3, .2> } finish { reflection .2 } }\n" \
    "mesh { triangle { <-3, 0, 2>, <0, 3, 3>, <3, 0, 2.5> } pigment { rgb <.4, .8, .3> } }\n"

namespace povpreview::stability {

std::vector<Series> camera_series() {
    return {
        {"camera",
         "angle",
         "views of almost nothing, and of almost half of all",
         "degrees",
         {1e-3, 150, 179.9},
         {1e-1, 10, 90, 175, 179},
         R"(
camera { location <0, 2, -6> angle K look_at <.2, .7, 0> }
)" SUBJECT},
        {"camera",
         "skewed",
         "axes that are almost one",
         "degrees between right and up",
         {30, 1e-3},
         {1e-6, 1e-1, 1, 170},
         R"(
camera { location <0, 2, -6> direction <0, -.2, 1> right vrotate(y, -K * z) * 4 / 3 up y }
)" SUBJECT},
        {"camera",
         "mirrored",
         "pictures the other way round",
         "scale of right",
         {-1.333},
         {-100, 100},
         R"(
camera { location <0, 2, -6> right K * x up y look_at <0, .7, 0> }
)" SUBJECT},
        {"camera",
         "pixel",
         "a picture of one pixel",
         "degrees",
         {50},
         {},
         R"(
camera { location <0, 2, -6> angle K look_at <0, .7, 0> }
)" SUBJECT,
         "1x1"},
        {"camera",
         "two_pixels",
         "a picture too small for a grid",
         "degrees",
         {50},
         {},
         R"(
camera { location <0, 2, -6> angle K look_at <0, .7, 0> }
)" SUBJECT,
         "2x1"},
        {"camera",
         "row",
         "a picture without height",
         "height of the view",
         {.01},
         {1},
         R"(
camera { location <0, 2, -6> right 4 * x up K * y look_at <0, .7, 0> }
)" SUBJECT,
         "1000x1"},
        {"camera",
         "column",
         "a picture without width",
         "width of the view",
         {.01},
         {1},
         R"(
camera { location <0, 2, -6> right K * x up 4 * y look_at <0, .7, 0> }
)" SUBJECT,
         "1x1000"},
        {"camera",
         "strip",
         "a picture a thousand times as wide as high",
         "height of the view",
         {.01},
         {1},
         R"(
camera { location <0, 2, -6> right 4 * x up K * y look_at <0, .7, 0> }
)" SUBJECT,
         "2000x2"},
        {"camera", "inside", "an eye within things", "size of the hull", {1}, {1e-3, 100}, R"(
camera { location <0, 2, -6> look_at <0, .7, 0> }
sphere { <0, 2, -6>, K pigment { rgbt <1, .8, .6, .7> } hollow }
box { <-2, 0, -8> , <2, 4, -4> pigment { rgbf <.6, .8, 1, .8> } }
)" SUBJECT},
        {"camera",
         "in_a_face",
         "an eye in a face",
         "distance of the face from the eye",
         {0, 1e-9},
         {1e-6, 1e-3},
         R"(
camera { location <0, 2, -6> look_at <0, .7, 0> }
box { <-2, 0, -8>, <0, 4, -6 + K> pigment { rgb <.9, .9, .2> } }
polygon { 5, <-1, 0, -6 + K>, <1, 0, -6 + K>, <1, 4, -6 + K>, <-1, 4, -6 + K>, <-1, 0, -6 + K>
  pigment { rgbt <.2, .8, .8, .5> } }
)" SUBJECT},
        {"camera", "straight_down", "a sky along the line of sight", "tilt", {0, 1e-9}, {1e-3}, R"(
camera { location <0, 6, 0> look_at <K, 0, 0> }
)" SUBJECT},
        {"camera", "orthographic", "no eye at all", "size of the view", {3, 1e3}, {1e-6, 1e6}, R"(
camera { orthographic location <0, 2, -6> right K * 4 / 3 * x up K * y look_at <0, .7, 0> }
)" SUBJECT},
        {"camera",
         "fisheye",
         "lines that are not straight, and pixels without rays",
         "degrees",
         {180},
         {1, 360},
         R"(
camera { fisheye location <0, 2, -6> angle K look_at <0, .7, 0> }
)" SUBJECT},
        {"camera", "spherical", "a picture that meets itself", "degrees", {360}, {10}, R"(
camera { spherical location <0, 2, -6> angle K look_at <0, .7, 0> }
)" SUBJECT},
        {"camera", "blur", "samples that are means of many", "aperture", {.4}, {1e-6, 10}, R"(
camera { location <0, 2, -6> look_at <0, .7, 0> aperture K blur_samples 7 focal_point <0, 0, 2> }
)" SUBJECT},
        {"camera", "bent_rays", "a camera whose rays are turned at random", "bumps", {.3}, {3}, R"(
camera { location <0, 2, -6> look_at <0, .7, 0> normal { bumps K scale .1 } }
)" SUBJECT},
    };
}

}  // namespace povpreview::stability
