// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

// The order of POV-Ray's headers matters: frame.h first, povdebug.h last.
// clang-format off
#include "backend/frame.h"
// clang-format on

#include "backend/oracle/condition.h"
#include "backend/oracle/geometry_facts.h"
#include "backend/oracle/surface_index.h"

namespace povpreview::tracer {

/// A primitive in closed form: solids with an algebraic surface, and what of these surfaces shows.
///
///     closed cylinder    sides: boundary of the endless cylinder where z in [0, 1]
///     ----1  cap                of the half space z <= 1 where inside the cylinder
///     |  |   side               of the half space z >= 0 where inside the cylinder
///     ----0  base        inside: all three
struct ClosedForm {
    struct Side {
        std::uint32_t solid = 0;
        FaceNumber number;
        Condition where = Condition::everywhere();
    };
    std::vector<Side> sides;
    /// By POV-Ray's rules: a disc is a half space; a primitive that is inverted is the rest.
    Condition inside = Condition::nowhere();
};

/// What closed_form() says of what is no primitive of the kinds that have one.
constexpr char no_closed_form[] = "no closed form";

/// Adds the solids of an object, without what clips it, and fills `form`. Returns null, or why it
/// cannot.
const char* closed_form(const pov::ObjectBase& object, std::vector<ClosedSolid>& solids,
                        ClosedForm& form);

}  // namespace povpreview::tracer
