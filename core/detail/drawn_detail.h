// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/detail/detail_map.h"
#include "core/detail/item_buffer.h"

namespace povpreview {

/// What item buffers of a scene tell a previewer. It is made where they are painted, in a thread of
/// its own: to take it costs a previewer next to nothing, however large the picture is.
class DrawnDetail {
   public:
    /// Nothing is known.
    DrawnDetail(int width, int height) : map_(width, height) {}
    explicit DrawnDetail(const ItemBuffer& drawn) : DrawnDetail(drawn.width, drawn.height) {
        accept(drawn);
    }
    /// Takes what has become known since. Sizes must agree.
    void accept(const ItemBuffer& drawn);

    const DetailMap& map() const { return map_; }
    /// Of the map's items.
    const ItemNumbers& numbers() const { return numbers_; }
    /// By item.
    const std::vector<DetailMap::Extent>& extents() const { return extents_; }
    /// Pixels whose surface is known; in a mirror what it mirrors may not be.
    std::size_t surfaces() const { return surfaces_; }
    /// Pixels whose surface has such a look; `mixed` counts those of unknown surfaces as well.
    std::size_t pixels(Look::Kind kind) const { return pixels_[static_cast<std::size_t>(kind)]; }

   private:
    DetailMap map_;
    ItemNumbers numbers_;
    std::vector<DetailMap::Extent> extents_;
    std::size_t surfaces_ = 0;
    std::array<std::size_t, 5> pixels_{};  // by Look::Kind
};

}  // namespace povpreview
