// SPDX-License-Identifier: AGPL-3.0-or-later
//
// The oracle over the patched POV-Ray itself, named by POVPREVIEW_TRACER; skipped without it.
#include <signal.h>

#include <cstdlib>
#include <fstream>
#include <thread>

#include "adapter/povray_options.h"
#include "tests/adapter/oracle_fixture.h"

namespace povpreview {
namespace {

namespace fs = std::filesystem;

constexpr Parts everything = Parts::surface | Parts::shading | Parts::signature;

/// Process ids of our children.
std::vector<pid_t> children() {
    std::vector<pid_t> result;
    for (const auto& task : fs::directory_iterator("/proc/self/task")) {
        std::ifstream file(task.path() / "children");
        for (pid_t pid = 0; file >> pid;) result.push_back(pid);
    }
    return result;
}

class RealTracerTest : public OracleTest {
   protected:
    void SetUp() override {
        OracleTest::SetUp();
        const char* tracer = std::getenv("POVPREVIEW_TRACER");
        if (!tracer) GTEST_SKIP() << "POVPREVIEW_TRACER is not set";
        tracer_ = tracer;
        scene_ = fresh_file() + ".pov";
        write_scene(
            "#version 3.7; global_settings { assumed_gamma 1 }\n"
            "camera { location <0, 1, -4> look_at 0 } light_source { <5, 9, -7>, 1 }\n"
            "plane { y, -1 pigment { checker rgb .2 rgb .9 } }\n"
            "sphere { 0, 1 pigment { rgb <1, .3, .1> } finish { reflection .3 } }\n");
    }
    void TearDown() override {
        std::error_code error;
        fs::remove(scene_, error);
        OracleTest::TearDown();
    }
    void write_scene(const std::string& text) { std::ofstream(scene_) << text; }
    PovrayOracle::Settings settings() const {
        const PovrayOptions options = read_povray_options({scene_, "+W160", "+H120"});
        return {.program = tracer_, .arguments = options.tracer_arguments(), .stall_timeout = 60s};
    }
    static std::vector<Request> requests() {
        std::vector<Request> result;
        for (int y = 0; y < 120; ++y)
            for (int x = 0; x < 160; ++x)
                result.push_back({{x + .5, y + .5}, static_cast<RayKind>((x + y) % 3)});
        return result;
    }

    std::string tracer_, scene_;
};

TEST_F(RealTracerTest, ATracerKilledAgainAndAgainGivesTheSameSamples) {
    std::vector<Sample> expected;
    {
        PovrayOracle oracle(settings());
        const SceneDescription& scene = oracle.wait_for_scene(nullptr, nullptr);
        EXPECT_EQ(scene.width, 160);
        EXPECT_EQ(scene.height, 120);
        EXPECT_EQ(scene.lights.size(), 1U);
        EXPECT_TRUE(scene.has("reflection"));
        expected = trace(oracle, requests(), everything);
    }
    PovrayOracle oracle(settings());
    oracle.wait_for_scene(nullptr, nullptr);
    std::vector<Sample> samples;
    for (std::size_t life = 1; life <= 3; ++life) {
        const std::size_t part = requests().size() / 3;
        const auto all = requests();
        oracle.submit(std::span(all).subspan((life - 1) * part, part), everything);
        for (const pid_t pid : children()) kill(pid, SIGKILL);
        while (samples.size() < life * part) oracle.collect(samples, 100ms);
    }
    EXPECT_GE(oracle.statistics().restarts, 1U);
    EXPECT_EQ(oracle.statistics().failed, 0U);
    ASSERT_EQ(samples.size(), expected.size());
    std::size_t hit = 0;
    for (std::size_t i = 0; i < samples.size() && !HasFailure(); ++i) {
        SCOPED_TRACE(testing::Message() << "sample " << i);
        samples[i].cost_ns = expected[i].cost_ns;
        expect_equal(samples[i], expected[i]);
        hit += samples[i].surface != 0;
    }
    EXPECT_GT(hit, samples.size() / 4);
}

TEST_F(RealTracerTest, ASceneErrorIsPovraysOwn) {
    write_scene("sphere { 0, 1\n pigment { rgb 1 }\n camera {");
    const std::string text = error_of(settings(), Exit::scene);
    EXPECT_EQ(text.find("File '" + scene_ + "' line 3: Parse Error: "), 0U) << text;
}

TEST_F(RealTracerTest, AnOptionThatPovrayDoesNotKnow) {
    PovrayOracle::Settings wrong = settings();
    wrong.arguments.push_back("+Zero");
    const std::string text = error_of(wrong, Exit::usage);
    EXPECT_NE(text.find("+Zero"), std::string::npos) << text;
}

TEST_F(RealTracerTest, AnEndlessParseEndsWhenInterrupted) {
    write_scene("#while (1) #declare x1 = 1; #end\n");
    const auto start = std::chrono::steady_clock::now();
    {
        PovrayOracle oracle(settings());
        try {
            oracle.wait_for_scene(nullptr,
                                  [&] { return std::chrono::steady_clock::now() > start + 600ms; });
            ADD_FAILURE() << "a scene came";
        } catch (const Error& error) {
            EXPECT_EQ(error.exit(), Exit::interrupted);
        }
    }
    EXPECT_LT(std::chrono::steady_clock::now() - start, 4s);
    EXPECT_TRUE(children().empty());
}

}  // namespace
}  // namespace povpreview
