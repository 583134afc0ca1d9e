// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include "core/detail/drawable_scene.h"
#include "display/items/draw_lists.h"

namespace povpreview::items {

/// Neighbouring pieces of an object that make a sphere, cylinder or cone cut off by up to two
/// planes, closed or open: the commonest shape of all, which has a shader of its own.
///
///        .-~-.   cap: boundary of the half space, inside the cylinder
///       |`-~-'|
///       |     |  side: boundary of the cylinder, inside the half spaces
///        `---'
struct CappedSolid {
    static constexpr std::uint32_t none = 0xffffffffu;

    std::uint32_t side = none;  ///< in DrawableScene::solids
    std::uint32_t side_piece = none;
    std::array<std::uint32_t, 2> planes{none, none}, cap_pieces{none, none};
    /// Whether a cap is only where the other plane's half space is too.
    std::array<bool, 2> cut_by_other{};
    std::uint32_t pieces = 0;  ///< how many these are

    /// Of the pieces from `first` on, before `end`; nothing if they make no such thing.
    static std::optional<CappedSolid> at(const DrawableScene& scene, std::uint32_t first,
                                         std::uint32_t end);
    /// Corners of a box, not along the axes, around all of it; nothing if the planes do not bound
    /// it squarely.
    std::optional<std::array<glm::dvec3, 8>> box(const DrawableScene& scene) const;
    /// False where it cannot be drawn by its own shader. `bounds` hold the object.
    bool list(const DrawableScene& scene, const Bounds& bounds, const PixelRays& rays,
              DrawLists& lists) const;
};

}  // namespace povpreview::items
