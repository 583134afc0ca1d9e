// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "display/image.h"
#include "tests/bench/edge_positions/agreement.h"

namespace povpreview {

/// The fine picture in pale grey with all constraints in blue on it, jumps without a constraint in
/// red and constraints beside their jump in orange; linear light.
Image picture_of_misses(const Image& fine, int scale, const std::vector<EdgeChain>& chains,
                        const JumpsFound& jumps, const ConstraintsPlaced& placed);

}  // namespace povpreview
