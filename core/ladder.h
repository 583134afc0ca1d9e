// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/oracle.h"

namespace povpreview {

/// How accurately samples of a scene can be traced, from the cheapest way to the truth. What the
/// rungs leave out, the scene's own features define; one without any that are dear has the target
/// alone.
struct Ladder {
    struct Step {
        std::string name;
        /// False where the tracer has something to prepare first, such as photons. Samples of the
        /// target wait for that; those of a rung below it need not, but are worse before it.
        bool ready = true;
    };
    /// Rung 0 first; the last one is target_rung (see oracle.h). Never empty.
    std::vector<Step> rungs{{"target"}};
};

/// The rung that a user means by a name or a number from 0. Throws Error(Exit::usage).
Rung rung_named(const Ladder& ladder, const std::string& text);

}  // namespace povpreview
