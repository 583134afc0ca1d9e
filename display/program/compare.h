// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "core/error.h"
#include "display/program/options.h"

namespace povpreview {

/// Runs each method on each scene from a fresh tracer, against complete renders by the stock
/// povray, and writes report.html, curves.csv, summary.json, pictures, and a table of times to
/// error levels. A scene that cannot be compared is left out, and makes the exit code that of its
/// fault. Throws Error.
Exit compare(const CompareOptions& options);

}  // namespace povpreview
