// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "adapter/scene.h"
#include "core/detail/drawable_scene.h"
#include "core/polygonal/polygon_scene.h"

namespace povpreview {

/// What can be drawn of a scene as the tracer sends it, in world space.
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
        bool drawn = false;  ///< they are among `objects`
    };
    struct MaterialLook {
        std::uint32_t material = 0;
        Look look;
    };
    std::vector<glm::dvec3> points;
    std::vector<std::uint32_t> corners;  ///< indices into `points`
    std::vector<Ring> rings;
    std::vector<Polygon> polygons;
    std::vector<LeftOut> left_out;
    std::vector<glm::vec2> corner_uvs;  ///< beside `corners`; or none

    std::vector<Solid> solids;  ///< as these are in a DrawableScene
    std::vector<double> numbers;
    std::vector<ConditionStep> conditions;
    std::vector<CurvedPiece> pieces;
    std::vector<CurvedObject> objects;
    std::vector<Bounds> unknown, unknown_in_mirrors;
    std::vector<MaterialLook> looks;
    std::vector<ImageTexels> images;  ///< without texels, which come after all else

    /// Adds another part of the scene.
    void append(const Geometry& other);
};

/// The polygons cut into convex faces, with those lights that cast shadows on everything, and the
/// camera. Nothing where the camera bends straight lines (see straight_camera.h). Takes time in
/// proportion to the size of the scene; meant for a thread that may take it.
std::optional<PolygonScene> polygon_scene(const Geometry& geometry, const SceneDescription& scene);

/// All that can be drawn, with the camera; its images are without texels, for their user to fill
/// in. Nothing where polygon_scene() gives nothing. Takes as long.
std::optional<DrawableScene> drawable_scene(const Geometry& geometry,
                                            const SceneDescription& scene);

}  // namespace povpreview
