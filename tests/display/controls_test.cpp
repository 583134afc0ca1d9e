// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/controls.h"

#include <gtest/gtest.h>

namespace povpreview::test {
namespace {

TEST(Controls, OverlayKeysTakeTurns) {
    Controls controls;
    EXPECT_TRUE(controls.press('m'));
    EXPECT_EQ(controls.overlay, Overlay::mesh);
    EXPECT_TRUE(controls.press('e'));
    EXPECT_EQ(controls.overlay, Overlay::edges);
    EXPECT_TRUE(controls.press('S'));
    EXPECT_EQ(controls.overlay, Overlay::samples);
    EXPECT_TRUE(controls.press('s'));
    EXPECT_EQ(controls.overlay, Overlay::none);
}

TEST(Controls, BesideToggles) {
    Controls controls;
    controls.press('b');
    EXPECT_TRUE(controls.beside);
    controls.press('b');
    EXPECT_FALSE(controls.beside);
}

TEST(Controls, SavingAndEnding) {
    for (const char end : {'q', 'Q', Controls::escape}) {
        Controls controls;
        controls.press('p');
        EXPECT_TRUE(controls.save);
        EXPECT_FALSE(controls.closed);
        EXPECT_TRUE(controls.press(end));
        EXPECT_TRUE(controls.closed);
    }
}

TEST(Controls, OtherKeysDoNothing) {
    for (int key = 1; key < 128; ++key) {
        const auto letter = static_cast<char>(key);
        if (std::string("mesbpqMESBPQ\x1b").find(letter) != std::string::npos) continue;
        Controls controls;
        EXPECT_FALSE(controls.press(letter)) << key;
        EXPECT_TRUE(controls.overlay == Overlay::none && !controls.beside && !controls.save &&
                    !controls.closed);
    }
}

}  // namespace
}  // namespace povpreview::test
