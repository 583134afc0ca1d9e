// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/detail/pattern_look.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/vec4.hpp>

#include "core/colour.h"
#include "core/detail/wide_vectors.h"

namespace povpreview {
namespace {

/// POV-Ray's EPSILON: by so much it moves points before it looks which checker or brick they are
/// in. Surfaces in a border are thereby wholly on one side of it.
constexpr double nudge = 1e-10;

/// Coordinates beyond it, in checkers, bricks or hexagons, are not looked up: a sum of three still
/// is an integer of 32 bits.
constexpr double farthest = 5e8;

bool within_reach(const glm::dvec3& p) {
    return std::abs(p.x) <= farthest && std::abs(p.y) <= farthest && std::abs(p.z) <= farthest;
}

double fraction(double x) { return x - std::floor(x); }

std::size_t checker_at(const glm::dvec3& p) {
    const double sum = std::floor(p.x + nudge) + std::floor(p.y + nudge) + std::floor(p.z + nudge);
    return static_cast<std::size_t>(static_cast<std::int64_t>(sum) & 1);
}

/// 0 in mortar, 1 in a brick. A brick's mortar lies at its lower ends; every other course is moved
/// by half a brick, and across the wall the other way round:
///
///     y   |###|#######|####      along x               z: |#######|###|
///     ^   +-------------                                  -------------
///     |   |#######|#######|                               |###|#######|
///     +-> x
std::size_t brick_at(const glm::dvec3& p, const glm::dvec3& size, double mortar) {
    const glm::dvec3 in_bricks = (p + glm::dvec3(nudge + mortar)) / size,
                     joint = glm::dvec3(mortar) / size;
    if (fraction(in_bricks.y) <= joint.y) return 0;
    const bool upper = fraction(in_bricks.y * .5) > .5;
    const double along = in_bricks.x + (upper ? .5 : 0), across = in_bricks.z + (upper ? 0 : .5);
    return fraction(along) <= joint.x || fraction(across) <= joint.z ? 0 : 1;
}

/// Cells are half a side wide and half a hexagon high; six by six of them repeat. The colour's
/// number in each cell, or on either side of its diagonal:
///
///     z   row 5 | 0 |0/1| 1   1 |1\0| 0 |
///     ^       4 | 2 |2\1| 1   1 |1/2| 2 |
///     |       3 | 2 |2/0| 0   0 |0\2| 2 |
///     |       2 | 1 |1\0| 0   0 |0/1| 1 |
///     |       1 | 1 |1/2| 2   2 |2\1| 1 |
///     |       0 | 0 |0\2| 2   2 |2/0| 0 |
///     +-> x  column 0   1   2   3   4   5
///
/// The plane is mirrored at x = 0, as POV-Ray has it.
std::size_t hexagon_at(const glm::dvec3& p) {
    constexpr double width = .5, height = .866025404, rows = 6, columns = 6;
    const double z = p.z < 0 ? rows * height + p.z : p.z;
    double x_cells = std::abs(p.x) / width, z_cells = z / height;
    x_cells -= std::floor(x_cells / columns) * columns;
    z_cells -= std::floor(z_cells / rows) * rows;
    const std::size_t column = static_cast<std::size_t>(x_cells) % 6,
                      row = static_cast<std::size_t>(z_cells) % 6;
    switch (column) {
        case 0:
        case 5:
            return (row + 1) / 2 % 3;
        case 2:
        case 3:
            return (row / 2 + 2) % 3;
        default: {
            const double right = fraction(x_cells), up = fraction(z_cells);
            const double under = (column + row) % 2 == 1 ? 1 - right : right;
            const bool below = up < (under == 0 ? 1e-4 : under);
            return below ? (3 - row % 3) % 3 : 2 - row % 3;
        }
    }
}

/// Of the colour at a point of the world, in PatternLook::colours; nowhere where nothing is known.
constexpr std::size_t nowhere = 3;
std::size_t number_at(const PatternLook& look, const glm::dvec3& point) {
    const glm::dvec3 p = look.to_pattern * glm::dvec4(point, 1);
    if (!within_reach(p)) return nowhere;
    switch (look.kind) {
        case PatternLook::Kind::checker:
            return checker_at(p);
        case PatternLook::Kind::brick:
            if (!within_reach((p + glm::dvec3(nudge + look.mortar)) / look.brick_size) ||
                !within_reach(glm::dvec3(look.mortar) / look.brick_size))
                return nowhere;
            return brick_at(p, look.brick_size, look.mortar);
        case PatternLook::Kind::hexagon:
            return hexagon_at(p);
    }
    return nowhere;
}

}  // namespace

POVPREVIEW_WIDE_VECTORS
std::optional<glm::vec3> pattern_albedo(const PatternLook& look, const glm::dvec3& before,
                                        const glm::dvec3& behind) {
    std::size_t numbers[2];
    for (int i = 0; i < 2; ++i) numbers[i] = number_at(look, i == 0 ? before : behind);
    if (numbers[0] == nowhere || numbers[1] == nowhere) return std::nullopt;
    const glm::vec3& colour = look.colours[numbers[0]];
    if (!finite(colour)) return std::nullopt;
    if (numbers[1] != numbers[0] && look.colours[numbers[1]] != colour) return std::nullopt;
    return colour;
}

}  // namespace povpreview
