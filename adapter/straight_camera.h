// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>

#include "adapter/scene.h"
#include "core/polygonal/polygon_scene.h"

namespace povpreview {

/// Why straight lines of the scene are not straight (or not sharp) in the image, or not known to
/// be: "a fisheye camera", "focal blur" ... Empty if they are straight.
std::string why_not_straight(const CameraDescription& camera);

/// POV-Ray's perspective and orthographic cameras (its TracePixel::CreateCameraRay): a pixel's ray
/// has the direction, or from the location the origin,
///
///     direction + (px / width - .5) right + (.5 - py / height) up
///
/// REQUIRES: why_not_straight(camera) is empty.
StraightCamera straight_camera(const CameraDescription& camera, int width, int height);

}  // namespace povpreview
