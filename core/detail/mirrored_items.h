// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "core/detail/item_buffer.h"
#include "core/detail/item_canvas.h"
#include "core/detail/painting_pace.h"
#include "core/detail/pixel_rays.h"

namespace povpreview {

/// Surfaces that reflect less are left to samples. The tracer's plain_mirror() has the same bound.
constexpr float least_mirror = .2f;

/// Whether samples of such a surface tell of what is seen in it (see Sample).
inline bool is_plain_mirror(const Look& look) {
    return look.kind == Look::Kind::plain && look.mirror >= least_mirror;
}

/// What mirrors of one colour show that lie in one plane: pixel by pixel, as a canvas does, by rays
/// that come from behind them.
struct MirrorView {
    struct Seen {
        std::uint32_t pixel;
        ItemCanvas::Source source;
        double nearness;
    };
    PixelRays rays;
    std::vector<Seen> seen{};
};

/// Finds what flat mirrors show: `mirrors` and `mirrored` of a buffer whose other parts were read
/// from the canvas. For each mirror the scene is drawn again, as seen from behind it.
///
///          eye      | mirror    p          The eye sees p where the line from its mirror image
///             \     |         .'           crosses the mirror; what lies before the mirror on that
///              \    |       .'             line is not there.
///               q   |     .'
///                \  |   .'
///                 \ | .'
///      eye's image  .'
///                .'
///
/// Allocates nothing where nothing is a mirror. Ends early, with a result of no use, when it is
/// stopped.
std::vector<MirrorView> paint_mirrored(const DrawableScene& scene, const PixelRays& rays,
                                       const ItemCanvas& canvas, const PaintingPace& pace,
                                       ItemBuffer& items);

/// Gives pixels of mirrors of one colour the look of what is seen in them, as samples tell of that
/// there (see Sample). `items` has its `mirrors` and `mirrored` and other than that was just read.
void read_mirrored_looks(const DrawableScene& scene, const std::vector<MirrorView>& views,
                         ItemBuffer& items);

}  // namespace povpreview
