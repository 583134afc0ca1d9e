// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "core/error.h"
#include "display/program/options.h"

namespace povpreview {

/// Runs each method from a fresh tracer against a complete render by the stock povray, and writes
/// curves.csv, pictures and a table of times to error levels. Throws Error.
Exit compare(const CompareOptions& options);

}  // namespace povpreview
