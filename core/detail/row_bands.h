// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>

#include "core/detail/item_canvas.h"

namespace povpreview {

/// Calls work(band, top, bottom) for each band of so many rows, the last one fewer, of the rows
/// [top, bottom); side by side on as many threads as there are processors, so in any order. Of few
/// rows on the calling thread alone.
void for_each_band(int top, int bottom, int rows, const std::function<void(int, int, int)>& work);

/// Bands of this many rows of `rows` keep all processors busy to the end, though some are dearer
/// than others.
int rows_for_threads(int rows);

/// Calls draw(band) for bands of so many rows of a canvas's area, side by side.
void draw_bands(ItemCanvas& canvas, int rows, const std::function<void(ItemCanvas&)>& draw);

}  // namespace povpreview
