// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "adapter/scene.h"
#include "core/polygonal/polygon_scene.h"

namespace povpreview {

/// The polygonal part of a scene as the tracer sends it, in world space.
struct Geometry {
    struct Ring {
        std::uint32_t first = 0, count = 0;  ///< its corners in `corners`
    };
    /// Its inside is what an odd number of its rings surround.
    struct Polygon {
        std::uint32_t first_ring = 0, rings = 0;
        bool convex = false;  ///< known to be one convex ring
        Face face;            ///< but for its corners
    };
    /// Objects that have no polygons here, and why.
    struct LeftOut {
        std::string kind, reason;
        std::uint32_t count = 0;
    };
    std::vector<glm::dvec3> points;
    std::vector<std::uint32_t> corners;  ///< indices into `points`
    std::vector<Ring> rings;
    std::vector<Polygon> polygons;
    std::vector<LeftOut> left_out;

    /// Adds the polygons of another part of the scene.
    void append(const Geometry& other);
};

/// The polygons cut into convex faces, with those lights that cast shadows on everything, and the
/// camera. Nothing where the camera bends straight lines (see straight_camera.h). Takes time in
/// proportion to the size of the scene; meant for a thread that may take it.
std::optional<PolygonScene> polygon_scene(const Geometry& geometry, const SceneDescription& scene);

}  // namespace povpreview
