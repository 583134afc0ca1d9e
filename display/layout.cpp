// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/layout.h"

#include <algorithm>

namespace povpreview {

Rectangle fit(int width, int height, const Rectangle& room) {
    // Cross-multiplied in 64 bits: exact, where a quotient could be a pixel off.
    const long long w = width, h = height;
    Rectangle inner;
    if (w * room.height > h * room.width) {
        inner.width = room.width;
        inner.height = static_cast<int>((h * room.width + w / 2) / w);
    } else {
        inner.height = room.height;
        inner.width = static_cast<int>((w * room.height + h / 2) / h);
    }
    inner.width = std::max(inner.width, 1);
    inner.height = std::max(inner.height, 1);
    inner.x = room.x + (room.width - inner.width) / 2;
    inner.y = room.y + (room.height - inner.height) / 2;
    return inner;
}

std::vector<Rectangle> columns(int width, int height, int count) {
    std::vector<Rectangle> all;
    const int each = std::max((width - column_gap * (count - 1)) / count, 1);
    for (int i = 0; i < count; ++i) all.push_back({i * (each + column_gap), 0, each, height});
    return all;
}

Places places(const Rectangle& column, int picture_width, int picture_height, int caption_height) {
    if (column.height < 3 * caption_height) caption_height = 0;
    Rectangle room = column;
    room.height -= caption_height;
    return {fit(picture_width, picture_height, room),
            {column.x, column.y + room.height, column.width, caption_height}};
}

}  // namespace povpreview
