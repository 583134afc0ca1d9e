// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/program/options.h"

#include <gtest/gtest.h>

#include "core/error.h"

namespace povpreview {
namespace {

CommandLine read(std::vector<const char*> words) {
    words.insert(words.begin(), "povpreview");
    return read_command_line(static_cast<int>(words.size()), words.data());
}

TEST(CommandLine, LeavesPovrayItsOwn) {
    const auto line = read({"+W320", "-A", "Declare=x=1", "--time", "2.5", "scene.pov",
                            "quality.ini[low]", "--headless"});
    ASSERT_TRUE(line.preview);
    EXPECT_EQ(line.preview->povray, (std::vector<std::string>{"+W320", "-A", "Declare=x=1",
                                                              "scene.pov", "quality.ini[low]"}));
    EXPECT_EQ(line.preview->time, 2.5);
    EXPECT_TRUE(line.preview->headless);
}

TEST(CommandLine, AcceptsBothWaysToGiveAValue) {
    EXPECT_EQ(read({"s.pov", "--samples=12"}).preview->samples, 12u);
    EXPECT_EQ(read({"s.pov", "--samples", "12"}).preview->samples, 12u);
    EXPECT_EQ(read({"s.pov", "--size", "640x480"}).preview->size, glm::ivec2(640, 480));
}

TEST(CommandLine, AccuracyIsTheScenesToUnderstand) {
    EXPECT_EQ(read({"s.pov"}).preview->accuracy, "");
    EXPECT_EQ(read({"s.pov", "--accuracy", "sketch"}).preview->accuracy, "sketch");
    EXPECT_EQ(read({"compare", "s.pov", "--out", "d", "--accuracy=1"}).compare->accuracy, "1");
}

TEST(CommandLine, CompareTakesAListOfMethods) {
    const auto line = read({"compare", "s.pov", "--out", "d", "--methods", "mesh,blocks"});
    ASSERT_TRUE(line.compare);
    EXPECT_EQ(line.compare->methods, (std::vector<std::string>{"mesh", "blocks"}));
    EXPECT_EQ(line.compare->povray, std::vector<std::string>{"s.pov"});
    EXPECT_EQ(read({"compare", "s.pov", "--out", "d"}).compare->methods.size(), 6u);
    EXPECT_EQ(read({"compare", "s.pov", "--out", "d"}).compare->repeat, 1);
    EXPECT_EQ(read({"compare", "s.pov", "--out", "d", "--repeat", "3"}).compare->repeat, 3);
    EXPECT_EQ(read({"compare", "s.pov", "--out", "d", "--threads", "2"}).compare->threads, 2);
}

TEST(CommandLine, FiguresTakeTheirOwnOptions) {
    const auto line = read(
        {"figures", "+W320", "s.pov", "--out", "d", "--samples", "500", "--mirror-depth", "3"});
    ASSERT_TRUE(line.figures);
    EXPECT_FALSE(line.preview || line.compare);
    EXPECT_EQ(line.figures->povray, (std::vector<std::string>{"+W320", "s.pov"}));
    EXPECT_EQ(line.figures->out, "d");
    EXPECT_EQ(line.figures->samples, 500u);
    EXPECT_EQ(line.figures->mirror_depth, 3);
    EXPECT_FALSE(read({"figures", "s.pov", "--out", "d"}).figures->samples);
}

TEST(CommandLine, ReferenceTakesManyScenes) {
    const auto line = read({"reference", "+W320", "a.pov", "b.pov", "--out", "d", "--engine",
                            "tracer", "--format", "exr", "--jobs", "3", "--share", "2/5"});
    ASSERT_TRUE(line.reference);
    EXPECT_EQ(line.reference->povray, (std::vector<std::string>{"+W320", "a.pov", "b.pov"}));
    EXPECT_EQ(line.reference->engine, Engine::tracer);
    EXPECT_EQ(line.reference->format, FileFormat::exr_half);
    EXPECT_EQ(line.reference->jobs, 3);
    EXPECT_EQ(line.reference->share.index, 2U);
    EXPECT_EQ(line.reference->share.count, 5U);
    EXPECT_FALSE(line.reference->slurm);
}

class BadCommandLine : public ::testing::TestWithParam<std::vector<const char*>> {};

TEST_P(BadCommandLine, IsOneLineAndExitCodeTwo) {
    try {
        read(GetParam());
        FAIL() << "was accepted";
    } catch (const Error& error) {
        EXPECT_EQ(error.exit(), Exit::usage);
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    }
}

INSTANTIATE_TEST_SUITE_P(
    All, BadCommandLine,
    ::testing::Values(
        std::vector<const char*>{"reference", "s.pov"},
        std::vector<const char*>{"reference", "s.pov", "--out", "d", "--engine", "magic"},
        std::vector<const char*>{"reference", "s.pov", "--out", "d", "--format", "gif"},
        std::vector<const char*>{"reference", "s.pov", "--out", "d", "--jobs", "0"},
        std::vector<const char*>{"reference", "s.pov", "--out", "d", "--timeout", "0"},
        std::vector<const char*>{"reference", "s.pov", "--out", "d", "--share", "2/2"},
        std::vector<const char*>{"reference", "s.pov", "--out", "d", "--share", "0/-1"},
        std::vector<const char*>{"reference", "s.pov", "--out", "d", "--share", "1"},
        std::vector<const char*>{"s.pov", "--nonsense"},
        std::vector<const char*>{"s.pov", "--time"},
        std::vector<const char*>{"s.pov", "--time", "-1"},
        std::vector<const char*>{"s.pov", "--time", "soon"},
        std::vector<const char*>{"s.pov", "--samples", "0"},
        std::vector<const char*>{"s.pov", "--samples", "-5"},
        std::vector<const char*>{"s.pov", "--method", "magic"},
        std::vector<const char*>{"s.pov", "--beside", "magic"},
        std::vector<const char*>{"s.pov", "--overlay", "magic"},
        std::vector<const char*>{"s.pov", "--backend", "magic"},
        std::vector<const char*>{"s.pov", "--size", "0x5"},
        std::vector<const char*>{"s.pov", "--size", "-3x5"},
        std::vector<const char*>{"s.pov", "--size", "1000000000x1000000000"},
        std::vector<const char*>{"s.pov", "--size", "65535x65535"},
        std::vector<const char*>{"s.pov", "--size", "big"},
        std::vector<const char*>{"compare", "s.pov"}, std::vector<const char*>{"figures", "s.pov"},
        std::vector<const char*>{"figures", "s.pov", "--out", "d", "--samples", "0"},
        std::vector<const char*>{"figures", "s.pov", "--out", "d", "--mirror-depth", "-1"},
        std::vector<const char*>{"figures", "s.pov", "--out", "d", "--time", "1"},
        std::vector<const char*>{"compare", "s.pov", "--out", "d", "--repeat", "0"},
        std::vector<const char*>{"compare", "s.pov", "--out", "d", "--threads", "0"},
        std::vector<const char*>{"s.pov", "--repeat", "2"},
        std::vector<const char*>{"compare", "s.pov", "--out", "d", "--methods", "x"}));

}  // namespace
}  // namespace povpreview
