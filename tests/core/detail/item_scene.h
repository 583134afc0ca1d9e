// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <limits>
#include <vector>

#include "tests/core/detail/ray_caster.h"

namespace povpreview::test {

/// A scene put together by hand. Surfaces get numbers of their own; materials are `material`, which
/// may be changed between objects.
class ItemScene {
   public:
    ItemScene(const CameraPose& camera_pose, int width, int height);

    DrawableScene scene;
    CameraPose pose;
    std::uint32_t material = 0;

    // Solids alone, by number. A frame: the images of x, y, z and the origin.
    std::uint32_t solid(Solid::Kind kind, const glm::dmat4x3& frame,
                        const std::array<double, 10>& coefficients = {});
    /// One that has a list of numbers.
    std::uint32_t listed_solid(Solid::Kind kind, const glm::dmat4x3& frame,
                               const std::vector<double>& numbers);
    std::uint32_t sphere_solid(const glm::dvec3& centre, double radius);
    std::uint32_t half_space(const glm::dvec3& outward, const glm::dvec3& through);
    /// Endless, around the line through a and b.
    std::uint32_t cylinder_solid(const glm::dvec3& a, const glm::dvec3& b, double radius);

    /// A piece of the object at work.
    void piece(std::uint32_t of_solid, std::vector<ConditionStep> condition = {});
    /// Ends the object at work.
    void object(const Bounds& bounds);

    // Whole objects.
    void sphere(const glm::dvec3& centre, double radius);
    void ellipsoid(const glm::dmat4x3& frame);
    void cylinder(const glm::dvec3& a, const glm::dvec3& b, double radius);
    void cone(const glm::dvec3& a, double radius_a, const glm::dvec3& b, double radius_b);
    void torus(const glm::dvec3& centre, const glm::dvec3& axis, double major, double minor);
    void plane(const glm::dvec3& normal, const glm::dvec3& through);
    void face(const std::vector<glm::dvec3>& corners, const std::vector<glm::vec2>& uvs = {});
    void box(const glm::dvec3& low, const glm::dvec3& high);

    ItemBuffer expected() const { return RayCaster(scene, pose).cast_all(); }

   private:
    std::uint32_t surface_ = 0, first_piece_ = 0;
};

/// Unit vectors across `axis` and the axis itself, as columns, around `origin`.
glm::dmat4x3 frame_along(const glm::dvec3& axis, const glm::dvec3& origin, double across,
                         double along);
constexpr double unbounded = std::numeric_limits<double>::infinity();
inline const Bounds everywhere{glm::dvec3(-unbounded), glm::dvec3(unbounded)};

}  // namespace povpreview::test
