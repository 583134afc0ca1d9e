// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "core/polygonal/polygon_scene.h"

namespace povpreview {

/// Puts polygonal scenes together for tests and benchmarks. y is up.
class SceneBuilder {
   public:
    /// Whether faces of one solid use the same points, or each its own copies: both come.
    explicit SceneBuilder(bool share_points = true) : share_points_(share_points) {}

    /// What the next faces are like; `surface` is set by the calls below.
    Face style;

    /// A polygon, a surface of its own.
    void polygon(const std::vector<glm::dvec3>& corners);
    /// A box, each of whose sides is a surface of its own, as POV-Ray's boxes have it.
    void box(glm::dvec3 centre, glm::dvec3 half, const glm::dmat3& turn = glm::dmat3(1));
    /// A ball of slices x stacks quadrilaterals (triangles at the poles), one surface.
    void ball(glm::dvec3 centre, double radius, int slices, int stacks, bool smooth,
              bool triangles);
    /// A height field over [-half, half]^2 of cells x cells x 2 triangles, one surface.
    void terrain(double half, int cells, double height, bool smooth);
    /// A horizontal square around the origin.
    void floor(double y, double half);

    void light(glm::dvec3 position, float brightness = 1);
    void parallel_light(glm::dvec3 towards, float brightness = 1);

    /// A perspective camera; `angle` is the horizontal field of view, radians.
    void look(glm::dvec3 eye, glm::dvec3 target, double angle, int width, int height);
    /// An orthographic camera whose image is `extent` wide.
    void look_parallel(glm::dvec3 location, glm::dvec3 target, double extent, int width,
                       int height);

    /// The scene so far.
    PolygonScene scene;

   private:
    std::uint32_t point(glm::dvec3 at);
    void face(const std::vector<std::uint32_t>& corners, std::uint32_t surface);
    void mesh(const std::vector<glm::dvec3>& points,
              const std::vector<std::vector<std::uint32_t>>& faces, bool one_surface);

    bool share_points_;
    std::uint32_t next_surface_ = 1, next_smooth_ = 1;
};

/// A turn about an axis of any length.
glm::dmat3 turn_about(glm::dvec3 axis, double angle);

}  // namespace povpreview
