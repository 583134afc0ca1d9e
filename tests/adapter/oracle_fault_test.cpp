// SPDX-License-Identifier: AGPL-3.0-or-later
//
// The oracle over tracers that go wrong: in the end the right samples, or the one right Error.
#include <signal.h>

#include <fstream>
#include <thread>

#include "tests/adapter/oracle_fixture.h"

namespace povpreview {
namespace {

constexpr Parts parts = Parts::surface | Parts::signature;

/// Traces all pixels twice over this tracer and expects them right.
void expect_mended(PovrayOracle& oracle) {
    expect_right(trace(oracle, all_pixels(), parts), all_pixels(), parts);
    expect_right(trace(oracle, all_pixels(RayKind::probe), parts), all_pixels(RayKind::probe),
                 parts);
}

bool contains_text(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}
#define EXPECT_TEXT(text, part) EXPECT_TRUE(contains_text(text, part)) << text

/// A tracer whose lives have these arguments in turn, and the last ones from then on: `script` is
/// made for it, and `lived` counts them.
PovrayOracle::Settings lives(const std::string& script, const std::string& lived,
                             const std::vector<std::string>& arguments) {
    std::ofstream text(script);
    text << "#!/bin/sh\necho >>" << lived << "\ncase $(wc -l <" << lived << ") in\n";
    for (std::size_t i = 0; i < arguments.size(); ++i)
        text << (i + 1 < arguments.size() ? std::to_string(i + 1) : "*")
             << ") exec " FAKE_TRACER " " << arguments[i] << " ;;\n";
    text << "esac\n";
    std::filesystem::permissions(script, std::filesystem::perms::owner_all);
    PovrayOracle::Settings settings = fake_tracer({});
    settings.program = script;
    return settings;
}

// ---- mended

TEST_F(OracleTest, ADeathIsMendedOnce) {
    PovrayOracle oracle(fake_tracer({"die_after=1000", "once=" + fresh_file(), "shuffle"}));
    expect_mended(oracle);
    EXPECT_EQ(oracle.statistics().restarts, 1U);
    EXPECT_EQ(oracle.statistics().failed, 0U);
    ASSERT_EQ(oracle.faults().size(), 1U);
    EXPECT_TEXT(oracle.faults()[0], "signal 9");
}

TEST_F(OracleTest, EveryLifeIsUsed) {
    PovrayOracle oracle(fake_tracer({"die_after=1000"}));
    expect_mended(oracle);
    EXPECT_GE(oracle.statistics().restarts, 5U);
    EXPECT_EQ(oracle.statistics().failed, 0U);
    // What had been answered was not traced again.
    EXPECT_EQ(oracle.statistics().of(RayKind::full), all_pixels().size());
}

TEST_F(OracleTest, ATracerThatLeavesOrBreaksOffIsStartedAgain) {
    for (const char* fault : {"fault=silent_exit", "fault=half"}) {
        SCOPED_TRACE(fault);
        PovrayOracle oracle(fake_tracer({"die_after=500", fault, "once=" + fresh_file()}));
        expect_mended(oracle);
        EXPECT_EQ(oracle.statistics().restarts, 1U);
        EXPECT_EQ(contains_text(oracle.faults().at(0), "in the middle of a message"),
                  std::string(fault) == "fault=half");
    }
}

TEST_F(OracleTest, ADeathWhileASceneIsReadAgainIsMended) {
    PovrayOracle oracle(lives(fresh_file(), fresh_file(), {"die_after=1000", "parse=kill", ""}));
    expect_mended(oracle);
    EXPECT_EQ(oracle.statistics().restarts, 2U);
    EXPECT_EQ(oracle.statistics().failed, 0U);
    EXPECT_TEXT(oracle.faults().at(1), "before the scene was ready");
}

TEST_F(OracleTest, ASceneThatCannotBeReadAgainIsGivenUp) {
    const auto killed = lives(fresh_file(), fresh_file(), {"die_after=1000", "parse=kill"});
    EXPECT_TEXT(error_of(killed, Exit::tracer), "in a row without an answer");
    const auto refused = lives(fresh_file(), fresh_file(), {"die_after=1000", "parse=refuse"});
    EXPECT_TEXT(error_of(refused, Exit::scene), "Failed to parse command-line option");
}

TEST_F(OracleTest, ASampleThatKillsIsLeftOutAlone) {
    PovrayOracle oracle(fake_tracer({"die_at=30,17"}));
    expect_right(trace(oracle, all_pixels(), parts), all_pixels(), parts,
                 [](const Sample& s) { return s.position == glm::dvec2(30.5, 17.5); });
    EXPECT_EQ(oracle.statistics().failed, 1U);
    EXPECT_LE(oracle.statistics().restarts, 6U);
    EXPECT_TEXT(oracle.faults().back(), "(30.5, 17.5) kills the tracer");
    // And the tracer is of use again, at full speed.
    std::vector<Request> others = all_pixels();
    std::erase_if(others, [](const Request& r) { return r.position == glm::dvec2(30.5, 17.5); });
    const unsigned before = oracle.statistics().restarts;
    expect_right(trace(oracle, others, parts), others, parts);
    EXPECT_EQ(oracle.statistics().restarts, before);
}

TEST_F(OracleTest, ASampleThatKillsAloneIsLeftOut) {
    PovrayOracle oracle(fake_tracer({"die_at=1,1"}));
    const std::vector<Request> one{{{1.5, 1.5}, RayKind::full}};
    expect_right(trace(oracle, one, parts), one, parts, [](const Sample&) { return true; });
    expect_right(trace(oracle, one, parts), one, parts, [](const Sample&) { return true; });
}

TEST_F(OracleTest, DeathFromOutsideWhileIdle) {
    PovrayOracle oracle(fake_tracer({"die_after=3072", "fault=silent_exit"}));
    expect_right(trace(oracle, all_pixels(), parts), all_pixels(), parts);
    expect_right(trace(oracle, all_pixels(), parts), all_pixels(), parts);
}

TEST_F(OracleTest, ManyMessagesDoNotBlockTheTracer) {
    PovrayOracle oracle(fake_tracer({"chatty"}));
    oracle.wait_for_scene(nullptr, nullptr);
    expect_mended(oracle);
}

// ---- not mended

TEST_F(OracleTest, ATracerThatAlwaysDiesIsGivenUp) {
    const std::string text = error_of(fake_tracer({"die_after=0"}), Exit::tracer);
    EXPECT_TEXT(text, "in a row without an answer");
    EXPECT_TEXT(text, "signal 9");
}

TEST_F(OracleTest, ASceneErrorIsPassedOn) {
    const std::string text = error_of(fake_tracer({"parse=error"}), Exit::scene);
    EXPECT_EQ(text, "File 'x.pov' line 7: Parse Error: Expected 'object', sphere found");
}

TEST_F(OracleTest, DeathWhileParsing) {
    EXPECT_TEXT(error_of(fake_tracer({"parse=exit"}), Exit::tracer), "exited with status 5");
    EXPECT_TEXT(error_of(fake_tracer({"parse=kill"}), Exit::tracer), "signal 9");
    const std::string text = error_of(fake_tracer({"parse=refuse"}), Exit::scene);
    EXPECT_TEXT(text, "Failed to parse command-line option");
}

TEST_F(OracleTest, FatalErrorWhileTracing) {
    const std::string text =
        error_of(fake_tracer({"die_after=500", "fault=failure"}), Exit::tracer);
    EXPECT_TEXT(text, "Out of memory");
}

TEST_F(OracleTest, AStallIsReportedWithTheOptionThatAllowsIt) {
    for (const char* fault : {"fault=stall", "fault=stop"}) {
        SCOPED_TRACE(fault);
        const std::string text =
            error_of(fake_tracer({"die_after=500", fault}, 500ms), Exit::tracer);
        EXPECT_TEXT(text, "said nothing");
        EXPECT_TEXT(text, "--stall-timeout");
    }
}

TEST_F(OracleTest, SlownessIsNoStall) {
    PovrayOracle oracle(fake_tracer({"delay_us=100000", "slice=1000"}, 400ms));
    expect_right(trace(oracle, all_pixels(), parts), all_pixels(), parts);
}

TEST_F(OracleTest, OurOwnAbsenceIsNoStall) {
    PovrayOracle oracle(fake_tracer({"delay_us=1000"}, 1500ms));
    oracle.wait_for_scene(nullptr, nullptr);
    oracle.submit(all_pixels(), parts);
    std::this_thread::sleep_for(2s);
    std::vector<Sample> samples;
    while (samples.size() < all_pixels().size()) oracle.collect(samples, 10ms);
    expect_right(samples, all_pixels(), parts);
}

struct Lie {
    const char* argument;
    const char* message;
};

class LyingTracer : public OracleTest, public testing::WithParamInterface<Lie> {};

TEST_P(LyingTracer, IsEndedAndNamed) {
    const std::string text =
        error_of(fake_tracer({"die_after=500", GetParam().argument}), Exit::tracer);
    EXPECT_TEXT(text, std::string("the tracer sent ") + GetParam().message);
    EXPECT_TEXT(text, "build the tracer");
}

INSTANTIATE_TEST_SUITE_P(
    Lies, LyingTracer,
    testing::Values(Lie{"fault=garbage", "bytes that are no report"},
                    Lie{"fault=huge", "a message of 2139062143 bytes"},
                    Lie{"fault=batch", "an answer to batch 1001, which is not outstanding"},
                    Lie{"fault=count", "16 colours in an answer of 17"},
                    Lie{"fault=twice", "the answer to sample 496 of batch 1 twice"},
                    Lie{"fault=missing", "an answer without colours"},
                    Lie{"fault=outside", "an answer for samples 60000 to 60016 of a batch of 3072"},
                    Lie{"fault=scene_again", "a second scene"},
                    Lie{"fault=hello_again", "its greeting again"},
                    Lie{"parse=bad_version", "a greeting in version 99"},
                    Lie{"parse=no_hello", "another message before its greeting"},
                    Lie{"parse=bad_size", "an image size of 0 x 48"}),
    [](const auto& lie) {
        std::string name = lie.param.argument;
        std::erase_if(name, [](char c) { return !std::isalnum(c); });
        return name;
    });

TEST_F(OracleTest, TheSceneChangesItsSizeBetweenTwoLives) {
    const auto settings = lives(fresh_file(), fresh_file(), {"die_after=100", "parse=tiny"});
    EXPECT_TEXT(error_of(settings, Exit::scene), "another image size");
}

TEST_F(OracleTest, AMissingOrUnfitProgram) {
    for (const char* program : {"/nonexistent/tracer", "/etc/passwd", "no-such-tracer-in-path"}) {
        PovrayOracle::Settings settings = fake_tracer({});
        settings.program = program;
        try {
            PovrayOracle oracle(settings);
            ADD_FAILURE() << program << " was started";
        } catch (const Error& error) {
            EXPECT_EQ(error.exit(), Exit::usage);
            EXPECT_TEXT(error.what(), program);
        }
    }
}

TEST_F(OracleTest, InterruptedWhileParsing) {
    PovrayOracle oracle(fake_tracer({"parse=hang"}));
    const auto start = std::chrono::steady_clock::now();
    try {
        oracle.wait_for_scene(nullptr,
                              [&] { return std::chrono::steady_clock::now() > start + 300ms; });
        ADD_FAILURE() << "a scene came";
    } catch (const Error& error) {
        EXPECT_EQ(error.exit(), Exit::interrupted);
    }
    EXPECT_LT(std::chrono::steady_clock::now() - start, 3s);
}

TEST_F(OracleTest, AStubbornTracerIsEndedInTime) {
    const auto start = std::chrono::steady_clock::now();
    {
        PovrayOracle oracle(fake_tracer({"stubborn"}));
        oracle.wait_for_scene(nullptr, nullptr);
    }
    EXPECT_LT(std::chrono::steady_clock::now() - start, 3s);
}

}  // namespace
}  // namespace povpreview
