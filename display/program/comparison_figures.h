// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "core/error.h"
#include "display/program/options.h"

namespace povpreview {

/// Figures 3 and 4 of Pighin, Lischinski and Salesin (1997) for any scene: three previewers over
/// time, each run to the end from a fresh tracer. Theirs were Radiance's rview, plain Delaunay
/// after Painter and Sloan, and their own; here blocks, delaunay and mesh.
///
/// Figure 3: a row for each of four points in time, from the first on which mesh shows something
/// recognisable to the one by which it can hardly be told from the finished picture; a.png, b.png
/// ... and figure.png, all of them.
///
/// Figure 4: the L1 errors over time, in figure.svg, and over rays, in rays.svg, which comes out
/// the same on every machine but for how soon edges and items are found; and curves.csv.
///
/// Throws Error.
Exit comparison_figures(const FiguresOptions& options);

}  // namespace povpreview
