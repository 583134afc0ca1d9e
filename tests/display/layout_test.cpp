// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/layout.h"

#include <gtest/gtest.h>

#include <cmath>

namespace povpreview::test {
namespace {

TEST(Layout, EqualSizesFitExactly) {
    EXPECT_EQ(fit(640, 480, {0, 0, 640, 480}), (Rectangle{0, 0, 640, 480}));
    EXPECT_EQ(fit(640, 480, {8, 3, 1280, 960}), (Rectangle{8, 3, 1280, 960}));
}

TEST(Layout, FittingKeepsShapeAndStaysInside) {
    for (int width : {1, 7, 160, 1920, 65535}) {
        for (int height : {1, 9, 120, 1080, 65535}) {
            for (const Rectangle room :
                 {Rectangle{5, 6, 640, 480}, {0, 0, 31, 700}, {2, 0, 1, 1}}) {
                const Rectangle inner = fit(width, height, room);
                EXPECT_GE(inner.x, room.x);
                EXPECT_GE(inner.y, room.y);
                EXPECT_LE(inner.x + inner.width, room.x + room.width);
                EXPECT_LE(inner.y + inner.height, room.y + room.height);
                EXPECT_TRUE(inner.width == room.width || inner.height == room.height);
                if (inner.width == 1 || inner.height == 1) continue;
                // half a pixel of rounding on one side
                EXPECT_NEAR(double(inner.width) * height, double(inner.height) * width,
                            .5 * std::max(width, height) + 1);
            }
        }
    }
}

TEST(Layout, ColumnsAreEqualAndApart) {
    const auto two = columns(1288, 500, 2);
    ASSERT_EQ(two.size(), 2u);
    EXPECT_EQ(two[0], (Rectangle{0, 0, 640, 500}));
    EXPECT_EQ(two[1], (Rectangle{640 + column_gap, 0, 640, 500}));
    for (const Rectangle& column : columns(3, 3, 2)) EXPECT_GE(column.width, 1);
}

TEST(Layout, CaptionsGiveWayInLowWindows) {
    const Places roomy = places({0, 0, 640, 512}, 640, 480, 32);
    EXPECT_EQ(roomy.picture, (Rectangle{0, 0, 640, 480}));
    EXPECT_EQ(roomy.caption, (Rectangle{0, 480, 640, 32}));
    const Places low = places({0, 0, 640, 60}, 640, 480, 32);
    EXPECT_EQ(low.caption.height, 0);
    EXPECT_EQ(low.picture.height, 60);
}

}  // namespace
}  // namespace povpreview::test
