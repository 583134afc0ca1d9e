// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/detail/drawn_detail.h"

#include <algorithm>

namespace povpreview {

void DrawnDetail::accept(const ItemBuffer& drawn) {
    numbers_.set_mirrors(drawn.mirrors);
    map_.accept(drawn, numbers_);
    extents_ = map_.extents(numbers_);
    surfaces_ = drawn.surfaces.size() -
                static_cast<std::size_t>(
                    std::count(drawn.surfaces.begin(), drawn.surfaces.end(), ItemBuffer::unknown));
    for (std::size_t kind = 0; kind < pixels_.size(); ++kind)
        pixels_[kind] = static_cast<std::size_t>(
            std::count(drawn.kinds.begin(), drawn.kinds.end(), static_cast<Look::Kind>(kind)));
}

}  // namespace povpreview
