// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <glm/vec3.hpp>

#include "core/colour.h"

namespace povpreview {

/// decode_srgb by a table between 0 and 2, off by less than 1e-6, and 0 below: there are a million
/// channels in each picture, where a power function would take longer than all the rest.
inline glm::vec3 decode_quickly(const glm::vec3& encoded) {
    constexpr std::size_t steps = 4096, most = 2 * steps;
    static const auto table = [] {
        std::array<float, most + 2> t{};
        for (std::size_t i = 0; i < t.size(); ++i) t[i] = decode_srgb(float(i) / steps);
        return t;
    }();
    const float* const decoded = table.data();
    glm::vec3 result;
    for (int k = 0; k < 3; ++k) {
        // Interpolation may undershoot; there is no negative light.
        const float at = std::max(encoded[k] * steps, 0.f);
        if (at <= most) [[likely]] {
            const auto i = static_cast<std::size_t>(at);
            result[k] = decoded[i] + (at - float(i)) * (decoded[i + 1] - decoded[i]);
        } else {
            result[k] = decode_srgb(encoded[k]);
        }
    }
    return result;
}

}  // namespace povpreview
