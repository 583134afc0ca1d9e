// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "core/polygonal/polygon_scene.h"

namespace povpreview {

using Real = long double;
using Vec3 = glm::vec<3, Real>;

/// A half line; `direction` is of any length.
struct Ray {
    Vec3 origin, direction;
    /// Hits nearer than this (in lengths of `direction`) are not seen.
    Real start = 0;
};

/// One surface that a line of sight meets.
struct Hit {
    std::uint32_t face = 0;
    Vec3 point{0};
    Real distance = 0;           ///< from the eye along all mirrors, in units of the scene
    Real from_mirror = 0;        ///< the same, from the last mirror on
    std::uint32_t mirrors = 0;   ///< reflections between the eye and the point
    std::uint64_t path = 0;      ///< which mirrors these are: equal for the same ones
    std::uint32_t lit = 0;       ///< bit i: light i of the scene's list shines on it, unhindered
    std::uint32_t filtered = 0;  ///< bit i: it does so through a transparent face
};

/// What one position of the image shows, front to back: transparent faces and what is behind them,
/// mirrors and what is in them.
struct Sight {
    std::vector<Hit> hits;
    bool edge_on = false;  ///< a face among them is but a line
    bool tie = false;      ///< too close a decision: faces at one depth, a light along a face
};

/// Visibility by plain loops over all faces, in long double: the reference for edges found without
/// rays. Shares no code with them.
///
/// Conventions: a face hides no point on itself nor one that it touches, that is, within 1e-6 of
/// the length of the line of sight; transparent faces hide nothing; a light below the horizon of
/// a face, seen from where it is looked at, leaves it dark unless it is lit from behind; mirrors
/// reflect on both sides.
class BruteForce {
   public:
    BruteForce(const PolygonScene& scene, int mirror_depth);

    /// The line of sight through a position of the image, pixels.
    Ray ray_through(glm::dvec2 pixel) const;
    /// All that is seen at a position of the image.
    Sight look(glm::dvec2 pixel) const;
    /// Where a point appears; nothing if it is behind the eye.
    std::optional<glm::dvec2> project(const Vec3& point) const;
    /// No opaque face that the eye sees stands before the point, by clear margins.
    bool eye_sees(const Vec3& point) const;
    /// The points where the line of sight from `from` through `through` meets faces beyond it.
    std::vector<Vec3> beyond(const Vec3& from, const Vec3& through, bool parallel) const;
    /// The mirror image of a point in a face's plane.
    Vec3 mirrored(const Vec3& point, std::uint32_t face) const;

    /// Two hits lie in one plane, to rounding.
    bool coplanar(std::uint32_t face, std::uint32_t other) const;
    const PolygonScene& scene() const { return scene_; }

   private:
    struct Plane {
        Vec3 normal;  ///< of length 1
        Real offset;  ///< dot(normal, point) - offset = height of a point
        bool sound;   ///< a face with an area
        // A ball around the face, for telling soon what lines miss it.
        Vec3 centre;
        Real radius2;  ///< its radius, squared
    };
    std::optional<Real> meet(const Ray& ray, std::uint32_t face) const;
    Real height(const Vec3& point, std::uint32_t face) const;
    void follow(const Ray& ray, const Hit& from, Sight& sight) const;
    bool hardly_apart(const Ray& ray, Real at, std::uint32_t face, Real beyond,
                      std::uint32_t other) const;
    void light(Hit& hit, const Vec3& towards_eye, Sight& sight) const;
    Vec3 corner(std::uint32_t face, std::uint32_t i) const;

    const PolygonScene& scene_;
    int mirror_depth_;
    std::vector<Plane> planes_;
};

}  // namespace povpreview
