// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>

namespace povpreview {

/// The patched POV-Ray: the environment variable POVPREVIEW_TRACER, or the set-up's link beside
/// this program. Throws Error(Exit::usage) if it is not there.
std::string tracer_program();

}  // namespace povpreview
