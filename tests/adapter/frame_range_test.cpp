// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Frames as POV-Ray counts them; reference.sh holds the pictures against POV-Ray's own.
#include "adapter/frame_range.h"

#include <gtest/gtest.h>

#include "core/error.h"

namespace povpreview {
namespace {

FrameRange range(const std::vector<std::string>& words) {
    FrameRange result;
    for (const std::string& word : words) result.take(read_word(word));
    return result;
}
using Frames = std::vector<int>;

TEST(FrameRange, StillPictures) {
    for (const std::vector<std::string>& words : {std::vector<std::string>{},
                                                  {"+K0.5"},
                                                  {"+KFI1", "+KFF1"},
                                                  {"Final_Frame=0"},
                                                  {"+KFF5", "Final_Frame=0"},
                                                  {"+KI0", "+KF3"}})
        EXPECT_FALSE(range(words).animated()) << ::testing::PrintToString(words);
}

TEST(FrameRange, AllFramesInEveryWayToSayThem) {
    EXPECT_EQ(range({"+KFI1", "+KFF4"}).frames(), (Frames{1, 2, 3, 4}));
    EXPECT_EQ(range({"final_frame=4"}).frames(), (Frames{1, 2, 3, 4}));
    EXPECT_EQ(range({"Initial_Frame = 0", "Final_Frame = 2 "}).frames(), (Frames{0, 1, 2}));
    EXPECT_EQ(range({"+KFF9", "+STP4"}).frames(), (Frames{1, 5, 9}));
    EXPECT_EQ(range({"+KFF9", "Frame_Step=-4", "+KFF2"}).frames(), (Frames{1, 2}));
}

TEST(FrameRange, SubsetsByNumberAndByShare) {
    EXPECT_EQ(range({"+KFF10", "+SF3", "+EF5"}).frames(), (Frames{3, 4, 5}));
    EXPECT_EQ(range({"+KFF10", "Subset_Start_Frame=0.8"}).frames(), (Frames{8, 9, 10}));
    EXPECT_EQ(range({"+KFF10", "+EF0.25"}).frames(), (Frames{1, 2}));
    EXPECT_EQ(range({"+KFI4", "+KFF6", "+SF1"}).frames(), (Frames{4, 5, 6}));
    EXPECT_EQ(range({"+KFF10", "+SF11", "+EF12"}).frames(), (Frames{11, 12}));
}

TEST(FrameRange, ACyclicAnimationLeavesTheSecondFirstFrameOut) {
    const FrameRange cyclic = range({"+KFF9", "+KC"});
    EXPECT_EQ(cyclic.frames().back(), 9);
    EXPECT_EQ(cyclic.digits(), 2);  // POV-Ray counts the one left out
    EXPECT_EQ(range({"+KFF9", "Cyclic_Animation=on", "-KC"}).digits(), 1);
}

TEST(FrameRange, NoFramesAtAll) {
    for (const std::vector<std::string>& words : {std::vector<std::string>{"+KFI5", "+KFF3"},
                                                  {"+KFF10", "+SF11"},
                                                  {"+KFF10", "+SF5", "+EF4"},
                                                  {"+KFI1", "+KFF0"},
                                                  {"+KFF1000000000"},
                                                  {"+KFI2"}}) {
        try {
            range(words).frames();
            FAIL() << ::testing::PrintToString(words);
        } catch (const Error& error) {
            EXPECT_EQ(error.exit(), Exit::usage);
        }
    }
}

TEST(FrameRange, WhatIsNoNumber) {
    for (const char* word : {"+KFFx", "+KFF", "Final_Frame=nan", "+SF1e99", "Frame_Step=two"})
        EXPECT_THROW(range({word}), Error) << word;
}

}  // namespace
}  // namespace povpreview
