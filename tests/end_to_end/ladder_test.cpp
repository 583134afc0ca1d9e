// SPDX-License-Identifier: AGPL-3.0-or-later
//
// The tracer's ladder of accuracy: a lower rung of a scene is the target of the scene without what
// the rung leaves out, and the target is the same whatever was traced before it.
#include <gtest/gtest.h>

#include "adapter/povray_options.h"
#include "tests/end_to_end/real_tracer.h"
#include "tests/end_to_end/scenes.h"

namespace povpreview {
namespace {

constexpr Parts everything = Parts::surface | Parts::shading | Parts::signature;

/// A scene in which `dear` stands where something dear may be said.
struct LadderScene {
    const char* name;
    const char *before, *dear, *after;
    const char* rung;  ///< that leaves it out
};
void PrintTo(const LadderScene& scene, std::ostream* out) { *out << scene.name; }

const LadderScene ladder_scenes[] = {
    {"area_light", R"(#version 3.7; global_settings { assumed_gamma 1 }
camera { location <0, 2, -5> look_at 0 } light_source { <3, 6, -3>, 1 )",
     "area_light 2*x, 2*z, 5, 5 adaptive 1 jitter",
     "} plane { y, -1 pigment { rgb .8 } } sphere { 0, 1 pigment { rgb <.2, .7, .3> } }", "sketch"},
    {"focal_blur", R"(#version 3.7; global_settings { assumed_gamma 1 }
camera { location <0, 1, -4> look_at 0 )",
     "aperture .4 blur_samples 12 focal_point <0, 0, -1>",
     R"(} light_source { <5, 9, -7>, 1 } plane { y, -1 pigment { checker rgb .2 rgb .9 } }
sphere { 0, 1 pigment { rgb <1, .3, .1> } finish { reflection .3 } })",
     "sketch"},
    {"radiosity", "#version 3.7; global_settings { assumed_gamma 1 ",
     "radiosity { count 20 pretrace_start .16 pretrace_end .08 }", R"(}
camera { location <0, 1, -4> look_at 0 } light_source { <1, 2, -3>, .5 }
box { <-3, -1, -5>, <3, 3, 3> pigment { gradient x color_map { [0 rgb x] [1 rgb z] } scale 6 }
  finish { ambient 0 } } sphere { 0, 1 pigment { rgb .9 } finish { ambient 0 } })",
     "sketch"},
    {"photons", "#version 3.7; global_settings { assumed_gamma 1 ", "photons { spacing .05 }", R"(}
camera { location <0, 3, -4> look_at 0 } light_source { <2, 6, 1>, 1 }
plane { y, -1 pigment { rgb .8 } }
sphere { 0, 1 pigment { rgbf .95 } interior { ior 1.5 } finish { specular .4 }
  photons { target reflection on refraction on } })",
     "unprepared"},
};

class LadderTest : public testing::TestWithParam<LadderScene> {
   protected:
    void SetUp() override {
        if (real_tracer().empty()) GTEST_SKIP() << "no tracer: POVPREVIEW_TRACER is not set";
    }
    std::vector<std::string> words(bool with_dear, const char* threads) const {
        const LadderScene& scene = GetParam();
        const std::string text =
            std::string(scene.before) + (with_dear ? scene.dear : "") + scene.after;
        return {folder_.write(with_dear ? "dear.pov" : "cheap.pov", text), "+W64", "+H48", threads};
    }
    /// Of the scene with what is dear in it.
    Ladder ladder() const {
        PovrayOracle oracle(
            {.program = real_tracer(),
             .arguments = read_povray_options(words(true, "+WT2")).tracer_arguments()});
        return oracle.wait_for_scene(nullptr, nullptr).ladder;
    }
    WorkFolder folder_;
};

void expect_equal_light(const std::vector<Sample>& a, const std::vector<Sample>& b) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        ASSERT_EQ(a[i].colour, b[i].colour) << "pixel " << i;
        ASSERT_EQ(a[i].surface, b[i].surface) << "pixel " << i;
    }
}

TEST_P(LadderTest, ARungIsTheSceneWithoutWhatItLeavesOut) {
    const Rung rung = rung_named(ladder(), GetParam().rung);
    ASSERT_NE(rung, target_rung);
    const auto low = trace_pixels(words(true, "+WT2"), RayKind::full, everything, 5, rung).samples;
    const auto cheap = trace_pixels(words(false, "+WT2"), RayKind::full, everything, 6).samples;
    const auto high = trace_pixels(words(true, "+WT2"), RayKind::full, everything, 7).samples;
    expect_equal_light(low, cheap);
    std::size_t others = 0;
    for (std::size_t i = 0; i < low.size(); ++i) {
        EXPECT_EQ(low[i].rung, rung);
        EXPECT_EQ(high[i].rung, target_rung);
        if (low[i].colour != high[i].colour) ++others;
    }
    EXPECT_GT(others, low.size() / 50);  // there was something to leave out
}

TEST_P(LadderTest, TheTargetDoesNotDependOnWhatWasTracedBefore) {
    const std::vector<std::string> scene = words(true, "+WT2");
    PovrayOracle oracle(
        {.program = real_tracer(), .arguments = read_povray_options(scene).tracer_arguments()});
    const Ladder rungs = oracle.wait_for_scene(nullptr, nullptr).ladder;
    std::vector<Request> requests;
    for (std::size_t place = 0; place < rungs.rungs.size(); ++place)
        for (int y = 0; y < 48; ++y)
            for (int x = 0; x < 64; ++x)
                requests.push_back(
                    {{x + .5, y + .5}, RayKind::full, rung_named(rungs, std::to_string(place))});
    oracle.submit(requests, everything);
    std::vector<Sample> samples;
    for (int i = 0; samples.size() < requests.size() && i < 2000; ++i)
        oracle.collect(samples, std::chrono::milliseconds(20));
    ASSERT_EQ(samples.size(), requests.size());
    const auto alone = trace_pixels(scene, RayKind::full, everything, 1).samples;
    const std::size_t first = samples.size() - alone.size();
    // The threads of a radiosity pretrace fill the cache in any order, which moves the rounding.
    for (std::size_t i = 0; i < alone.size(); ++i)
        for (int c = 0; c < 3; ++c)
            ASSERT_NEAR(samples[first + i].colour[c], alone[i].colour[c], 1e-5f) << "pixel " << i;
}

INSTANTIATE_TEST_SUITE_P(Scenes, LadderTest, testing::ValuesIn(ladder_scenes),
                         [](const auto& scene) { return scene.param.name; });

TEST(LadderOf, ASceneWithoutDearFeaturesIsItsTarget) {
    if (real_tracer().empty()) GTEST_SKIP() << "no tracer: POVPREVIEW_TRACER is not set";
    const WorkFolder folder;
    const std::string scene = folder.write("scene.pov", scenes::still[0].text);
    for (const char* quality : {"+Q9", "+Q5"}) {
        PovrayOracle oracle(
            {.program = real_tracer(),
             .arguments =
                 read_povray_options({scene, "+W16", "+H12", quality}).tracer_arguments()});
        const Ladder ladder = oracle.wait_for_scene(nullptr, nullptr).ladder;
        ASSERT_EQ(ladder.rungs.size(), 1u);
        EXPECT_EQ(ladder.rungs[0].name, "target");
        EXPECT_TRUE(oracle.target_ready());
    }
}

}  // namespace
}  // namespace povpreview
