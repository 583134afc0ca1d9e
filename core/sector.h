// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <vector>

#include "core/triangulation.h"

namespace povpreview {

/// The part of the fan of faces around a vertex between two constrained edges that follow each
/// other (or the border). Colours may jump across a constraint, so each sector has a value of its
/// own.
///
///            s2                    v has two sectors: from s1 over s2 to s3, and from s3 over s4
///          / | \                   to s1.
///     s3 ====v==== s1
///          \ | /
///            s4
struct Sector {
    std::size_t first;  ///< the spoke it begins at
    std::size_t faces;  ///< it ends at spoke (first + faces) modulo the number of spokes
    bool whole;         ///< one constraint or none ends at the vertex: all around it
};

/// The sectors of a fan, counter-clockwise; a fan without constraints is one sector.
void find_sectors(const std::vector<Triangulation::Spoke>& fan, std::vector<Sector>& sectors);

/// The wedge that a sector fills: from the ray centre-start counter-clockwise to centre-end.
struct Wedge {
    Wedge(glm::dvec2 from, glm::dvec2 first, glm::dvec2 last, bool all_around);

    glm::dvec2 centre, start, end;
    bool whole;
    int turn;  ///< orientation(centre, start, end)

    /// Exactly decided; a point on one of the rays is not inside.
    bool contains(glm::dvec2 p) const;
    /// Whether p lies exactly on the ray from the centre through `ray`.
    bool along(glm::dvec2 ray, glm::dvec2 p) const;
    /// How far a point inside is from the nearer of the two rays, in pixels; 0 where the wedge is
    /// whole and has none to keep clear of.
    double clearance(glm::dvec2 p) const;
    /// Unit vector from the centre through the middle of the wedge.
    glm::dvec2 bisector() const;
    /// The angle of the wedge in radians, 0 to 2 pi.
    double angle() const;
};

/// How far a one-sided sample keeps from the constraints beside it, in pixels. A traced outline is
/// known to .1 pixels at its vertices and to .35 in between; the sample must clear that.
inline constexpr double side_clearance = .4;
/// How far a one-sided sample may lie from its vertex, in pixels: farther on it would show what
/// happens elsewhere. Only in sectors thinner than 31 degrees is the clearance cut down by it.
inline constexpr double side_offset_limit = 1.5;

}  // namespace povpreview
