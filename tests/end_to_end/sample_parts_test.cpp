// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Laws of the tracer's samples that need no reference: what core/oracle.h promises.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/end_to_end/real_tracer.h"
#include "tests/end_to_end/scenes.h"

namespace povpreview {
namespace {

constexpr Parts everything = Parts::surface | Parts::shading | Parts::signature;

std::vector<scenes::SmallScene> all_scenes() {
    std::vector<scenes::SmallScene> all(std::begin(scenes::still), std::end(scenes::still));
    all.insert(all.end(), std::begin(scenes::noisy), std::end(scenes::noisy));
    return all;
}

class SamplePartsTest : public testing::TestWithParam<scenes::SmallScene> {
   protected:
    void SetUp() override {
        if (real_tracer().empty()) GTEST_SKIP() << "no tracer: POVPREVIEW_TRACER is not set";
        scene_ = folder_.write("scene.pov", GetParam().text);
    }
    std::vector<Sample> trace(RayKind kind, Parts parts, unsigned seed, const char* threads) const {
        return trace_pixels({scene_, "+W64", "+H48", threads}, kind, parts, seed).samples;
    }
    bool is(const char* name) const { return std::string(GetParam().name) == name; }

    WorkFolder folder_;
    std::string scene_;
};

/// The threads of a radiosity pretrace fill the cache in any order, which moves the rounding.
void expect_colours(const std::vector<Sample>& a, const std::vector<Sample>& b, float tolerance) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i)
        for (int c = 0; c < 3; ++c)
            ASSERT_NEAR(a[i].colour[c], b[i].colour[c], tolerance) << "pixel " << i;
}

TEST_P(SamplePartsTest, ColourDependsOnPositionAloneNotOnOrderThreadsOrParts) {
    const auto a = trace(RayKind::full, Parts::colour, 1, "+WT1");
    const auto b = trace(RayKind::full, everything, 2, "+WT3");
    expect_colours(a, b, is("radiosity") ? 1e-5f : 0.0f);
}

TEST_P(SamplePartsTest, ProbesAgreeWithFullRays) {
    const auto full = trace(RayKind::full, everything, 3, "+WT2");
    const auto probe = trace(RayKind::probe, Parts::colour, 4, "+WT2");
    std::size_t hits = 0, other_lights = 0;
    for (std::size_t i = 0; i < full.size(); ++i) {
        ASSERT_EQ(full[i].surface, probe[i].surface) << "pixel " << i;
        ASSERT_EQ(full[i].reflected_surface, probe[i].reflected_surface) << "pixel " << i;
        ASSERT_EQ(full[i].depth, probe[i].depth);
        ASSERT_EQ(full[i].normal, probe[i].normal);
        ASSERT_EQ(full[i].signature.primary, probe[i].signature.primary);
        ASSERT_EQ(full[i].signature.reflected, probe[i].signature.reflected);
        ASSERT_EQ(full[i].signature.refracted, probe[i].signature.refracted);
        other_lights += full[i].signature.lights != probe[i].signature.lights;
        hits += full[i].surface != 0;
    }
    EXPECT_GT(hits, full.size() / 4);
    // A jittered light that is just not wholly lit may fall on either side: grain uses up random
    // numbers in full rays only.
    EXPECT_LE(other_lights, is("jittered_light") ? full.size() / 100 : 0U);
}

TEST_P(SamplePartsTest, ColourIsAlbedoTimesIlluminationPlusRemainder) {
    const auto full = trace(RayKind::full, everything, 5, "+WT2");
    double albedo = 0;
    for (std::size_t i = 0; i < full.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            const float sum = full[i].albedo[c] * full[i].illumination[c] + full[i].remainder[c];
            ASSERT_NEAR(sum, full[i].colour[c], 1e-4 * std::max(1e-3f, std::fabs(sum)))
                << "pixel " << i;
            albedo += full[i].albedo[c];
        }
    EXPECT_GT(albedo / static_cast<double>(3 * full.size()), .05);
}

TEST_P(SamplePartsTest, AlbedoRaysAgreeWithFullRays) {
    const auto full = trace(RayKind::full, everything, 6, "+WT2");
    const auto guide = trace(RayKind::albedo, Parts::colour, 7, "+WT2");
    double off = 0;
    for (std::size_t i = 0; i < full.size(); ++i) {
        ASSERT_EQ(full[i].surface, guide[i].surface) << "pixel " << i;
        for (int c = 0; c < 3; ++c) off += std::fabs(full[i].albedo[c] - guide[i].albedo[c]);
    }
    // Focal blur takes as many rays as its colour needs, and a pigment needs other numbers.
    EXPECT_LE(off / static_cast<double>(3 * full.size()), is("focal_blur") ? .01 : 0.0);
}

