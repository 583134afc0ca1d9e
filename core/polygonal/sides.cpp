// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/polygonal/sides.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/MP_Float.h>
#include <CGAL/determinant.h>

namespace povpreview {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact = CGAL::MP_Float;

Kernel::Point_3 point(const glm::dvec3& p) { return {p.x, p.y, p.z}; }

/// Sign of det(b - a, c - a, direction), of exact differences.
int exact_side_from_afar(const glm::dvec3& d, const glm::dvec3& a, const glm::dvec3& b,
                         const glm::dvec3& c) {
    const auto difference = [](double p, double q) { return Exact(p) - Exact(q); };
    const Exact det = CGAL::determinant(
        difference(b.x, a.x), difference(b.y, a.y), difference(b.z, a.z), difference(c.x, a.x),
        difference(c.y, a.y), difference(c.z, a.z), Exact(d.x), Exact(d.y), Exact(d.z));
    return static_cast<int>(CGAL::sign(det));
}

}  // namespace

int exact_side(const glm::dvec4& viewpoint, const glm::dvec3& a, const glm::dvec3& b,
               const glm::dvec3& c) {
    const glm::dvec3 v(viewpoint);
    if (viewpoint.w == 0) return -exact_side_from_afar(v, a, b, c);
    return static_cast<int>(CGAL::orientation(point(v), point(a), point(b), point(c)));
}

}  // namespace povpreview
