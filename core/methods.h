// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/ladder.h"
#include "core/previewer.h"

namespace povpreview {

/// The previewing methods by name, ours first.
std::vector<std::string> method_names();

/// What a method has a use for of what may be known without tracing.
struct MethodNeeds {
    bool edges = false;  ///< Previewer::accept_edges
    bool items = false;  ///< Previewer::accept_items
};
/// `name` is one of method_names().
MethodNeeds method_needs(std::string_view name);

/// What a picture is of, for a previewer.
struct ImageFrame {
    int width = 0, height = 0;  ///< pixels, each at least 1
    /// A sample is the light along one ray; false under focal blur, where it is a mean of many, and
    /// the surface that one of them met says little.
    bool sharp = true;
    /// What rays cost may decide what is asked for. False: as if that were never known, so that
    /// equal scenes give equal runs whatever the machine does beside.
    bool by_cost = true;
    int threads = 2;  ///< of the tracer's, that work side by side
    Ladder ladder{};  ///< of accuracy; those who cannot climb ask for the target alone
};

/// `name` is one of method_names().
std::unique_ptr<Previewer> make_previewer(std::string_view name, const ImageFrame& frame);

}  // namespace povpreview
