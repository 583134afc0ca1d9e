// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "backend/oracle/point.h"
#include "backend/oracle/samples.h"

namespace povpreview::tracer {

/// As wire::Camera; `kind` and the light's `kind` are the numbers of wire.fbs.
struct CameraFacts {
    std::uint8_t kind = 0;
    Point location, direction, right, up, sky, look_at;
    double angle = 0;
    double aperture = 0, focal_distance = 0;
    unsigned blur_samples = 0;
    bool perturbed = false;
};

struct LightFacts {
    std::uint8_t kind = 0;
    Point position, points_at;
    Rgb colour;
    bool parallel = false, shadowless = false, jitter = false;
    unsigned area_rows = 0, area_columns = 0;
    bool in_group = false;
};

/// As wire::Rung.
struct RungFacts {
    std::string name;
    bool ready = true;  ///< else a message will say so later
};

/// What the previewer is told about a scene; as wire::Scene.
struct SceneFacts {
    unsigned width = 0, height = 0;
    float working_gamma = 1;
    bool antialias = false;
    CameraFacts camera;
    std::vector<LightFacts> lights;
    std::set<std::string> features;
    std::map<std::string, unsigned> textures, objects;
    Rgb background;
    bool alpha = false;
    std::string output;
    std::vector<std::string> files;
    std::vector<RungFacts> rungs;  ///< cheapest first, the target last
    unsigned first_look = 0;       ///< full samples after which the target is prepared
};

}  // namespace povpreview::tracer
