// SPDX-License-Identifier: AGPL-3.0-or-later
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "core/error.h"
#include "display/program/data_uri.h"
#include "display/program/plot.h"
#include "display/program/report_pictures.h"
#include "display/program/scene_list.h"
#include "tests/display/temporary_folder.h"

namespace povpreview {
namespace {

std::string uri(const std::string& text) {
    return data_uri("t", {reinterpret_cast<const unsigned char*>(text.data()), text.size()});
}

TEST(DataUri, HasTheVectorsOfRfc4648) {
    EXPECT_EQ(uri(""), "data:t;base64,");
    EXPECT_EQ(uri("f"), "data:t;base64,Zg==");
    EXPECT_EQ(uri("fo"), "data:t;base64,Zm8=");
    EXPECT_EQ(uri("foobar"), "data:t;base64,Zm9vYmFy");
    EXPECT_EQ(uri("\xff\xfe\xfd"), "data:t;base64,//79");
}

TEST(Html, WhatItReadsOtherwiseIsEscaped) {
    EXPECT_EQ(html_escaped("a<b>&\"c"), "a&lt;b&gt;&amp;&quot;c");
}

CurvePoint at(int moment, double l1) {
    CurvePoint point;
    point.moment = moment;
    point.plain.l1 = l1;
    return point;
}

TEST(TellingMoments, RunFromRecognisableToGood) {
    const std::vector<CurvePoint> points{at(2, .3),  at(3, .04),  at(4, .03), at(5, .02),
                                         at(6, .01), at(7, .004), at(8, 0)};
    std::vector<const CurvePoint*> run;
    for (const CurvePoint& p : points) run.push_back(&p);
    EXPECT_EQ(telling_moments(run, 3), (std::vector<int>{3, 5, 7}));
    EXPECT_EQ(telling_moments({&points[0]}, 3), (std::vector<int>{2}));
    EXPECT_TRUE(telling_moments({}, 3).empty());
}

TEST(HeaviestWindow, IsWhereTheWeightIs) {
    std::vector<float> weights(40 * 30);
    weights[20 * 40 + 33] = 1;
    const Rectangle window = heaviest_window(weights, 40, 30, 8, 6);
    EXPECT_TRUE(window.x <= 33 && 33 < window.x + 8 && window.y <= 20 && 20 < window.y + 6);
    EXPECT_EQ(heaviest_window(weights, 40, 30, 40, 30), (Rectangle{0, 0, 40, 30}));
    // Negative everywhere: still inside.
    const Rectangle least = heaviest_window(std::vector<float>(1200, -1), 40, 30, 8, 6);
    EXPECT_TRUE(least.x >= 0 && least.x + 8 <= 40 && least.y >= 0 && least.y + 6 <= 30);
}

TEST(ErrorColour, GetsLighterWithTheError) {
    float before = -1;
    for (int i = 0; i <= 100; ++i) {
        const glm::vec3 c = error_colour(float(i) / 100);
        const float luminance = .2126f * c.x + .7152f * c.y + .0722f * c.z;
        EXPECT_GT(luminance, before) << i;
        before = luminance;
    }
    EXPECT_EQ(error_colour(-3), error_colour(0));
    EXPECT_EQ(error_colour(7), error_colour(1));
}

TEST(Plot, DrawsWhateverItsNames) {
    const test::TemporaryFolder folder;
    const std::string file = folder / "plot 'test'.svg";
    draw_plot({.title = "it's \"quoted\" $x_1 `true`",
               .x_title = "x",
               .y_title = "y",
               .curves = {{"a_b^c", "#ff0000", {{1, 1}, {10, .1}, {0, 0}}}}},
              file);
    std::ifstream stream(file);
    std::stringstream svg;
    svg << stream.rdbuf();
    EXPECT_NE(svg.str().find("</svg>"), std::string::npos);
    EXPECT_NE(svg.str().find("a_b^c"), std::string::npos);
    EXPECT_NE(svg.str().find("$x_1 `true`"), std::string::npos);
    EXPECT_THROW(draw_plot({}, "/nowhere/plot.svg"), Error);
}

TEST(Plot, NeedsNoMoreThanAPoint) {
    const test::TemporaryFolder folder;
    const std::string file = folder / "plot_test.svg";
    for (const auto& points :
         {std::vector<std::pair<double, double>>{}, {{.5, 0}}, {{3, .1}}, {{3, .1}, {3, .1}}}) {
        std::filesystem::remove(file);
        draw_plot(
            {.title = "t", .x_title = "x", .y_title = "y", .curves = {{"a", "#ff0000", points}}},
            file);
        EXPECT_GT(std::filesystem::file_size(file), 500u);
    }
}

class SceneList : public ::testing::Test {
   protected:
    SceneList() {
        std::filesystem::create_directories(folder / "a");
        std::filesystem::create_directories(folder / "b");
        for (const char* name : {"a/one.pov", "b/one.pov", "b/two.pov"})
            std::ofstream(folder / name) << "\n";
    }
    const test::TemporaryFolder folder_;  // tests run side by side
    const std::filesystem::path folder = folder_.path();
};

TEST_F(SceneList, EachSceneGetsTheSharedWordsAndItsFolder) {
    const std::string one = folder / "a/one.pov", two = folder / "b/two.pov";
    const auto list = scene_list({"+W64", one, "+H48", two});
    ASSERT_EQ(list.size(), 2u);
    EXPECT_EQ(list[0].name, "one");
    EXPECT_EQ(list[0].words,
              (std::vector<std::string>{"+W64", "+H48", one, "+L" + (folder / "a").string()}));
    EXPECT_EQ(list[1].name, "two");
    EXPECT_EQ(list[1].words[2], two);
}

TEST_F(SceneList, EqualNamesAreToldApart) {
    const auto list = scene_list({folder / "a/one.pov", folder / "b/one.pov"});
    EXPECT_EQ(list[0].name, "one");
    EXPECT_EQ(list[1].name, "one-2");
}

TEST_F(SceneList, NoSceneOrAMissingOneIsTheUsersFault) {
    EXPECT_THROW(scene_list({}), Error);
    EXPECT_THROW(scene_list({folder / "a/one.pov", folder / "missing.pov"}), Error);
}

}  // namespace
}  // namespace povpreview
