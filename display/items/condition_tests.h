// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/detail/drawable_scene.h"

namespace povpreview::items {

/// One question of a condition, and how it goes on by the answer.
struct ConditionTest {
    static constexpr std::uint32_t holds = 0xffffffffu, fails = 0xfffffffeu;
    std::uint32_t solid;  ///< in DrawableScene::solids
    bool inverted;        ///< the condition is likelier to hold outside of the solid
    /// Number of the next test, or holds, or fails.
    std::uint32_t if_inside, if_outside;
};

/// A condition as a chain of tests that asks no more than it must: no stack is needed, and most
/// points are told by the first tests.
///
///     A and not B:   test A --inside--> test B --outside--> holds
///                        \--outside--> fails  \--inside--> fails
///
/// Nothing if it is no condition: operands missing or left over, or `solids` or more named.
/// REQUIRES: steps is not empty.
std::optional<std::vector<ConditionTest>> condition_tests(std::span<const ConditionStep> steps,
                                                          std::size_t solids);

}  // namespace povpreview::items
