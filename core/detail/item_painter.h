// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "core/detail/item_buffer.h"
#include "core/detail/item_canvas.h"
#include "core/detail/mirrored_items.h"
#include "core/detail/pixel_rays.h"

namespace povpreview {

/// What each pixel's centre shows of a scene, found without tracing: polygons are rasterised and
/// curved objects met by the pixels' rays, which takes most of the time; then images are looked up
/// where they are seen, and flat mirrors painted with what they show. Where two surfaces coincide,
/// and where the data makes no sense, the surface is unknown.
///
/// Everything is computed in double precision, side by side in bands of rows, since fragment
/// shaders proved to be slower where there is no GPU, and no faster than needed where there is one.
/// Equal scenes give equal buffers on any number of processors.
class ItemPainting {
   public:
    /// Paints the surfaces. All ends early, with a result of no use, when it is stopped by the
    /// pace, which must outlive it.
    ItemPainting(const DrawableScene& scene, const PaintingPace& pace);

    /// What was painted, of the same scene; that may have got its images since.
    ItemBuffer read(const DrawableScene& scene) const;
    /// Adds what mirrors show, if there are any: the surfaces, and their looks.
    void paint_mirrors(const DrawableScene& scene, ItemBuffer& items);
    /// The looks alone, into what was read of the same scene, that may have got its images since.
    /// REQUIRES: it has the mirrors that were painted.
    void read_mirrored_looks(const DrawableScene& scene, ItemBuffer& items) const;

   private:
    const PaintingPace& pace_;
    PixelRays rays_;
    ItemCanvas canvas_;
    std::vector<MirrorView> mirror_views_;
};

/// All of that.
ItemBuffer paint_items(const DrawableScene& scene, const PaintingPace& pace = {});

}  // namespace povpreview
