// SPDX-License-Identifier: AGPL-3.0-or-later
//
// What a shell in the tracer's place may do: it tries by what is built into it, since it can run
// nothing else.
#include "adapter/sandbox.h"

#include <sys/stat.h>

#include <fstream>

#include "tests/adapter/oracle_fixture.h"

namespace povpreview {
namespace {

namespace fs = std::filesystem;

class SandboxTest : public OracleTest {
   protected:
    void SetUp() override {
        OracleTest::SetUp();
        if (Sandbox::missing().find("Landlock") != std::string::npos)
            GTEST_SKIP() << Sandbox::missing();
        std::string name = (fs::temp_directory_path() / "sandbox-test-XXXXXX").string();
        ASSERT_NE(mkdtemp(name.data()), nullptr);
        work_ = name;
        for (const char* folder : {"open", "closed", "scratch"}) {
            fs::create_directory(work_ / folder);
            std::ofstream(work_ / folder / "file") << "text\n";
        }
    }
    void TearDown() override {
        std::error_code ignored;
        fs::remove_all(work_, ignored);
        OracleTest::TearDown();
    }
    /// What a bash script says that may read open/ and write scratch/, and stands in the folder of
    /// both.
    std::string said_by(const std::string& script, std::uint64_t memory = 0) const {
        TracerSetting setting;
        setting.sandbox =
            SandboxRules{{work_ / "open", work_ / "nowhere"}, {work_ / "scratch"}, memory};
        TracerProcess process("bash", {"-c", "cd " + work_.string() + "; " + script}, setting);
        std::byte buffer[64];
        while (process.receive(buffer).what != TracerProcess::Received::end)
            process.wait(100ms, false);
        process.stop();
        return process.last_words();
    }

    fs::path work_;
};

TEST_F(SandboxTest, ReadsWhatItMayAndNothingElse) {
    EXPECT_EQ(said_by("read x < open/file; echo $x >&2"), "text");
    EXPECT_NE(said_by("read x < closed/file; echo $x >&2").find("denied"), std::string::npos);
    EXPECT_NE(said_by("read x < /etc/passwd; echo $x >&2").find("denied"), std::string::npos);
    EXPECT_NE(said_by("cd closed; echo * >&2").find('*'), std::string::npos);  // no listing
    fs::create_symlink("../closed/file", work_ / "open/link");
    EXPECT_NE(said_by("read x < open/link; echo $x >&2").find("denied"), std::string::npos);
}

TEST_F(SandboxTest, WritesIntoItsScratchAlone) {
    EXPECT_EQ(said_by("echo new > scratch/other; echo more >> scratch/file"), "");
    EXPECT_TRUE(fs::exists(work_ / "scratch/other"));
    EXPECT_EQ(fs::file_size(work_ / "scratch/file"), 10U);
    for (const char* target : {"open/other", "open/file", "closed/other", "/tmp/sandbox-other"})
        EXPECT_NE(said_by(std::string("echo new > ") + target).find("denied"), std::string::npos)
            << target;
    EXPECT_EQ(fs::file_size(work_ / "open/file"), 5U);
    EXPECT_FALSE(fs::exists("/tmp/sandbox-other"));
}

TEST_F(SandboxTest, RunsNoOtherProgram) {
    EXPECT_NE(said_by("/bin/ls").find("denied"), std::string::npos);
    EXPECT_NE(said_by("cp /bin/true scratch/own; exec /bin/true").find("denied"),
              std::string::npos);
}

TEST_F(SandboxTest, ReachesNoNetwork) {
    // Without the sandbox nobody listens there, and that is what is said.
    const std::string words = said_by("exec 3<>/dev/tcp/127.0.0.1/1");
    EXPECT_NE(words.find("not permitted"), std::string::npos) << words;
    EXPECT_EQ(words.find("refused"), std::string::npos) << words;
}

TEST_F(SandboxTest, SendsNoSignalToOthers) {
    std::ifstream release("/proc/sys/kernel/osrelease");
    double version = 0;
    release >> version;
    if (version < 6.12) GTEST_SKIP() << "Landlock keeps signals from Linux 6.12 on";
    const std::string words = said_by("kill -0 " + std::to_string(getpid()));
    EXPECT_NE(words.find("not permitted"), std::string::npos) << words;
}

TEST_F(SandboxTest, HasItsShareOfMemory) {
    const std::string build =
        "x=0123456789abcdef; for i in {1..22}; do x=$x$x; done; echo ${#x} >&2";
    EXPECT_EQ(said_by(build), "67108864");
    const std::string words = said_by(build, std::uint64_t{60} << 20);
    EXPECT_EQ(words.find("67108864"), std::string::npos) << words;
}

}  // namespace
}  // namespace povpreview
