// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>

namespace povpreview::tracer {

/// Mixes a value into a hash (the finaliser of splitmix64, Steele, Lea and Flood 2014).
inline std::uint64_t mix(std::uint64_t hash, std::uint64_t value) {
    std::uint64_t z = hash * 0x9e3779b97f4a7c15u + value + 0x632be59bd9b4e019u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

/// To 32 bits; 0 only from 0.
inline std::uint32_t fold(std::uint64_t hash) {
    const auto folded = static_cast<std::uint32_t>(hash ^ (hash >> 32));
    return folded != 0 || hash == 0 ? folded : 1;
}

}  // namespace povpreview::tracer
