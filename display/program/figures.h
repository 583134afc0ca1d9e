// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>

#include "core/error.h"
#include "display/program/options.h"

namespace povpreview {

/// The figures of Pighin, Lischinski and Salesin (1997) for any scene. Writes a.png,
/// b.png ... and a sheet of all, figure.png. Throws Error.
///
/// Figure 1: a the finished picture, b the preview from a plain triangulation of a regular grid of
/// samples, c that triangulation, d the preview from a triangulation constrained by the edges that
/// are known without rays from as many samples, e that triangulation, f the edges alone.
///
/// Figure 2: a the finished picture, b the triangulation of the first samples with the edges, c the
/// textures known without tracing, d the surfaces of which only tracing can tell the texture, e all
/// textures known in the end, f the first preview, g the DetailMap in the end, with its BF-squares,
/// h the preview in the end.
///
/// Figures 3 and 4: see comparison_figures.h.
Exit figures(const FiguresOptions& options);

/// A regular grid over an image.
struct RegularGrid {
    double cell = 0;          ///< side of a cell, a share of the larger image side
    std::size_t samples = 0;  ///< that it has
};

/// The grid (as MeshOptions::grid_cell lays it) whose number of samples comes closest to `samples`.
RegularGrid regular_grid(std::size_t samples, glm::ivec2 size);

}  // namespace povpreview
