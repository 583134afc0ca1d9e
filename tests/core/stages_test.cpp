// SPDX-License-Identifier: AGPL-3.0-or-later
//
// What a preview does for a scene follows from what its rays cost, and the account of it is right.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/mesh_previewer.h"
#include "core/session.h"
#include "tests/core/function_oracle.h"

namespace povpreview {
namespace {

using namespace std::chrono_literals;

constexpr int width = 160, height = 120;

/// A disc on a ground, at the price given.
FunctionImage disc(std::uint32_t full_ns, std::uint32_t albedo_ns) {
    FunctionImage image;
    const auto inside = [](glm::dvec2 p) { return std::hypot(p.x - 80, p.y - 60) < 40; };
    image.colour = [=](glm::dvec2 p) { return inside(p) ? glm::vec3(.9f) : glm::vec3(.1f); };
    image.surface = [=](glm::dvec2 p) { return inside(p) ? 2u : 1u; };
    image.full_ns = full_ns;
    image.albedo_ns = albedo_ns;
    return image;
}

Stage named(const std::vector<Stage>& stages, const std::string& name) {
    return *std::find_if(stages.begin(), stages.end(),
                         [&](const Stage& stage) { return stage.name == name; });
}

struct WholeRun {
    FunctionOracle oracle;
    MeshPreviewer previewer{width, height};
    Session session{previewer, oracle};
    explicit WholeRun(const FunctionImage& image) : oracle(image) {
        while (session.advance(0ns)) {
        }
    }
};

TEST(Stages, AreNotKnownBeforeRaysHaveAPrice) {
    EXPECT_TRUE(MeshPreviewer(width, height).stages().empty());
}

TEST(Stages, ADearSceneGetsThemAllACheapOneOnlySamples) {
    WholeRun dear(disc(1'000'000, 10'000)), cheap(disc(1'000, 900));
    for (const char* name : {"outlines by probes", "albedo rays"}) {
        EXPECT_TRUE(named(dear.previewer.stages(), name).runs) << name;
        const Stage left_out = named(cheap.previewer.stages(), name);
        EXPECT_FALSE(left_out.runs) << name;
        EXPECT_EQ(left_out.expected, 0) << name;
    }
    EXPECT_GT(named(dear.previewer.stages(), "outlines by probes").rays, 0u);
    EXPECT_EQ(named(cheap.previewer.stages(), "outlines by probes").rays, 0u);
    EXPECT_GT(*named(dear.previewer.stages(), refinement_stage_name).expected,
              *named(cheap.previewer.stages(), refinement_stage_name).expected);
}

TEST(Stages, EveryRayAndItsTimeIsSomeStages) {
    WholeRun run(disc(1'000'000, 10'000));
    const Session::Counts& counts = run.session.counts();
    std::size_t rays = 0;
    double tracer_s = 0;
    for (const Stage& stage : run.previewer.stages()) {
        rays += stage.rays;
        tracer_s += stage.tracer_s;
    }
    EXPECT_EQ(rays, counts.full + counts.probe + counts.albedo);
    EXPECT_NEAR(tracer_s, 1e-3 * double(counts.full) + 1e-5 * double(counts.albedo + counts.probe),
                1e-6);
}

TEST(Stages, OwnTimeIsCounted) {
    WholeRun run(disc(1'000'000, 10'000));
    EXPECT_GT(run.session.own_s(), 0);
}

}  // namespace
}  // namespace povpreview
