// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "core/error.h"
#include "display/program/options.h"

namespace povpreview {

/// Previews one scene until it is complete, a limit is reached, the window is closed, or Ctrl-C.
/// Throws Error.
Exit preview(const PreviewOptions& options);

}  // namespace povpreview
