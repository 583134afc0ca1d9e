// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>

// The order of POV-Ray's headers matters: frame.h first, povdebug.h last.
// clang-format off
#include "backend/frame.h"
// clang-format on

#include "backend/oracle/geometry_facts.h"
#include "backend/oracle/linear_light.h"

namespace povpreview::tracer {

/// From where a pattern is evaluated to where its image or its checkers lie; nothing if that is
/// more than an affine map: turbulence, black holes, repeats.
std::optional<LocalFrame> map_of(const pov::TPATTERN& pattern);

/// A pattern that can be drawn, and where it lies.
struct DrawablePattern {
    PatternFacts pattern;
    LocalFrame to_pattern;
};
/// The checkers, bricks or hexagons of a texture of one layer: as a pigment of opaque colours, or
/// as a block texture of textures that have one opaque colour each. That nothing but the pigment
/// varies, the caller knows; nothing if it is any other texture.
std::optional<DrawablePattern> pattern_of(const pov::TEXTURE& top, const LinearLight& linear);

}  // namespace povpreview::tracer
