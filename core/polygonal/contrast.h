// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

#include "core/polygonal/interval_set.h"
#include "core/polygonal/shadow_volumes.h"

namespace povpreview {

/// Whether there is anything to see at an edge: faces that meet without sharing their edge, or that
/// several objects have in common, give edges inside of one even surface or of one shadow.
///
///      +-------+-------+      One flat surface in three parts: the middle corner lies on an edge
///      |       |       |      of the lower part (a T-junction), so that the three have no edge in
///      +-------+-------+      common.
///      |               |
///      +---------------+
class Contrast {
   public:
    explicit Contrast(const FlatFaces& faces) : faces_(faces) {}

    /// Whether a viewpoint sees surfaces that differ on both sides of an edge of some faces, at a
    /// point of it.
    bool of_surfaces(const ShadowVolumes& volumes, std::span<const std::uint32_t> faces,
                     const glm::dvec3& p, const glm::dvec3& along) const;
    /// Whether a face is lit on one side only of a shadow's border at a point of it.
    bool of_light(const ShadowVolumes& light, std::uint32_t face, const glm::dvec3& p,
                  const glm::dvec3& along) const;

   private:
    bool continue_each_other(std::uint32_t a, std::uint32_t b, const glm::dvec3& at_b,
                             double gap) const;
    enum class Light : std::uint8_t { none, filtered, full };
    Light falling(const ShadowVolumes& light, const glm::dvec3& p) const;

    const FlatFaces& faces_;
};

/// How closely to look whether there is contrast along an edge.
enum class Doubt : std::uint8_t {
    none,  ///< there is
    some,  ///< all along, if there is in the middle
    much   ///< here and there
};

/// Calls keep(interval) for the parts of an interval where holds(t) is true, as far as a few looks
/// along it tell.
template <class Holds, class Keep>
void keep_where(const Interval& whole, Doubt doubt, const Holds& holds, const Keep& keep) {
    constexpr int looks = 4, halvings = 12;
    if (doubt == Doubt::none || (doubt == Doubt::some && holds((whole.from + whole.to) / 2)))
        return keep(whole);
    const auto at = [&](double i) { return whole.from + (whole.to - whole.from) * i / looks; };
    bool on = holds(at(.5));
    double from = whole.from;
    for (int i = 1; i < looks; ++i) {
        if (holds(at(i + .5)) == on) continue;
        double low = at(i - .5), high = at(i + .5);
        for (int k = 0; k < halvings; ++k) {
            const double middle = (low + high) / 2;
            (holds(middle) == on ? low : high) = middle;
        }
        if (on) keep({from, high});
        on = !on;
        from = high;
    }
    if (on) keep({from, whole.to});
}

}  // namespace povpreview
