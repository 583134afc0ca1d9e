// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/caption.h"

#include <gtest/gtest.h>

namespace povpreview::test {
namespace {

/// Columns of the image from the first to behind the last that is not ground.
std::pair<int, int> ink(const Image& image) {
    int first = image.width, last = 0;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            if (image.at(x, y).x < .1f) continue;
            first = std::min(first, x);
            last = std::max(last, x + 1);
        }
    }
    return {first, last};
}

TEST(Caption, HasInkThatGrowsWithTheText) {
    const auto [from, to] = ink(caption_strip("mosaic", 400));
    EXPECT_GT(to, from + 20);
    const auto [from2, to2] = ink(caption_strip("mosaic, 12 s", 400));
    EXPECT_EQ(from2, from);
    EXPECT_GT(to2, to + 20);
}

TEST(Caption, NoTextHasNoInk) { EXPECT_EQ(ink(caption_strip("", 100)).second, 0); }

TEST(Caption, LinesStandBelowEachOther) {
    const int one = caption_strip("a", 300).height, two = caption_strip("a\nb", 300).height;
    EXPECT_GT(two, one + 10);
}

TEST(Caption, LongTextIsBrokenNotCut) {
    std::string text;
    for (int word = 0; word < 30; ++word) text += "sample" + std::to_string(word) + " ";
    const Image strip = caption_strip(text, 300);
    EXPECT_EQ(strip.width, 300);
    EXPECT_LE(ink(strip).second, 300 - 4) << "within the margin";
    EXPECT_GT(strip.height, 5 * 12);
}

TEST(Caption, OddCharactersAreNoHarm) {
    EXPECT_EQ(caption_strip("\xC3\xBC", 200).pixels, caption_strip("?", 200).pixels);
    EXPECT_NO_THROW(caption_strip("\xff\x80 \t \x01", 200));
    EXPECT_NO_THROW(caption_strip(std::string(500, 'x'), 50));
}

TEST(Compose, KeepsEveryPixelOfTheImages) {
    Image left(300, 20), right(250, 30, {4, 5, 6});
    for (int x = 0; x < 300; ++x) left.at(x, 7) = {x, -1, .25f};
    const Panel panels[] = {{left, "left"}, {right, "right"}};
    const Image both = compose(panels);
    for (int y = 0; y < 20; ++y)
        for (int x = 0; x < 300; ++x) ASSERT_EQ(both.at(x, y), left.at(x, y));
    const int start = both.width - 250;
    EXPECT_GT(start, 300);
    for (int y = 0; y < 30; ++y)
        for (int x = 0; x < 250; ++x) ASSERT_EQ(both.at(start + x, y), glm::vec3(4, 5, 6));
    EXPECT_GT(both.height, 30 + 12);
}

TEST(Compose, SmallImagesLeaveRoomForCaptions) {
    const Image dot(1, 1, {9, 9, 9});
    const Panel panels[] = {{dot, "one sample, 100 % of pixels"}};
    const Image all = compose(panels);
    EXPECT_GE(all.width, 200);
    int dots = 0;
    for (const glm::vec3& colour : all.pixels) dots += colour == glm::vec3(9);
    EXPECT_EQ(dots, 1);
}

TEST(Compose, WithoutCaptionsThereIsNoStrip) {
    const Image image(300, 20);
    const Panel panels[] = {{image, ""}, {image, ""}};
    EXPECT_EQ(compose(panels).height, 20);
    EXPECT_EQ(compose({}).pixels.size(), 0u);
}

}  // namespace
}  // namespace povpreview::test
