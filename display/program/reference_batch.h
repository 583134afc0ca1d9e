// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "core/error.h"
#include "display/program/options.h"

namespace povpreview {

/// Renders many references side by side; see ReferenceOptions. Goes on past scenes that fail, and
/// prints a line for every picture and what came of all of them. Returns Exit::scene if some scene
/// failed, Exit::interrupted on Ctrl-C, all renders then being ended. Throws Error(Exit::usage)
/// where going on would be of no use: a picture cannot be written, there is no POV-Ray.
Exit reference(const ReferenceOptions& options);

}  // namespace povpreview
