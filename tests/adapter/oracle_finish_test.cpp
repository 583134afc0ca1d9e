// SPDX-License-Identifier: AGPL-3.0-or-later
//
// The end of a session: the picture goes to the tracer and comes back as an image file.
#include <fstream>
#include <sstream>

#include "tests/adapter/oracle_fixture.h"

namespace povpreview {
namespace {

namespace fs = std::filesystem;

class OracleFinishTest : public OracleTest {
   protected:
    void SetUp() override {
        OracleTest::SetUp();
        std::string name = (fs::temp_directory_path() / "finish-test-XXXXXX").string();
        ASSERT_NE(mkdtemp(name.data()), nullptr);
        folder_ = name;
        for (int i = 0; i < fake::width * fake::height; ++i)
            pixels_.push_back({{i / 4.F, 1, 2}, i % 2 ? .5F : 0.F, i % 10 != 3});
    }
    void TearDown() override {
        std::error_code ignored;
        fs::remove_all(folder_, ignored);
        OracleTest::TearDown();
    }
    PovrayOracle::Settings settings(std::vector<std::string> arguments,
                                    std::chrono::milliseconds stall_timeout = 60s) const {
        PovrayOracle::Settings result = fake_tracer(std::move(arguments), stall_timeout);
        result.finish_folder = folder_;
        return result;
    }
    /// Finishes, and expects every pixel in the file.
    void expect_image(PovrayOracle& oracle) const {
        std::size_t steps = 0;
        const fs::path image = oracle.finish(
            pixels_,
            [&](const report::Progress& p) { steps += p.stage == report::Stage::finishing; },
            nullptr);
        EXPECT_GE(steps, 3U);
        std::ifstream file(image);
        for (const PixelLight& pixel : pixels_) {
            bool known = false;
            std::string red;
            float transmittance = -1;
            ASSERT_TRUE(file >> known >> red >> transmittance);
            ASSERT_EQ(known, pixel.known);
            if (known) {
                ASSERT_EQ(std::stof(red), pixel.colour.x);
            }
            ASSERT_EQ(transmittance, pixel.transmittance);
        }
    }
    std::string error_of_finish(const PovrayOracle::Settings& settings, Exit exit,
                                const std::function<bool()>& interrupted = nullptr) const {
        PovrayOracle oracle(settings);
        oracle.wait_for_scene(nullptr, nullptr);
        try {
            oracle.finish(pixels_, nullptr, interrupted);
        } catch (const Error& error) {
            EXPECT_EQ(error.exit(), exit);
            return error.what();
        }
        ADD_FAILURE() << "an image came";
        return "";
    }

    fs::path folder_;
    std::vector<PixelLight> pixels_;
};

TEST_F(OracleFinishTest, AllPixelsReachTheTracer) {
    PovrayOracle oracle(settings({}));
    EXPECT_EQ(oracle.wait_for_scene(nullptr, nullptr).output, "out.png");
    trace(oracle, all_pixels(), Parts::colour);
    expect_image(oracle);
    EXPECT_EQ(oracle.statistics().restarts, 0U);
}

TEST_F(OracleFinishTest, ATracerThatDiesMeanwhileIsStartedAgainOnce) {
    const std::string lived = fresh_file();
    PovrayOracle oracle(settings({"finish=die", "once=" + lived}));
    oracle.wait_for_scene(nullptr, nullptr);
    expect_image(oracle);
    EXPECT_EQ(oracle.statistics().restarts, 1U);
    EXPECT_FALSE(oracle.faults().empty());
    fs::remove(lived);
}

TEST_F(OracleFinishTest, WhatCannotBeMendedIsOneError) {
    EXPECT_NE(error_of_finish(settings({"finish=die"}), Exit::tracer).find("signal 9"),
              std::string::npos);
    EXPECT_NE(error_of_finish(settings({"finish=nothing"}), Exit::tracer).find("image"),
              std::string::npos);
    EXPECT_NE(error_of_finish(settings({"finish=failure"}), Exit::tracer).find("Out of memory"),
              std::string::npos);
    EXPECT_NE(error_of_finish(settings({"finish=hang"}, 300ms), Exit::tracer).find("image"),
              std::string::npos);
    EXPECT_NE(error_of_finish(settings({"finish=hang"}), Exit::interrupted, [] { return true; })
                  .find("interrupted"),
              std::string::npos);
}

}  // namespace
}  // namespace povpreview
