// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "core/ladder.h"

/// What the tracer says about a scene once it has parsed it: enough to plan the preview and to
/// place its geometry, without any of the tracer's own types. Lengths are in scene units, in
/// POV-Ray's left-handed world space.
namespace povpreview {

/// The largest picture that can be previewed: sides that GL textures and indices can hold, and
/// colours of it in 4 GiB.
constexpr std::int64_t max_image_side = 65535, max_image_pixels = std::int64_t{1} << 28;
constexpr bool image_size_fits(std::int64_t width, std::int64_t height) {
    return width >= 1 && height >= 1 && width <= max_image_side && height <= max_image_side &&
           width * height <= max_image_pixels;
}

/// POV-Ray's camera kinds; the cylinders are its `cylinder 1` .. `cylinder 4`.
enum class CameraKind : std::uint8_t {
    perspective,
    orthographic,
    fisheye,
    ultra_wide_angle,
    omnimax,
    panoramic,
    cylinder_1,
    cylinder_2,
    cylinder_3,
    cylinder_4,
    spherical,
    mesh
};

struct CameraDescription {
    CameraKind kind = CameraKind::perspective;
    glm::dvec3 location{}, direction{}, right{}, up{}, sky{}, look_at{};
    double angle = 0;  ///< degrees; 0 where the camera has none
    double aperture = 0, focal_distance = 0;
    std::uint32_t blur_samples = 0;  ///< rays per sample under focal blur; 0: no blur
    bool perturbed = false;          ///< has a normal, so straight lines are not straight in it
};

/// `area` wins over the other kinds: an area light with a spot's cone is `area`.
enum class LightKind : std::uint8_t { point, spot, parallel, cylinder, area, fill };

struct LightDescription {
    LightKind kind = LightKind::point;
    glm::dvec3 position{}, points_at{};
    glm::vec3 colour{};
    bool parallel = false, shadowless = false, jitter = false;
    std::uint32_t area_rows = 0, area_columns = 0;
    bool in_group = false;  ///< belongs to a light_group, so it lights only that group's objects
};

/// How many of a kind the scene has, the kind by its keyword in POV-Ray's language.
struct KindCount {
    std::string kind;
    std::uint32_t count = 0;
};

struct SceneDescription {
    int width = 0, height = 0;  ///< pixels; what POV-Ray made of options and INI files
    float working_gamma = 1;    ///< what it computes in; samples are linear whatever this is
    bool antialias = false;     ///< the user asked for anti-aliasing; samples are never filtered
    CameraDescription camera;
    std::vector<LightDescription> lights;
    std::vector<std::string> features;  ///< "radiosity", "fog", "reflection" ..., see wire.fbs
    std::vector<KindCount> textures;    ///< pigments by kind
    std::vector<KindCount> objects;     ///< objects by kind
    glm::vec3 background{};
    bool alpha = false;  ///< samples are without the background where it shines through (+UA)
    std::string output;  ///< the image file that POV-Ray would write, by its rules; empty: none
    std::vector<std::string> files;  ///< that it has read, as it names them
    Ladder ladder;
    /// Full samples that the tracer waits for before it prepares the target, where it has to.
    std::uint32_t first_look = 0;

    bool has(std::string_view feature) const {
        return std::find(features.begin(), features.end(), feature) != features.end();
    }
};

}  // namespace povpreview
