// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace povpreview {

/// A part of a method's work: whether a scene gets it, why, and what it has taken so far.
struct Stage {
    std::string name;
    bool runs = false;
    std::string why{};
    /// Share of the tracer's time for a complete picture that it is expected to take, 0..1; nothing
    /// where that cannot be told.
    std::optional<double> expected{};
    std::size_t rays = 0;  ///< answered for it
    double tracer_s = 0;   ///< that they took, in seconds of one thread
    double own_s = 0;      ///< of our own threads that it took beside that
};

/// Those that others have something to add to.
inline constexpr const char *refinement_stage_name = "triangulation",
                            *lattice_stage_name = "lattice",
                            *edge_stage_name = "edges without rays";

}  // namespace povpreview
