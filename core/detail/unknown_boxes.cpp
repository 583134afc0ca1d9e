// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/detail/unknown_boxes.h"

#include <algorithm>
#include <limits>

#include "core/detail/solid_rays.h"

namespace povpreview {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The depths at which rays enter and leave a box, `first` not less than 0; first > last where they
/// miss it.
struct Passage {
    RayLanes first, last;
};

/// A ray along a side of the box, for which nothing can be divided, is taken for one that
/// approaches the side beyond all that is seen.
POVPREVIEW_WIDE_VECTORS
void find_passage(const RowRays& __restrict rays, const Bounds& __restrict box,
                  const RayLanes& __restrict x, Passage& __restrict passage) {
    constexpr double farthest = 1e200, smallest = std::numeric_limits<double>::min();
    passage.first.fill(0), passage.last.fill(farthest);
    for (int k = 0; k < 3; ++k)
        for (int i = 0; i < ray_lanes; ++i) {
            const double from = rays.from[k] + x[i] * rays.from_step[k];
            double along = rays.along[k] + x[i] * rays.along_step[k];
            along = along == 0 ? smallest : along;
            const double a = (box.low[k] - from) / along, b = (box.high[k] - from) / along;
            passage.first[i] = std::max(passage.first[i], std::min(a, b));
            passage.last[i] = std::min(passage.last[i], std::max(a, b));
        }
}

}  // namespace

void hide_behind(const Bounds& box, const PixelRays& rays, ItemCanvas& canvas,
                 const PaintingPace& pace) {
    const PixelBox pixels =
        common_box(pixel_box(rays, box, canvas.width(), canvas.height()), canvas.area());
    RayLanes x;
    Passage passage;
    for (int y = pixels.top; y < pixels.bottom && !pace.stopped(); ++y) {
        const RowRays row = row_rays(rays, glm::dmat4x3(1), y + .5);
        for (int left = pixels.left; left < pixels.right; left += ray_lanes) {
            for (int i = 0; i < ray_lanes; ++i) x[i] = left + i + .5;
            find_passage(row, box, x, passage);
            for (int i = 0; i < std::min(ray_lanes, pixels.right - left); ++i) {
                const double first = passage.first[i], last = passage.last[i];
                if (!(first <= last)) continue;
                const std::size_t pixel = canvas.index(left + i, y);
                if (canvas.too_near(pixel, rays.nearness(last))) continue;
                canvas.hide(pixel, first > 0 ? rays.nearness(first) : infinity);
            }
        }
        pace.row_done();
    }
}

}  // namespace povpreview
