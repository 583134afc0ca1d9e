// SPDX-License-Identifier: AGPL-3.0-or-later
#include "backend/oracle/known_pixels.h"

#include <gtest/gtest.h>

#include <limits>

namespace povpreview::tracer {
namespace {

FinishPart part(std::uint32_t first, std::size_t count) {
    FinishPart result{first, {}, false};
    for (std::size_t i = 0; i < count; ++i)
        result.light.push_back({{static_cast<float>(first + i), 0, 0}, .5F});
    return result;
}

TEST(KnownPixels, AreFoundAtTheirCentresAndNowhereElse) {
    KnownPixels known;
    known.set_size(5, 3);
    EXPECT_EQ(known.find(1, 1), nullptr);  // nothing has come
    ASSERT_TRUE(known.add(part(0, 7)));
    ASSERT_TRUE(known.add(part(7, 8)));
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 5; ++x) {
            // POV-Ray adds up steps to come to a sub-pixel: 1/3 + 1/3 - 2/3 is not quite 0.
            for (const double off : {0., 5e-17, -5e-17, 1e-12}) {
                const FinishPart::Light* light = known.find(x + off, y - off);
                ASSERT_NE(light, nullptr) << x << ", " << y;
                EXPECT_EQ(light->colour.r, static_cast<float>(5 * y + x));
            }
            EXPECT_EQ(known.find(x + 1e-6, y), nullptr);
            EXPECT_EQ(known.find(x - .5, y - .5), nullptr);
        }
    for (const auto& [x, y] : {std::pair{-1., 0.}, {0., -1.}, {5., 0.}, {0., 3.}, {1e300, 0.}})
        EXPECT_EQ(known.find(x, y), nullptr) << x << ", " << y;
}

TEST(KnownPixels, WhatHasNoColourIsNotKnown) {
    KnownPixels known;
    known.set_size(2, 1);
    FinishPart one = part(0, 2);
    one.light[1].colour.r = std::numeric_limits<float>::quiet_NaN();
    ASSERT_TRUE(known.add(one));
    EXPECT_NE(known.find(0, 0), nullptr);
    EXPECT_EQ(known.find(1, 0), nullptr);
}

TEST(KnownPixels, WhatLiesOutsideIsRefused) {
    KnownPixels known;
    EXPECT_FALSE(known.add(part(0, 1)));  // no picture yet
    known.set_size(5, 3);
    EXPECT_FALSE(known.add(part(0, 16)));
    EXPECT_FALSE(known.add(part(15, 1)));
    EXPECT_FALSE(known.add(part(0xffffffff, 2)));
    EXPECT_TRUE(known.add(part(15, 0)));
    EXPECT_TRUE(known.add(part(14, 1)));
}

}  // namespace
}  // namespace povpreview::tracer
