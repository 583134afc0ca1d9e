// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/program/recorded_previewer.h"

#include <gtest/gtest.h>

#include <chrono>

#include "core/mesh_previewer.h"
#include "core/session.h"
#include "tests/core/function_oracle.h"

namespace povpreview::test {
namespace {

constexpr int width = 160, height = 120;

FunctionImage disc() {
    FunctionImage image = images::disc({70, 60}, 40);
    image.full_ns = 1000;  // cheap enough for a lattice
    return image;
}

/// The disc is known in every second row.
ItemBuffer some_rows() {
    ItemBuffer items{width, height, {}, {}, {}};
    const FunctionImage image = disc();
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            items.surfaces.push_back(y % 2 ? ItemBuffer::unknown : image.surface({x + .5, y + .5}));
            items.kinds.push_back(y % 2 ? Look::Kind::mixed : Look::Kind::plain);
        }
    return items;
}

TEST(Recording, LetsAFreshPreviewerMakeTheSamePictures) {
    const DrawnDetail items(some_rows());
    for (const bool lattice : {true, false}) {
        const MeshOptions options{.lattice = lattice};
        Recording recording;
        RecordedPreviewer recorded(std::make_unique<MeshPreviewer>(width, height, options),
                                   recording);
        FunctionOracle oracle(disc(), 3);
        Session session(recorded, oracle);
        std::vector<Picture> pictures;
        for (const std::size_t samples : {1u, 40u, 300u, 301u, 2000u}) {
            session.limit_full(samples);
            while (session.advance(std::chrono::milliseconds(1))) {
            }
            if (samples == 300) recorded.accept_items(items);
            recording.mark();
            pictures.push_back(recorded.picture(Overlay::none));
        }
        MeshPreviewer again(width, height, options);
        std::size_t marks = 0;
        recording.replay(again, [&](std::size_t i) {
            ASSERT_EQ(i, marks++);
            const Picture picture = again.picture(Overlay::none);
            EXPECT_EQ(picture.known, pictures[i].known);
            EXPECT_EQ(picture.pixels, pictures[i].pixels);
            ASSERT_EQ(picture.corners.size(), pictures[i].corners.size());
            for (std::size_t c = 0; c < picture.corners.size(); ++c)
                EXPECT_EQ(picture.corners[c].colour, pictures[i].corners[c].colour);
            EXPECT_EQ(picture.detail != nullptr, i >= 2);
        });
        EXPECT_EQ(marks, pictures.size());
        EXPECT_GT(recording.memory(), 2000 * sizeof(Sample));
    }
}

}  // namespace
}  // namespace povpreview::test
