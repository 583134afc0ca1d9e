// SPDX-License-Identifier: AGPL-3.0-or-later
#include "backend/oracle/scene_description.h"

// The order of POV-Ray's headers matters: frame.h first, povdebug.h last.
// clang-format off
#include "backend/frame.h"
#include "backend/lighting/point.h"
#include "backend/scene/camera.h"
#include "backend/scene/scene.h"
#include "backend/scene/view.h"
// clang-format on

#include "backend/oracle/scene_contents.h"
#include "base/povdebug.h"

namespace povpreview::tracer {

namespace {

/// Numbers of wire::LightKind.
enum class LightKind : std::uint8_t { point, spot, parallel, cylinder, area, fill };

Point point(const pov::VECTOR v) { return {v[0], v[1], v[2]}; }

CameraFacts describe(const pov::Camera& camera) {
    CameraFacts facts;
    // Both enumerations are in the order of POV-Ray's *_CAMERA, which begin at 1.
    facts.kind = static_cast<std::uint8_t>(camera.Type - PERSPECTIVE_CAMERA);
    facts.location = point(camera.Location);
    facts.direction = point(camera.Direction);
    facts.right = point(camera.Right);
    facts.up = point(camera.Up);
    facts.sky = point(camera.Sky);
    facts.look_at = point(camera.Look_At);
    if (camera.Type != ORTHOGRAPHIC_CAMERA && camera.Type != MESH_CAMERA)
        facts.angle = camera.Type == SPHERICAL_CAMERA ? camera.H_Angle : camera.Angle;
    if (camera.Aperture != 0 && camera.Blur_Samples > 0) {
        facts.aperture = camera.Aperture;
        facts.focal_distance = camera.Focal_Distance;
        facts.blur_samples = static_cast<unsigned>(camera.Blur_Samples);
    }
    facts.perturbed = camera.Tnormal != nullptr;
    return facts;
}

LightKind kind_of(const pov::LightSource& light) {
    if (light.Area_Light) return LightKind::area;
    if (light.Light_Type == FILL_LIGHT_SOURCE) return LightKind::fill;
    if (light.Light_Type == SPOT_SOURCE) return LightKind::spot;
    if (light.Light_Type == CYLINDER_SOURCE) return LightKind::cylinder;
    return light.Parallel ? LightKind::parallel : LightKind::point;
}

LightFacts describe(const pov::LightSource& light, const LinearLight& linear) {
    LightFacts facts;
    facts.kind = static_cast<std::uint8_t>(kind_of(light));
    facts.position = point(light.Center);
    facts.points_at = point(light.Points_At);
    facts.colour = linear(light.colour);
    facts.parallel = light.Parallel;
    facts.shadowless = light.Light_Type == FILL_LIGHT_SOURCE;
    facts.jitter = light.Area_Light && light.Jitter;
    if (light.Area_Light) {
        facts.area_rows = static_cast<unsigned>(light.Area_Size1);
        facts.area_columns = static_cast<unsigned>(light.Area_Size2);
    }
    facts.in_group = light.lightGroupLight;
    return facts;
}

void add_scene_features(SceneFacts& facts, pov::ViewData& view) {
    const pov::SceneData& scene = *view.GetSceneData();
    const auto feature = [&facts](bool present, const char* name) {
        if (present) facts.features.insert(name);
    };
    feature(scene.radiositySettings.radiosityEnabled, "radiosity");
    feature(scene.photonSettings.photonsEnabled, "photons");
    feature(scene.fog != nullptr, "fog");
    feature(!scene.atmosphere.empty(), "media");
    feature(scene.skysphere != nullptr, "sky_sphere");
    feature(scene.rainbow != nullptr, "rainbow");
    feature(scene.useSubsurface, "subsurface");
    const pov::Colour& background = scene.backgroundColour;
    feature(background.red() != 0 || background.green() != 0 || background.blue() != 0,
            "background");
    feature(facts.camera.blur_samples > 0, "focal_blur");
    feature(facts.camera.perturbed, "camera_normal");
    for (const LightFacts& light : facts.lights) {
        feature(light.area_rows > 0, "area_light");
        feature(light.jitter, "jitter");
        feature(light.in_group, "light_group");
    }
}

}  // namespace

SceneFacts describe_scene(pov::ViewData& view, bool antialias, const LinearLight& linear) {
    const pov::SceneData& scene = *view.GetSceneData();
    SceneFacts facts;
    facts.width = view.GetWidth();
    facts.height = view.GetHeight();
    facts.working_gamma = linear.gamma();
    facts.antialias = antialias;
    facts.camera = describe(view.GetCamera());
    for (const pov::LightSource* light : scene.lightSources)
        facts.lights.push_back(describe(*light, linear));
    for (const pov::LightSource* light : scene.lightGroupLightSources)
        facts.lights.push_back(describe(*light, linear));
    facts.background = linear(pov::RGBColour(scene.backgroundColour));
    add_scene_features(facts, view);
    add_contents(facts, scene.objects);
    return facts;
}

}  // namespace povpreview::tracer
