// SPDX-License-Identifier: AGPL-3.0-or-later
//
// The process alone: what the child has open, what it leaves behind, and that it never outlives us.
#include "adapter/tracer_process.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>

#include "tests/adapter/oracle_fixture.h"

namespace povpreview {
namespace {

class TracerProcessTest : public OracleTest {
   protected:
    /// Waits for the end of a shell script run in the tracer's place; returns what it said.
    static std::string said_by(const std::string& script) {
        TracerProcess process("sh", {"-c", script});
        std::byte buffer[64];
        while (process.receive(buffer).what != TracerProcess::Received::end)
            process.wait(100ms, false);
        process.stop();
        return process.last_words();
    }
};

TEST_F(TracerProcessTest, TheChildHasNothingOpenButItsWire) {
    const int foreign = open("/dev/null", O_RDONLY);  // as a library might, without close-on-exec
    const std::string words = said_by("(ls -l /proc/$$/fd >&2); exit 1");
    close(foreign);
    for (const char* each : {"0 -> /dev/null", "1 -> /dev/null", "2 -> pipe:[", "-> socket:["})
        EXPECT_NE(words.find(each), std::string::npos) << words;
    EXPECT_EQ(std::count(words.begin(), words.end(), '>'), 4) << words;
}

TEST_F(TracerProcessTest, TheChildFindsItsWireInTheEnvironment) {
    setenv("POVPREVIEW_WIRE", "99", 1);  // one of ours must not get through
    const std::string words = said_by("echo $(readlink /proc/$$/fd/$POVPREVIEW_WIRE) >&2");
    unsetenv("POVPREVIEW_WIRE");
    EXPECT_EQ(words.find("socket:["), 0U) << words;
}

TEST_F(TracerProcessTest, LastWordsAreTheLastLines) {
    EXPECT_EQ(said_by("seq 20000 >&2; printf 'status\\rdone\\n\\nFatal: no\\n' >&2"),
              "19997\n19998\n19999\n20000\ndone\nFatal: no");
    EXPECT_EQ(said_by("exit 3"), "");
}

TEST_F(TracerProcessTest, SaysHowItEnded) {
    TracerProcess leaves("sh", {"-c", "exit 3"}), killed("sh", {"-c", "kill -SEGV $$"}),
        stays("sh", {"-c", "sleep 60"});
    EXPECT_EQ(leaves.stop(), "exited with status 3");
    EXPECT_EQ(leaves.exit_status(), 3);
    EXPECT_NE(killed.stop().find("signal 11"), std::string::npos);
    EXPECT_EQ(killed.exit_status(), -1);
    EXPECT_NE(stays.stop().find("had to be ended"), std::string::npos);
    EXPECT_EQ(stays.stop(), stays.stop());
}

TEST_F(TracerProcessTest, WhatTheChildStartedEndsWithIt) {
    int alive[2];  // its end is held open by the grandchild as long as it lives
    ASSERT_EQ(pipe(alive), 0);
    const std::string name = "/proc/" + std::to_string(getpid()) + "/fd/";
    {
        TracerProcess process(
            "sh", {"-c", "sleep 60 > " + name + std::to_string(alive[1]) + " & echo > " + name +
                             std::to_string(alive[1]) + "; exit 0"});
        char line = 0;
        ASSERT_EQ(read(alive[0], &line, 1), 1);
    }
    close(alive[1]);
    char more = 0;
    EXPECT_EQ(read(alive[0], &more, 1), 0);  // would block if the grandchild lived
    close(alive[0]);
}

TEST_F(TracerProcessTest, DiesWithUs) {
    // We adopt what our child leaves behind, so that its end can be seen.
    ASSERT_EQ(prctl(PR_SET_CHILD_SUBREAPER, 1), 0);
    const pid_t previewer = fork();
    if (previewer == 0) {
        const TracerProcess tracer(FAKE_TRACER, {"stubborn"});
        raise(SIGKILL);
    }
    int status = 0;
    ASSERT_EQ(waitpid(previewer, &status, 0), previewer);
    ASSERT_TRUE(WIFSIGNALED(status));
    pid_t orphan = 0;
    for (int i = 0; i < 100 && orphan == 0; ++i) {
        orphan = waitpid(-1, &status, WNOHANG);
        if (orphan == 0) usleep(20'000);
    }
    EXPECT_GT(orphan, 0) << "the tracer lives on";
    EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL);
    prctl(PR_SET_CHILD_SUBREAPER, 0);
}

}  // namespace
}  // namespace povpreview
