// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>

#include "core/error.h"
#include "display/program/options.h"

namespace povpreview {

/// The first figure of Pighin, Lischinski and Salesin (1997) for any scene: the finished picture,
/// the preview from a plain triangulation of a regular grid of samples, that triangulation, the
/// preview from a triangulation constrained by the edges that are known without rays from as many
/// samples, that triangulation, and the edges alone. Writes a.png to f.png and a sheet of all,
/// figure.png. Throws Error.
Exit figures(const FiguresOptions& options);

/// A regular grid over an image.
struct RegularGrid {
    double cell = 0;          ///< side of a cell, a share of the larger image side
    std::size_t samples = 0;  ///< that it has
};

/// The grid (as MeshOptions::grid_cell lays it) whose number of samples comes closest to `samples`.
RegularGrid regular_grid(std::size_t samples, glm::ivec2 size);

}  // namespace povpreview
