// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "adapter/geometry.h"
#include "adapter/wire.h"

namespace povpreview {

/// What can be drawn of the scene, put together from the messages in which it comes: the geometry,
/// and after it the texels of its images. A tracer that has died leaves it where it was; the next
/// one sends all again, and what is complete by then is not taken twice.
class GeometryArrival {
   public:
    /// A tracer begins, that has not sent anything yet.
    void begin();

    /// Both throw WireFault at what comes too late, too early or is too much.
    void accept(const report::GeometryChunk& chunk);
    void accept(const report::Texels& part);

    bool geometry_complete() const { return geometry_complete_; }
    bool images_complete() const { return images_complete_; }
    /// Each once, when it is complete; nothing before that and afterwards.
    std::optional<Geometry> take_geometry() { return std::exchange(geometry_, std::nullopt); }
    std::optional<std::vector<ImageTexels>> take_images() {
        return std::exchange(images_, std::nullopt);
    }

   private:
    void expect_images(const std::vector<ImageTexels>& images);
    void check_images_complete();

    // Of this tracer.
    Geometry arriving_;
    bool ended_ = false;  ///< all of the geometry has come
    std::vector<ImageTexels> arriving_images_;
    std::size_t image_ = 0;  ///< of them the one that is coming

    // Of any.
    bool geometry_complete_ = false, images_complete_ = false;
    std::optional<Geometry> geometry_;                ///< not taken yet
    std::optional<std::vector<ImageTexels>> images_;  ///< not taken yet
};

}  // namespace povpreview
