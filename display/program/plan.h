// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/error.h"
#include "core/stage.h"
#include "display/program/options.h"

namespace povpreview {

/// Prints what a preview of the scene would do and what it would leave out, and why, as the first
/// samples tell; with PlanOptions::run also what it took in the end. Throws Error.
Exit plan(const PlanOptions& options);

/// A line for each stage: its name, whether it runs, the share of the tracer's time that it is
/// expected to take, what it took (if `taken`), and why.
std::string plan_table(const std::vector<Stage>& stages, bool taken);

}  // namespace povpreview
