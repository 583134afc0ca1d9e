// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/program/curves.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "display/program/summary.h"
#include "tests/display/temporary_folder.h"

namespace povpreview {
namespace {

CurvePoint point(const std::string& method, double time_s, double l1, int repeat = 1,
                 const std::string& scene = "s") {
    CurvePoint p;
    p.scene = scene;
    p.method = method;
    p.repeat = repeat;
    p.standing.time_s = time_s;
    p.plain.l1 = l1;
    return p;
}

std::optional<double> time_to_error(const std::vector<CurvePoint>& curves,
                                    const std::string& method, double level) {
    return crossing(run_of(curves, "s", method, 1), axes()[0], measures()[0], level);
}

TEST(Crossing, InterpolatesOnLogarithmicAxes) {
    const std::vector<CurvePoint> curves{point("a", 1, .1), point("a", 4, .025)};
    EXPECT_NEAR(*time_to_error(curves, "a", .05), 2, 1e-9);  // e = .1 / t
}

TEST(Crossing, TakesTheFirstPointWhereThatIsGoodEnough) {
    const std::vector<CurvePoint> curves{point("a", 3, .01), point("a", 4, .001)};
    EXPECT_EQ(*time_to_error(curves, "a", .05), 3);
}

TEST(Crossing, AnErrorThatRisesAgainDoesNotCount) {
    const std::vector<CurvePoint> curves{point("a", 1, .01), point("a", 2, .08),
                                         point("a", 4, .02)};
    const double time = *time_to_error(curves, "a", .04);
    EXPECT_GT(time, 2);
    EXPECT_LT(time, 4);
}

TEST(Crossing, NothingWhereTheLevelIsNeverReached) {
    EXPECT_FALSE(time_to_error({point("a", 1, .1)}, "a", .05));
    EXPECT_FALSE(time_to_error({point("a", 1, .01)}, "b", .05));
}

TEST(Crossing, AnErrorOfZeroIsReached) {
    const auto time = time_to_error({point("a", 1, .1), point("a", 2, 0)}, "a", .005);
    ASSERT_TRUE(time);
    EXPECT_GT(*time, 1);
    EXPECT_LE(*time, 2);
}

TEST(Crossing, APointWithoutRaysHasNoPlaceOnTheirAxis) {
    EXPECT_FALSE(crossing(run_of({point("a", 1, .01)}, "s", "a", 1), axes()[2], measures()[0], .1));
}

TEST(Median, IsTheMiddleOrTheMeanOfTwo) {
    EXPECT_EQ(median({3}), 3);
    EXPECT_EQ(median({9, 1, 4}), 4);
    EXPECT_EQ(median({8, 1, 2, 4}), 3);
}

const Reached& reached(const Summary& summary, const std::string& scene, const std::string& method,
                       double level) {
    for (const Reached& r : summary.reached)
        if (r.scene == scene && r.method == method && r.measure == &measures()[0] &&
            r.axis == &axes()[0] && r.level == level)
            return r;
    throw std::runtime_error("no such record");
}

const MeanRatio& mean(const Summary& summary, const std::string& method, double level) {
    for (const MeanRatio& m : summary.means)
        if (m.method == method && m.measure == &measures()[0] && m.axis == &axes()[0] &&
            m.level == level)
            return m;
    throw std::runtime_error("no such record");
}

TEST(Summary, TakesMediansOverRunsAndTellsTheSpread) {
    const std::vector<CurvePoint> curves{point("a", 3, .01, 1), point("a", 1, .01, 2),
                                         point("a", 2, .01, 3), point("b", 8, .01, 1),
                                         point("b", 8, .2, 2),  point("b", 9, .01, 3)};
    const Summary summary = summarise(curves, {"s"}, {"a", "b"});
    const Reached& a = reached(summary, "s", "a", .05);
    EXPECT_EQ(a.repeats, 3);
    EXPECT_EQ(*a.median, 2);
    EXPECT_EQ(*a.least, 1);
    EXPECT_EQ(*a.greatest, 3);
    EXPECT_EQ(*a.ratio, 1);
    const Reached& b = reached(summary, "s", "b", .05);
    EXPECT_EQ(b.reached, 2);
    EXPECT_EQ(*b.median, 9);  // of 8, 9 and never
    EXPECT_EQ(*b.ratio, 4.5);
}

TEST(Summary, AMethodThatMostlyNeverCameThereHasNoMedian) {
    const std::vector<CurvePoint> curves{point("a", 3, .01, 1), point("b", 8, .2, 1),
                                         point("b", 8, .2, 2), point("b", 9, .01, 3)};
    const Reached b = reached(summarise(curves, {"s"}, {"a", "b"}), "s", "b", .05);
    EXPECT_FALSE(b.median);
    EXPECT_EQ(*b.least, 9);
    EXPECT_FALSE(b.ratio);
}

TEST(Summary, MeansAreGeometricAndOnlyOneArrivingIsAWinOrALoss) {
    const std::vector<CurvePoint> curves{
        point("a", 1, .01, 1, "even"),  point("b", 1.01, .01, 1, "even"),
        point("a", 1, .01, 1, "won"),   point("b", 8, .01, 1, "won"),
        point("a", 2, .01, 1, "lost"),  point("b", 1, .01, 1, "lost"),
        point("a", 2, .01, 1, "alone"), point("b", 1, .2, 1, "alone"),
        point("a", 2, .2, 1, "missed"), point("b", 1, .01, 1, "missed"),
        point("a", 2, .2, 1, "nobody"), point("b", 1, .2, 1, "nobody")};
    const MeanRatio b =
        mean(summarise(curves, {"even", "won", "lost", "alone", "missed", "nobody"}, {"a", "b"}),
             "b", .05);
    EXPECT_EQ(b.scenes, 3);
    EXPECT_NEAR(*b.geometric_mean, std::cbrt(1.01 * 8 * .5), 1e-9);
    EXPECT_EQ(b.wins, 2);
    EXPECT_EQ(b.losses, 2);
    EXPECT_EQ(b.ties, 1);
}

TEST(Curves, HaveTheColumnsPromised) {
    const test::TemporaryFolder folder;
    const std::string file = folder / "curves_test.csv";
    CurvePoint p = point("mesh", 1, .25, 2, "a, \"b\"");
    p.moment = 7;
    write_curves({p}, file);
    std::ifstream stream(file);
    std::stringstream text;
    text << stream.rdbuf();
    EXPECT_EQ(text.str(),
              "scene,method,repeat,moment,time_s,launch_s,full,probe,albedo,full_s,probe_s,"
              "albedo_s,memory_mb,l1,rmse,psnr,ssim,flip,edge_l1,"
              "aa_l1,aa_rmse,aa_psnr,aa_ssim,aa_flip,aa_edge_l1\n"
              "\"a, \"\"b\"\"\",mesh,2,7,1.000000,0.000000,0,0,0,0,0,0,0,"
              "0.25,0,inf,1,0,0,0,0,inf,1,0,0\n");
}

}  // namespace
}  // namespace povpreview
