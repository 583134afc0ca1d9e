// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/sample_memory.h"

#include <gtest/gtest.h>

#include "core/mesh_previewer.h"
#include "core/session.h"
#include "tests/core/function_oracle.h"

namespace povpreview {
namespace {

using namespace std::chrono_literals;

constexpr int width = 96, height = 72;
constexpr Parts everything = Parts::surface | Parts::shading | Parts::signature;

/// Runs a mesh preview over a memory until it is complete, or has so many full samples.
struct MeshRun {
    explicit MeshRun(std::uint32_t grouping_seed)
        : oracle(images::still_life(width, height), grouping_seed),
          memory(oracle, width, height),
          session(previewer, memory) {
        memory.tell([this](const Sample& s) { told.push_back(s); });
    }
    void go(std::size_t full = SIZE_MAX) {
        session.limit_full(full);
        while (session.advance(0ms)) {
        }
    }
    FunctionOracle oracle;
    SampleMemory memory;
    MeshPreviewer previewer{width, height};
    Session session;
    std::vector<Sample> told;
};

TEST(SampleMemory, AnswersInTheOrderOfTheRequestsWhateverIsRemembered) {
    const FunctionImage image = images::disc({30, 40}, 20);
    for (std::uint32_t seed = 1; seed <= 20; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        std::mt19937 random(seed);
        FunctionOracle oracle(image, seed);
        SampleMemory memory(oracle, width, height);
        std::vector<Request> requests;
        std::size_t remembered = 0;
        for (int i = 0; i < 500; ++i) {
            const auto kind = static_cast<RayKind>(random() % 3);
            requests.push_back({{i % width + .5, random() % height + .25}, kind});
            if (random() % 2) continue;
            memory.recall(image.sample(requests.back()));
            ++remembered;
        }
        std::vector<Sample> answers;
        for (std::size_t i = 0; i < requests.size();) {
            const std::size_t n = std::min<std::size_t>(1 + random() % 60, requests.size() - i);
            memory.submit(std::span(requests).subspan(i, n), everything);
            memory.collect(answers, 0ms);
            i += n;
        }
        for (int i = 0; i < 10000 && answers.size() < requests.size(); ++i)
            memory.collect(answers, 0ms);
        ASSERT_EQ(answers.size(), requests.size());
        for (std::size_t i = 0; i < answers.size(); ++i) {
            EXPECT_EQ(answers[i].position, requests[i].position);
            EXPECT_EQ(answers[i].kind, requests[i].kind);
            EXPECT_EQ(answers[i].colour, image.sample(requests[i]).colour);
        }
        // Some positions come up twice, and are then remembered twice.
        EXPECT_GE(memory.recalled(), remembered);
        EXPECT_EQ(oracle.asked.size() + memory.recalled(), requests.size());
    }
}

TEST(SampleMemory, GivesTheWantedPartsAndAsksAnewForThoseItHasNot) {
    FunctionOracle oracle(images::disc({30, 40}, 20));
    SampleMemory memory(oracle, width, height);
    const Request request{{30.5, 40.5}, RayKind::full};
    const Sample whole = images::disc({30, 40}, 20).sample(request);
    memory.recall(with_parts(whole, Parts::surface));
    const auto answer = [&](Parts parts) {
        std::vector<Sample> samples;
        memory.submit({&request, 1}, parts);
        memory.collect(samples, 0ms);
        EXPECT_EQ(samples.size(), 1U);
        return samples.at(0);
    };
    EXPECT_EQ(answer(Parts::colour).colour, whole.colour);
    EXPECT_EQ(answer(Parts::colour).surface, 0U);
    EXPECT_EQ(answer(Parts::surface).surface, whole.surface);
    EXPECT_TRUE(oracle.asked.empty());
    EXPECT_EQ(answer(Parts::shading).illumination, whole.illumination);
    EXPECT_EQ(oracle.asked.size(), 1U);
    // More parts of a sample take the place of fewer, never the other way.
    memory.recall(whole);
    memory.recall(with_parts(whole, Parts::surface));
    EXPECT_EQ(answer(everything).illumination, whole.illumination);
    EXPECT_EQ(oracle.asked.size(), 1U);
}

TEST(SampleMemory, SamplesBelowTheTargetAreNeitherKeptNorTold) {
    FunctionImage image = images::disc({30, 40}, 20);
    image.lower = {{[](glm::dvec2) { return glm::vec3(.25f); }, 0}};
    FunctionOracle oracle(image);
    SampleMemory memory(oracle, width, height);
    std::vector<Sample> told;
    memory.tell([&](const Sample& s) { told.push_back(s); });
    const Request low{{30.5, 40.5}, RayKind::full, 0}, target{low.position, RayKind::full};
    std::vector<Sample> samples;
    const auto ask = [&](const Request& request) {
        memory.submit({&request, 1}, everything);
        memory.collect(samples, 0ms);
        return samples.back().colour;
    };
    const std::size_t pixel = 40 * width + 30;
    EXPECT_EQ(ask(low), glm::vec3(.25f));
    EXPECT_FALSE(memory.pixels()[pixel].known);
    EXPECT_TRUE(told.empty());
    EXPECT_EQ(ask(target), image.colour(target.position));
    ASSERT_EQ(told.size(), 1U);
    memory.recall(told[0]);
    EXPECT_EQ(ask(low), glm::vec3(.25f));  // what is known of the target is no answer to it
    EXPECT_EQ(memory.pixels()[pixel].colour, image.colour(target.position));
    EXPECT_EQ(ask(target), image.colour(target.position));
    EXPECT_EQ(memory.recalled(), 1U);
    EXPECT_EQ(told.size(), 1U);
}

TEST(SampleMemory, ARunThatIsGoneOnWithEndsAsIfItHadNeverStopped) {
    MeshRun whole(3);
    whole.go();
    ASSERT_TRUE(whole.previewer.done());
    for (const std::size_t stop : {1U, 100U, 700U, 3000U, 6900U}) {
        SCOPED_TRACE(testing::Message() << "stopped after " << stop);
        MeshRun first(5), second(7);
        first.go(stop);
        for (const Sample& sample : first.told) second.memory.recall(sample);
        second.go();
        EXPECT_TRUE(second.previewer.done());
        EXPECT_EQ(second.memory.recalled(), first.told.size());
        EXPECT_EQ(first.oracle.asked.size() + second.oracle.asked.size(),
                  whole.oracle.asked.size());
        EXPECT_EQ(second.previewer.picture(Overlay::none).pixels,
                  whole.previewer.picture(Overlay::none).pixels);
    }
}

TEST(SampleMemory, KnowsWhatAllPixelsAreMadeOf) {
    FunctionImage image = images::still_life(width, height);
    const glm::dvec2 broken(20.5, 30.5);
    image.fails = [=](glm::dvec2 p) { return p == broken; };
    FunctionOracle oracle(image);
    SampleMemory memory(oracle, width, height);
    MeshPreviewer previewer(width, height);
    Session session(previewer, memory);
    while (session.advance(0ms)) {
    }
    ASSERT_EQ(memory.pixels().size(), std::size_t{width} * height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const PixelLight& pixel = memory.pixels()[std::size_t(y * width + x)];
            const glm::dvec2 centre(x + .5, y + .5);
            ASSERT_EQ(pixel.known, centre != broken) << x << ", " << y;
            if (!pixel.known) continue;
            ASSERT_EQ(pixel.colour, image.colour(centre)) << x << ", " << y;
        }
}

}  // namespace
}  // namespace povpreview
