// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstring>

#include "backend/oracle/hash.h"
#include "backend/oracle/samples.h"

namespace povpreview::tracer {

/// Where a sample's random numbers begin, so that it depends on its position alone.
inline std::size_t seed_of(Position position) {
    std::uint64_t x, y;
    std::memcpy(&x, &position.x, sizeof x);
    std::memcpy(&y, &position.y, sizeof y);
    return static_cast<std::size_t>(mix(mix(0, x), y) >> 33);
}

}  // namespace povpreview::tracer
