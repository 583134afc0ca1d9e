// SPDX-License-Identifier: AGPL-3.0-or-later
#include "adapter/straight_camera.h"

#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace povpreview {
namespace {

const char* const kind_names[] = {"perspective", "orthographic", "fisheye",    "ultra_wide_angle",
                                  "omnimax",     "panoramic",    "cylinder 1", "cylinder 2",
                                  "cylinder 3",  "cylinder 4",   "spherical",  "mesh"};

/// The coefficients (a, b, c) of p - location = a direction + b right + c up, as rows on (p, 1).
struct Coordinates {
    glm::dvec4 along, right, up;
};

glm::dvec4 row(const glm::dmat3& inverse, int i, const glm::dvec3& location) {
    const glm::dvec3 linear(inverse[0][i], inverse[1][i], inverse[2][i]);
    return {linear, -glm::dot(linear, location)};
}

Coordinates coordinates(const CameraDescription& camera) {
    const glm::dmat3 inverse = glm::inverse(glm::dmat3(camera.direction, camera.right, camera.up));
    return {row(inverse, 0, camera.location), row(inverse, 1, camera.location),
            row(inverse, 2, camera.location)};
}

/// Relative to the lengths of its axes; a camera flatter than this sees nothing sensible.
bool is_flat(const CameraDescription& camera) {
    const double volume =
        std::fabs(glm::dot(camera.direction, glm::cross(camera.right, camera.up)));
    const double size =
        glm::length(camera.direction) * glm::length(camera.right) * glm::length(camera.up);
    return !(volume > 1e-9 * size) || !std::isfinite(size) ||
           !std::isfinite(glm::length(camera.location));
}

}  // namespace

std::string why_not_straight(const CameraDescription& camera) {
    if (camera.kind != CameraKind::perspective && camera.kind != CameraKind::orthographic)
        return std::string("the camera is of kind ") +
               kind_names[static_cast<std::size_t>(camera.kind)];
    if (camera.perturbed) return "the camera has a normal";
    if (camera.blur_samples > 0) return "the camera has focal blur";
    if (is_flat(camera)) return "the camera has no volume";
    return "";
}

StraightCamera straight_camera(const CameraDescription& camera, int width, int height) {
    assert(why_not_straight(camera).empty());
    const Coordinates on = coordinates(camera);
    const glm::dvec4 one(0, 0, 0, 1);
    const bool perspective = camera.kind == CameraKind::perspective;
    const glm::dvec4 w = perspective ? on.along : one;
    const glm::dvec4 x = double(width) * (on.right + .5 * w), y = double(height) * (.5 * w - on.up);
    StraightCamera result;
    result.eye = perspective ? glm::dvec4(camera.location, 1) : glm::dvec4(-camera.direction, 0);
    for (int i = 0; i < 4; ++i) result.to_pixels[i] = glm::dvec3(x[i], y[i], w[i]);
    // Distance from the plane of the eye, which is spanned by right and up.
    const glm::dvec3 view = glm::normalize(glm::cross(camera.right, camera.up));
    result.depth = std::fabs(glm::dot(camera.direction, view)) * on.along;
    return result;
}

}  // namespace povpreview
