// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/program/reference_list.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "core/error.h"
#include "tests/display/temporary_folder.h"

namespace povpreview {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

class ReferenceListTest : public testing::Test {
   protected:
    void SetUp() override {
        before_ = fs::current_path();
        fs::current_path(folder_.path());
        for (const char* scene : {"a.pov", "b.pov", "x/a.pov", "x/deep/c.pov", "y/deep/c.pov",
                                  "z/a b.pov", "a.inc", "a-x.pov"}) {
            fs::create_directories(fs::path(scene).parent_path() / ".");
            std::ofstream(scene) << "camera {}\n";
        }
        std::ofstream("sizes.ini") << "Quality=3\n[one]\nWidth=10\n [Two]\n+H20\n[one]\nHeight=5\n";
        std::ofstream("named.ini") << "Input_File_Name=b.pov\nFinal_Frame=2\n";
    }
    void TearDown() override { fs::current_path(before_); }
    static Words names(const Words& words, const fs::path& sections = {}) {
        Words result;
        for (const ReferenceItem& item : reference_items(words, sections))
            result.push_back(item.name + (item.problem.empty() ? "" : "!"));
        return result;
    }

    test::TemporaryFolder folder_;
    fs::path before_;
};

TEST_F(ReferenceListTest, NamesAreAsShortAsTheyTellScenesApart) {
    EXPECT_EQ(names({"a.pov", "+W64", "b.pov"}), (Words{"a", "b"}));
    EXPECT_EQ(names({"x/deep/c.pov", "y/deep/c.pov", "b.pov"}),
              (Words{"x/deep/c", "y/deep/c", "b"}));
    EXPECT_EQ(names({"z/a b.pov", "+Ib.pov"}), (Words{"a b", "b"}));
    const std::string here = folder_.path().filename();
    EXPECT_EQ(names({"a.pov", "x/a.pov"}), (Words{here + "/a", "x/a"}));
}

TEST_F(ReferenceListTest, TheOrderOfScenesDoesNotNameThem) {
    Words one = names({"x/deep/c.pov", "y/deep/c.pov", "b.pov"}),
          other = names({"b.pov", "y/deep/c.pov", "x/deep/c.pov"});
    std::sort(one.begin(), one.end());
    std::sort(other.begin(), other.end());
    EXPECT_EQ(one, other);
}

TEST_F(ReferenceListTest, ASceneNamedTwiceIsOne) {
    EXPECT_EQ(names({"a.pov", "x/../a.pov", "./a.pov"}), Words{"a"});
}

TEST_F(ReferenceListTest, FramesAndSections) {
    EXPECT_EQ(names({"a.pov", "+KFI9", "+KFF10"}), (Words{"a09", "a10"}));
    EXPECT_EQ(names({"a.pov"}, "sizes.ini"), (Words{"a-one", "a-Two"}));
    EXPECT_EQ(names({"a.pov", "b.pov", "+KFF2"}, "sizes.ini").size(), 8U);
    EXPECT_EQ(names({"named.ini"}), (Words{"b1", "b2"}));
}

TEST_F(ReferenceListTest, ASectionsSettingsAreItsOwn) {
    const auto items = reference_items({"+H1", "a.pov"}, "sizes.ini");
    const Words& words = items.at(0).povray.words;
    const auto own = std::find(words.begin(), words.end(), "sizes.ini[one]");
    ASSERT_NE(own, words.end());
    EXPECT_LT(std::find(words.begin(), words.end(), "+H1"), own) << "later ones win";
}

TEST_F(ReferenceListTest, OneThreadUnlessAskedForMore) {
    EXPECT_EQ(reference_items({"a.pov"}, {}).at(0).povray.threads, 1);
    EXPECT_EQ(reference_items({"a.pov", "+WT3"}, {}).at(0).povray.threads, 3);
}

TEST_F(ReferenceListTest, WhatCannotBeRenderedIsAnItemAllTheSame) {
    EXPECT_EQ(names({"missing.pov", "a.pov"}), (Words{"missing!", "a"}));
    EXPECT_EQ(names({"a.pov", "+KFI3", "+KFF2"}), Words{"a!"});
}

TEST_F(ReferenceListTest, Refusals) {
    EXPECT_THROW(names({}), Error);
    EXPECT_THROW(names({"+W64"}), Error);
    EXPECT_THROW(names({"a.pov"}, "a.inc"), Error);
    EXPECT_THROW(names({"a.pov"}, "missing.ini"), Error);
    std::ofstream("alike.ini") << "[x]\n[x-x]\n";
    EXPECT_EQ(names({"a.pov"}, "alike.ini"), (Words{"a-x", "a-x-x"}));
    EXPECT_THROW(names({"a.pov", "a-x.pov"}, "alike.ini"), Error) << "a-x-x twice";
}

}  // namespace
}  // namespace povpreview
