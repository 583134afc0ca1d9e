// SPDX-License-Identifier: AGPL-3.0-or-later
//
// What flat mirrors are painted to show against what the tracer's own reflected rays meet, at every
// pixel, and which surfaces are taken for mirrors.
#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <set>

#include "adapter/geometry.h"
#include "adapter/povray_options.h"
#include "core/detail/item_painter.h"
#include "tests/end_to_end/real_tracer.h"

namespace povpreview {
namespace {

struct Painted {
    ItemBuffer items;
    std::vector<Sample> probes, albedos;  ///< at all pixel centres
};

class Mirrors : public testing::Test {
   protected:
    void SetUp() override {
        if (real_tracer().empty()) GTEST_SKIP() << "no tracer: POVPREVIEW_TRACER is not set";
    }

    Painted paint(const std::string& text) const {
        const std::string head =
            "#version 3.7; global_settings { assumed_gamma 1 }\n"
            "camera { location <1, 2.2, -7> look_at <0, .7, 0> angle 55 }\n"
            "light_source { <5, 8, -5> rgb 1 }\n"
            "#declare Mirror = texture { pigment { rgb .1 } finish { reflection .8 } }\n";
        const PovrayOptions options = read_povray_options(
            {folder_.write("scene.pov", head + text), "+W160", "+H120", "+WT2"});
        PovrayOracle oracle({.program = real_tracer(), .arguments = options.tracer_arguments()});
        const SceneDescription description = oracle.wait_for_scene(nullptr, nullptr);
        oracle.wait_for_geometry(nullptr);
        const DrawableScene scene =
            drawable_scene(oracle.take_geometry().value(), description).value();
        Painted result{paint_items(scene), {}, {}};
        result.probes = trace(oracle, description, RayKind::probe);
        result.albedos = trace(oracle, description, RayKind::albedo);
        return result;
    }
    static std::vector<Sample> trace(PovrayOracle& oracle, const SceneDescription& description,
                                     RayKind kind) {
        std::vector<Request> requests;
        for (int y = 0; y < description.height; ++y)
            for (int x = 0; x < description.width; ++x)
                requests.push_back({{x + .5, y + .5}, kind});
        oracle.submit(requests, Parts::surface);
        std::vector<Sample> samples;
        while (samples.size() < requests.size())
            oracle.collect(samples, std::chrono::milliseconds(20));
        return samples;
    }

    /// Returns how many pixels know what a mirror shows; `surfaces`: at least so many are shown.
    static std::size_t expect_agreement(const Painted& painted, std::size_t surfaces) {
        const ItemBuffer& items = painted.items;
        std::set<std::uint32_t> shown;
        std::size_t known = 0, wrong = 0;
        for (std::size_t i = 0; i < items.mirrored.size(); ++i) {
            const bool is_mirror =
                std::binary_search(items.mirrors.begin(), items.mirrors.end(), items.surfaces[i]);
            if (!is_mirror || items.mirrored[i] == ItemBuffer::unknown) continue;
            ++known;
            shown.insert(items.mirrored[i]);
            wrong += items.surfaces[i] != painted.probes[i].surface ||
                     items.mirrored[i] != painted.probes[i].reflected_surface;
        }
        EXPECT_EQ(wrong, 0u) << "of " << known;
        EXPECT_GE(shown.size(), surfaces);
        return known;
    }