/// On a matt white surface all the light is illumination, whatever pattern is on it.
TEST(SampleParts, IlluminationDoesNotSeeThePigment) {
    if (real_tracer().empty()) GTEST_SKIP() << "no tracer: POVPREVIEW_TRACER is not set";
    const WorkFolder folder;
    const auto scene = [&folder](const char* name, const std::string& pigment) {
        return std::vector<std::string>{
            folder.write(name,
                         "#version 3.7; global_settings { assumed_gamma 1 }\n"
                         "camera { location <0, 2, -5> look_at 0 }\n"
                         "light_source { <3, 6, -3>, <1, .8, .6> }\n"
                         "plane { y, -1 pigment { " +
                             pigment +
                             " } }\n"
                             "sphere { 0, 1 pigment { " +
                             pigment + " } }\n"),
            "+W64", "+H48"};
    };
    const auto white =
        trace_pixels(scene("white.pov", "rgb 1"), RayKind::full, everything, 8).samples;
    const auto checker =
        trace_pixels(scene("checker.pov", "checker rgb 0 rgb <.1, .5, 1> scale .3"), RayKind::full,
                     everything, 9)
            .samples;
    for (std::size_t i = 0; i < white.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            ASSERT_NEAR(white[i].illumination[c], checker[i].illumination[c], 1e-6);
            ASSERT_NEAR(checker[i].remainder[c], 0, 1e-6);
        }
}

/// Two matt things on a floor before a mirror, seen through fog.
std::string before_mirror(const std::string& pigment, const std::string& mirror) {
    return "#version 3.7; global_settings { assumed_gamma 1 }\n"
           "camera { location <0, 2, -5> look_at 0 }\n"
           "light_source { <3, 6, -3>, <1, .8, .6> } fog { distance 30 rgb .3 }\n"
           "plane { y, -1 pigment { " +
           pigment + " } }\nsphere { <1, 0, 0>, .8 pigment { " + pigment +
           " } }\nbox { <-4, -1, 2>, <4, 3, 2.1> " + mirror + " rotate 20*y }\n";
}

/// In a mirror of one colour illumination is what would be reflected of white things.
TEST(SampleParts, MirrorsTellOfWhatTheyShow) {
    if (real_tracer().empty()) GTEST_SKIP() << "no tracer: POVPREVIEW_TRACER is not set";
    const WorkFolder folder;
    const auto trace = [&](const char* name, const std::string& pigment, const char* mirror) {
        return trace_pixels({folder.write(name, before_mirror(pigment, mirror)), "+W64", "+H48"},
                            RayKind::full, everything, 10)
            .samples;
    };
    for (const char* mirror :
         {"pigment { rgb .2 } finish { reflection rgb <.9, .5, .3> }",
          "pigment { rgb <.8, .5, .2> } finish { reflection { .6 metallic } specular .4 }",
          "texture { pigment { rgb .1 } finish { reflection { .2, .5 } } }"
          "texture { pigment { rgbt <1, 0, 0, .8> } finish { reflection .2 } }"}) {
        SCOPED_TRACE(mirror);
        const auto black = trace("black.pov", "rgb 0", mirror);
        const auto white = trace("white.pov", "rgb 1", mirror);
        const auto checker =
            trace("checker.pov", "checker rgb <.1, .5, 1> rgb <.6, 0, .3> scale .3", mirror);
        std::size_t mirrored = 0;
        for (std::size_t i = 0; i < white.size(); ++i) {
            mirrored += white[i].reflected_surface + 1 > 1;
            for (int c = 0; c < 3; ++c) {
                ASSERT_NEAR(white[i].illumination[c], checker[i].illumination[c], 1e-5);
                ASSERT_NEAR(white[i].remainder[c], black[i].colour[c], 1e-5);
                ASSERT_NEAR(checker[i].remainder[c], black[i].colour[c], 1e-5);
            }
        }
        EXPECT_GT(mirrored, white.size() / 5);
    }
}

/// What a mirror makes of light that is no factor is no illumination.
TEST(SampleParts, OtherMirrorsTellOfThemselves) {
    if (real_tracer().empty()) GTEST_SKIP() << "no tracer: POVPREVIEW_TRACER is not set";
    const WorkFolder folder;
    const auto trace = [&](const char* mirror) {
        return trace_pixels(
                   {folder.write("scene.pov", before_mirror("rgb 1", mirror)), "+W64", "+H48"},
                   RayKind::full, everything, 10)
            .samples;
    };
    for (const Sample& sample :
         trace("pigment { rgb .2 } finish { reflection .5 reflection_exponent 2 }"))
        if (sample.reflected_surface != Sample::no_reflection) {
            ASSERT_EQ(sample.illumination, glm::vec3(0));
        }
    for (const char* own : {"pigment { rgb .25 } finish { reflection .1 }",
                            "pigment { rgb .25 } finish { reflection .5 } normal { bumps .1 }",
                            "pigment { checker rgb .25 rgb .25 } finish { reflection .5 }",
                            "texture { checker texture { pigment { rgb .25 } finish { reflection "
                            ".5 } } texture { pigment { rgb .25 } finish { reflection .5 } } }"}) {
        SCOPED_TRACE(own);
        std::size_t mirrored = 0;
        for (const Sample& sample : trace(own)) {
            if (sample.reflected_surface == Sample::no_reflection) continue;
            ++mirrored;
            ASSERT_EQ(sample.albedo, glm::vec3(.25f));
        }
        EXPECT_GT(mirrored, 500u);
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, SamplePartsTest, testing::ValuesIn(all_scenes()),
                         [](const auto& scene) { return scene.param.name; });

}  // namespace
}  // namespace povpreview
