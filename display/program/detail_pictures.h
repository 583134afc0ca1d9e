// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "core/picture.h"

namespace povpreview {

/// The DetailMap of a preview, to be looked at; black where it knows nothing (paper, figure 2).
/// REQUIRES: preview.detail.

/// Albedo, without light.
Picture albedo_picture(const Picture& preview);
/// Surfaces of which only tracing could tell the texture, each in a colour of its own.
Picture traced_surfaces_picture(const Picture& preview);
/// Albedo, and the BF-squares upon it, which are with light.
Picture detail_map_picture(const Picture& preview);

}  // namespace povpreview
