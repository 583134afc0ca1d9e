// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "tests/core/detail/item_scene.h"

namespace povpreview::test {

/// paint_items() to its end.
ItemBuffer painted(const DrawableScene& scene);

/// Within so many pixels of an edge rounding may decide.
constexpr double edge_slack = 1e-6;

/// Paints the scene and holds every pixel against rays: what is painted has to be what a ray shows
/// within `slack` pixels of the centre; what is unknown has to lie on a border, as near. `shown`:
/// pixels that must show something, lest the test shows nothing.
void expect_right(const ItemScene& made, std::size_t shown, double slack = edge_slack);

}  // namespace povpreview::test
