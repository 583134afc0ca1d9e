// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

namespace povpreview {

/// Pixels from (x, y), the upper left corner.
struct Rectangle {
    int x = 0, y = 0, width = 0, height = 0;
    bool operator==(const Rectangle&) const = default;
};

/// The largest rectangle of the shape `width` : `height` in the middle of `room`, at least a pixel
/// a side.
Rectangle fit(int width, int height, const Rectangle& room);

/// Between columns, pixels.
inline constexpr int column_gap = 8;

/// Cuts a window into `count` equal columns with that gap between.
std::vector<Rectangle> columns(int width, int height, int count);

struct Places {
    Rectangle picture, caption;
};

/// Where a column holds a picture and, at its foot, a caption `caption_height` high, which gives
/// way where the column is too low for both.
Places places(const Rectangle& column, int picture_width, int picture_height, int caption_height);

}  // namespace povpreview
