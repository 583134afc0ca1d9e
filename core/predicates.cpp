// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/predicates.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace povpreview {

namespace {
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
Kernel::Point_2 point(glm::dvec2 p) { return {p.x, p.y}; }
}  // namespace

int orientation(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
    return CGAL::orientation(point(a), point(b), point(c));
}

int in_circle(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c, glm::dvec2 d) {
    return CGAL::side_of_oriented_circle(point(a), point(b), point(c), point(d));
}

}  // namespace povpreview
