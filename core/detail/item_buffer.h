// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "core/detail/drawable_scene.h"

namespace povpreview {

/// Larger pictures are previewed without item buffer and DetailMap, which would take gigabytes.
inline constexpr std::int64_t most_item_pixels = std::int64_t{1} << 25;

/// What is seen through the centre of every pixel, found without tracing: row by row from the top.
struct ItemBuffer {
    static constexpr std::uint32_t background = 0;        ///< nothing is hit; as Sample::surface
    static constexpr std::uint32_t unknown = 0xffffffff;  ///< only tracing can tell

    int width = 0, height = 0;            ///< pixels
    std::vector<std::uint32_t> surfaces;  ///< identity (Sample::surface), background or unknown
    /// Of the surface's look at the pixel; of mirrors of one colour (is_plain_mirror()) of what
    /// they show, `traced` where they are not flat. Unknown: mixed.
    std::vector<Look::Kind> kinds;
    /// Linear, where the kind is `image` or `pattern`; empty where it is so nowhere.
    std::vector<glm::vec3> albedos;

    /// Surfaces that are flat mirrors, ascending: their pixels are told apart by what they mirror.
    std::vector<std::uint32_t> mirrors{};
    /// Where the surface is one of them, the surface that is seen in it, background or unknown;
    /// empty where there are none.
    std::vector<std::uint32_t> mirrored{};
};

}  // namespace povpreview
