// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace povpreview {

/// Values on a rectangular lattice of pixels, row by row.
struct Lattice {
    std::vector<int> columns, rows;  ///< rising pixel coordinates
    std::vector<glm::vec3> values;   ///< columns.size() x rows.size()
};

/// Share of four neighbouring lattice points in the value of one place between them.
struct CubicWeights {
    std::array<std::size_t, 4> points;
    std::array<float, 4> weights;
};

/// Weights at `places` (rising, within the lattice) of the piecewise cubic through a lattice's
/// points with the tangents of Catmull and Rom (1974), written for uneven spacing: the slope at a
/// point is that of the chord between its neighbours; at an end, of the end piece. Exact for
/// straight lines; the weights sum to 1; at a lattice point they are exactly 0 and 1.
std::vector<CubicWeights> cubic_weights(std::span<const int> lattice, std::span<const int> places);

/// The lattice's values at all pixels of `columns` x `rows`, row by row.
std::vector<glm::vec3> interpolate(const Lattice& lattice, std::span<const int> columns,
                                   std::span<const int> rows);

}  // namespace povpreview
