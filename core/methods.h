// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/previewer.h"

namespace povpreview {

/// The previewing methods by name, ours first.
std::vector<std::string> method_names();

/// Whether a method has a use for edges known without tracing. `name` is one of method_names().
bool method_wants_edges(std::string_view name);

/// A previewer for an image of width x height pixels (each at least 1). `name` is one of
/// method_names().
std::unique_ptr<Previewer> make_previewer(std::string_view name, int width, int height);

}  // namespace povpreview