   private:
    WorkFolder folder_;
};

const char* const things = R"(
sphere { <-1.2, .6, -1>, .6 pigment { rgb x } }
box { <.2, 0, -1.5>, <1, .8, -.8> pigment { rgb y } }
torus { .5, .15 rotate 70*x translate <1.6, 1.4, -.6> pigment { rgb z } }
difference { sphere { <-.3, 1.6, -1.5>, .4 } box { <-.3, 1.6, -2>, 1 } pigment { rgb 1 } }
)";

TEST_F(Mirrors, OfEveryFlatKind) {
    for (const char* mirror :
         {"plane { y, 0 texture { Mirror } }", "box { <-3, 0, .5>, <3, 3, .6> texture { Mirror } }",
          "disc { <0, 0, 0>, y, 4 texture { Mirror } }",
          "polygon { 4, <-2, 0>, <2, 0>, <2, 3>, <-2, 3> texture { Mirror } translate .5*z }",
          "mesh { triangle { <-3, 0, .5>, <3, 0, .5>, <0, 4, .5> texture { Mirror } } }",
          // Cut by something curved: a piece of a half space.
          "intersection { plane { y, 0 } sphere { 0, 3 } texture { Mirror } }",
          "object { plane { -z, 0 clipped_by { cylinder { -z, z, 2 } } texture { Mirror } }"
          " rotate 20*y translate <0, 1, .8> }"}) {
        SCOPED_TRACE(mirror);
        const Painted painted = paint(std::string(things) + mirror);
        ASSERT_FALSE(painted.items.mirrors.empty());
        EXPECT_GT(expect_agreement(painted, 4), 1000u);
    }
}

/// Of every look of mirrors and of what they show.
TEST_F(Mirrors, HaveTheAlbedoThatRaysTell) {
    const std::string patterned = R"(
sphere { <-1.2, .6, -1>, .6 pigment { checker rgb x rgb z scale .3 } }
box { <.2, 0, -1.5>, <1, .8, -.8> pigment { brick rgb y rgb .5 scale .1 } }
torus { .5, .15 rotate 70*x translate <1.6, 1.4, -.6> pigment { rgb z } }
)";
    for (const char* mirror :
         {"pigment { rgb .1 } finish { reflection .8 }",
          "pigment { rgb .3 } finish { reflection { .2, .9 metallic } }",
          "pigment { rgb .3 } finish { reflection { .3 } reflection_exponent 2 }",
          "texture { pigment { rgb 1 } } texture { pigment { rgbt .7 } finish { reflection .4 } }",
          "pigment { hexagon rgb .3 rgb .5 rgb .7 scale .2 } finish { reflection .5 }",
          "texture { checker texture { pigment { rgb .2 } finish { reflection .5 } }"
          " texture { pigment { rgb .4 } finish { reflection .5 } } scale .3 }"}) {
        SCOPED_TRACE(mirror);
        const Painted painted = paint(patterned + "plane { y, 0 " + mirror + " }");
        const ItemBuffer& items = painted.items;
        ASSERT_EQ(items.mirrors.size(), 1u);
        std::size_t known = 0, wrong = 0;
        for (std::size_t i = 0; i < items.surfaces.size(); ++i) {
            const Sample& sample = painted.albedos[i];
            if (items.surfaces[i] != items.mirrors[0] || items.kinds[i] != Look::Kind::pattern)
                continue;
            ++known;
            wrong += glm::distance(items.albedos[i], sample.albedo) > 1e-5f ||
                     (sample.reflected_surface != Sample::no_reflection &&
                      sample.reflected_surface != items.mirrored[i]);
        }
        EXPECT_GT(known, 500u);
        EXPECT_EQ(wrong, 0u) << "of " << known;
    }
}

TEST_F(Mirrors, ShowWhatTheEyeDoesNotSeeAndNotWhatIsNotReflected) {
    const Painted painted = paint(std::string(things) + R"(
plane { y, 0 texture { Mirror } }
box { <-2.6, 0, -1>, <-2, 1, 0> pigment { rgb 1 } no_image }
box { <2, 0, -1>, <2.4, 1, 0> pigment { rgb 1 } no_reflection }
sphere { <-2, 1.4, 0>, .3 pigment { rgb 1 } no_image }
sphere { <1.2, .4, .5>, .3 pigment { rgb 1 } no_reflection }
light_source { <0, 2, 1> rgb .1 looks_like { sphere { 0, .2 } } })");
    ASSERT_EQ(painted.items.mirrors.size(), 1u);
    EXPECT_GT(expect_agreement(painted, 5), 4000u);
}

TEST_F(Mirrors, AreNothingElse) {
    for (const char* other :
         {"plane { y, 0 pigment { rgb .1 } }",
          "plane { y, 0 pigment { rgb .1 } finish { reflection .05 } }",
          "plane { y, 0 texture { Mirror normal { bumps .1 } } }",
          "plane { y, 0 texture { Mirror finish { reflection { 0, .8 } } } }",
          "plane { y, 0 texture { Mirror finish { reflection { .1, .8 fresnel } } }"
          " interior { ior 1.5 } }",
          "plane { y, 0 texture { checker texture { Mirror } texture { pigment { rgb 1 } } } }",
          "sphere { 0, 2 texture { Mirror } }",
          "mesh { smooth_triangle { <-3, 0, 0>, <-.1, 1, 0>, <3, 0, 0>, <.1, 1, 0>, <0, 0, 3>,"
          " <0, 1, .1> texture { Mirror } } }"}) {
        SCOPED_TRACE(other);
        EXPECT_TRUE(paint(std::string(things) + other).items.mirrors.empty());
    }
    EXPECT_EQ(paint(std::string(things) +
                    "plane { y, 0 texture { checker texture { Mirror } texture { Mirror finish "
                    "{ reflection .4 } } } }")
                  .items.mirrors.size(),
              1u);
}

TEST_F(Mirrors, SamplesWithoutReflectionSaySo) {
    const Painted painted = paint("plane { y, 0 pigment { rgb 1 } }" + std::string(things));
    for (const Sample& probe : painted.probes)
        ASSERT_EQ(probe.reflected_surface, Sample::no_reflection);
}

}  // namespace
}  // namespace povpreview
