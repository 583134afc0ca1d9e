// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "core/detail/drawable_scene.h"

namespace povpreview {

/// A part of a ray, in a solid's own frame: from + t along for t in [first, last].
struct RayStretch {
    glm::dvec3 from{}, along{};
    double first = 0, last = std::numeric_limits<double>::infinity();
    bool nearest_only = false;  ///< only the first of what is met matters

    glm::dvec3 at(double t) const { return from + t * along; }
};

/// A solid that one ray at a time meets, by way of what was worked out beforehand: those of the
/// kinds that have a list of numbers or no roots in closed form.
class IntricateSolid {
   public:
    virtual ~IntricateSolid() = default;

    /// Adds the depths t where the ray meets the solid's surface, in any order; depths beyond the
    /// stretch may be among them, and be missing.
    virtual void find_roots(const RayStretch& ray, std::vector<double>& roots) const = 0;
    /// The solid's f: inside is f <= 0. Within 1e-9 of 0 where rounding may decide.
    virtual double value(const glm::dvec3& p) const = 0;
    /// About what roots, or values, of ray_lanes rays take, in units of 20 nanoseconds.
    virtual std::size_t cost() const = 0;
};

bool is_intricate(Solid::Kind kind);
/// Whether the numbers of an intricate solid are as many as its kind needs, and such that it can be
/// met.
bool is_sound(const DrawableScene& scene, const Solid& solid);
/// REQUIRES: is_intricate(), is_sound(), and the scene is kept.
std::unique_ptr<IntricateSolid> prepared(const DrawableScene& scene, const Solid& solid);

// -- one for each family

std::unique_ptr<IntricateSolid> prepared_prism(std::span<const double> outline, bool conic);
std::unique_ptr<IntricateSolid> prepared_lathe(std::span<const double> outline, bool squared);
std::unique_ptr<IntricateSolid> prepared_blob(std::span<const double> numbers);
std::unique_ptr<IntricateSolid> prepared_superellipsoid(double around, double along);

}  // namespace povpreview
