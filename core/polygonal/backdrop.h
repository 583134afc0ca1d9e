// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/polygonal/shadow_volumes.h"

namespace povpreview {

using Backdrop = ShadowVolumes::Backdrop;

/// Of the backdrop at a parameter of its part.
double nearness(const Backdrop& backdrop, double t);

/// Adds a backdrop to others that are in order along a segment and apart from each other, so that
/// of each part the nearest one stays: their upper envelope by nearness.
void put_in_front(Backdrop backdrop, std::vector<Backdrop>& nearest);

/// Whether backdrops, in order, leave no part of their segment open.
bool covered(std::span<const Backdrop> nearest);

/// Appends to `parts` those parts of a backdrop that are nearer than all of `nearest`, which are in
/// order and apart from each other.
void parts_in_front(Backdrop backdrop, std::span<const Backdrop> nearest,
                    std::vector<Backdrop>& parts);

}  // namespace povpreview
