// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "core/polygonal/polygon_scene.h"
#include "tests/fuzz/input.h"

namespace povpreview::fuzz {

/// A polygonal scene of whatever numbers the input holds, with valid indices: those the wire
/// guarantees. The camera makes sense in most cases.
PolygonScene polygon_scene(Input& input);

}  // namespace povpreview::fuzz
