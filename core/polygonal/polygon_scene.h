// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/mat4x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

/// The polygonal part of a scene, in world space: what discontinuity edges are computed from
/// without tracing a ray. Anything may be wrong with it (degenerate, doubled, crossing, NaN): it
/// comes from people's scenes.
namespace povpreview {

/// A flat convex polygon. Both of its sides are visible.
struct Face {
    std::uint32_t first = 0, count = 0;  ///< its corners in PolygonScene::corners, in order around
    std::uint32_t surface = 0;           ///< identity, as samples carry it (Sample::surface)
    std::uint32_t material = 0;          ///< equal where texture and interior are the very same
    /// Faces of equal number, but 0, are shaded smoothly across the edges that they share: those
    /// are edges of the picture only where they are silhouettes.
    std::uint32_t smooth = 0;
    bool transparent = false;      ///< does not hide what is behind it
    bool casts_shadow = true;      ///< false: POV-Ray's no_shadow
    bool visible = true;           ///< false: no_image; not seen by the eye itself
    bool reflected = true;         ///< false: no_reflection; not seen in mirrors
    bool lit_from_behind = false;  ///< double_illuminate
    float mirror = 0;              ///< share of light that it reflects as a flat mirror, 0..1
};

struct PointLight {
    glm::dvec4 position{0, 0, 0, 1};  ///< homogeneous; (direction towards it, 0) if parallel
    float brightness = 1;             ///< for the order of importance; mean of its linear colour
    std::uint32_t number = 0;         ///< among all lights of the scene
};

/// A camera under which straight lines stay straight.
struct StraightCamera {
    /// The eye, homogeneous; orthographic: (direction against the view, 0).
    glm::dvec4 eye{0, 0, 0, 1};
    /// World (x, y, z, 1) to (w px, w py, w), px and py in pixels; the eye sees points of positive
    /// depth only.
    glm::dmat4x3 to_pixels{1};
    /// depth = dot(depth, (x, y, z, 1)): distance along the view, in units of the scene.
    glm::dvec4 depth{0, 0, 1, 0};
};

struct PolygonScene {
    std::vector<glm::dvec3> points;
    std::vector<std::uint32_t> corners;  ///< indices into `points`
    std::vector<Face> faces;
    std::vector<PointLight> lights;
    StraightCamera camera;
    int width = 0, height = 0;  ///< pixels

    std::size_t corner_count(const Face& face) const { return face.count; }
    const glm::dvec3& corner(const Face& face, std::size_t i) const {
        return points[corners[face.first + i]];
    }
};

}  // namespace povpreview
