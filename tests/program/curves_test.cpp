// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/program/curves.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

namespace povpreview {
namespace {

CurvePoint point(const std::string& method, double time_s, double l1) {
    CurvePoint p;
    p.method = method;
    p.standing.time_s = time_s;
    p.l1 = l1;
    return p;
}

TEST(TimeToError, InterpolatesOnLogarithmicAxes) {
    const std::vector<CurvePoint> curves{point("a", 1, .1), point("a", 4, .025)};
    EXPECT_NEAR(*time_to_error(curves, "a", .05), 2, 1e-9);  // e = .1 / t
}

TEST(TimeToError, TakesTheFirstPointWhereThatIsGoodEnough) {
    const std::vector<CurvePoint> curves{point("a", 3, .01), point("a", 4, .001)};
    EXPECT_EQ(*time_to_error(curves, "a", .05), 3);
}

TEST(TimeToError, AnErrorThatRisesAgainDoesNotCount) {
    const std::vector<CurvePoint> curves{point("a", 1, .01), point("a", 2, .08),
                                         point("a", 4, .02)};
    const double time = *time_to_error(curves, "a", .04);
    EXPECT_GT(time, 2);
    EXPECT_LT(time, 4);
}

TEST(TimeToError, NothingWhereTheLevelIsNeverReached) {
    EXPECT_FALSE(time_to_error({point("a", 1, .1)}, "a", .05));
    EXPECT_FALSE(time_to_error({point("a", 1, .01)}, "b", .05));
}

TEST(TimeToError, AnErrorOfZeroIsReached) {
    const auto time = time_to_error({point("a", 1, .1), point("a", 2, 0)}, "a", .005);
    ASSERT_TRUE(time);
    EXPECT_GT(*time, 1);
    EXPECT_LE(*time, 2);
}

TEST(Curves, HaveTheColumnsPromised) {
    const std::string file = testing::TempDir() + "curves_test.csv";
    write_curves({point("mesh", 1, .25)}, file);
    std::ifstream stream(file);
    std::stringstream text;
    text << stream.rdbuf();
    EXPECT_EQ(text.str(),
              "method,time_s,launch_s,full,probe,albedo,l1,rmse\n"
              "mesh,1.0000,0.0000,0,0,0,0.2500000,0.0000000\n");
}

}  // namespace
}  // namespace povpreview
