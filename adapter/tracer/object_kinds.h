// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

// The order of POV-Ray's headers matters: frame.h first, povdebug.h last.
// clang-format off
#include "backend/frame.h"
// clang-format on

namespace povpreview::tracer {

/// What the scene language calls an object of this class: "sphere", "mesh", "difference" ...
const char* object_kind(const pov::ObjectBase& object);

}  // namespace povpreview::tracer
