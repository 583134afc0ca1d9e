// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

// The order of POV-Ray's headers matters: frame.h first, povdebug.h last.
// clang-format off
#include "backend/frame.h"
// clang-format on

#include "backend/oracle/scene_facts.h"

namespace povpreview::tracer {

/// Counts the objects by kind (parts of compound objects too), the pigments of their textures by
/// pattern, and adds the features that objects and textures bring in: reflection, refraction,
/// transparency, media, subsurface, perturbed_normal, interior_texture, blend_map ...
void add_contents(SceneFacts& facts, const std::vector<pov::ObjectPtr>& objects);

}  // namespace povpreview::tracer
