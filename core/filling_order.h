// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace povpreview {

class BfSquares;
class Mesh;

/// All squares, by how much a pixel traced there may be expected to mend of the picture that `mesh`
/// shows: the most rewarding last, so that it is taken from the end.
std::vector<std::size_t> filling_order(const Mesh& mesh, const BfSquares& squares);

}  // namespace povpreview
