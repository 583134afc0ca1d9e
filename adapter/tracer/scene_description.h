// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "backend/oracle/linear_light.h"
#include "backend/oracle/scene_facts.h"

namespace pov {
class ViewData;
}

namespace povpreview::tracer {

/// What a parsed scene consists of, for the previewer's plan.
SceneFacts describe_scene(pov::ViewData& view, bool antialias, const LinearLight& linear);

}  // namespace povpreview::tracer
