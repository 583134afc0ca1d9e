// SPDX-License-Identifier: AGPL-3.0-or-later
//
// What is learnt of the files that children open: all of them, also those of their children and
// those that are not there; and how children are run to their end.
#include "adapter/file_watch.h"

#include <gtest/gtest.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>

#include "adapter/child_process.h"
#include "core/error.h"

namespace povpreview {
namespace {

namespace fs = std::filesystem;

class FileWatchTest : public testing::Test {
   protected:
    void SetUp() override {
        std::string name = (fs::temp_directory_path() / "povpreview-watch-XXXXXX").string();
        ASSERT_NE(mkdtemp(name.data()), nullptr);
        folder_ = fs::canonical(name);
        fs::create_directory(folder_ / "deep");
        write("a", "aaa");
        write("deep/b", "b");
    }
    void TearDown() override { fs::remove_all(folder_); }
    void write(const std::string& file, const std::string& text) const {
        std::ofstream(folder_ / file) << text;
    }
    static ChildResult run(
        const std::string& script, FileWatch* watch = nullptr,
        const std::function<bool()>& wait = [] { return false; }) {
        return run_child({.program = "sh",
                          .arguments = {"-c", script},
                          .environment = environment_without({}),
                          .watch = watch,
                          .remedy = "install a shell"},
                         wait);
    }
    static std::vector<FileAccess> all_of(FileWatch& watch) {
        const auto accesses = watch.finish();
        EXPECT_TRUE(accesses) << "this kernel does not let files be watched";
        return accesses.value_or(std::vector<FileAccess>());
    }
    /// What a shell script opens in our folder, relative to it: "a", or "+a" if made.
    std::vector<std::string> opened(const std::string& script) const {
        FileWatch watch;
        run("cd " + folder_.string() + "; " + script, &watch);
        std::vector<std::string> result;
        for (const FileAccess& access : all_of(watch)) {
            const std::string path = access.path.string();
            if (path.starts_with(folder_.string() + "/"))
                result.push_back((access.made ? "+" : "") +
                                 path.substr(folder_.string().size() + 1));
        }
        return result;
    }
    fs::path folder_;
};

using Names = std::vector<std::string>;

TEST_F(FileWatchTest, FilesReadAndFilesLookedForInVain) {
    EXPECT_EQ(opened("read x <a; read x <missing; true"), (Names{"a", "missing"}));
}

TEST_F(FileWatchTest, ChildrenOfChildrenInOtherFolders) {
    EXPECT_EQ(opened("(cd deep && exec cat b ../a) & wait"), (Names{"deep/../a", "deep/b"}));
}

TEST_F(FileWatchTest, MadeIsWhatWasWrittenAnewBeforeItWasRead) {
    EXPECT_EQ(opened("echo 1 >new; cat new"), Names{"+new"});
    EXPECT_EQ(opened("cat a; echo 1 >a"), Names{"a"});
    EXPECT_EQ(opened("echo 1 >>a"), Names{"a"});
}

TEST_F(FileWatchTest, LibrariesAndDevicesAreNoFiles) {
    FileWatch watch;
    run("cat /dev/null /proc/self/stat", &watch);
    for (const FileAccess& access : all_of(watch))
        EXPECT_FALSE(access.path.string().starts_with("/dev") ||
                     access.path.string().starts_with("/proc") ||
                     access.path.string().find(".so") != std::string::npos)
            << access.path;
}

TEST_F(FileWatchTest, TheStampIsOfTheFirstOpen) {
    FileWatch watch;
    const FileStamp before = FileStamp::of(folder_ / "a");
    run("cd " + folder_.string() + "; read x <a; echo longer than before >a; read x <a", &watch);
    const std::vector<FileAccess> accesses = all_of(watch);
    const auto a = std::find_if(accesses.begin(), accesses.end(), [&](const FileAccess& access) {
        return access.path == folder_ / "a";
    });
    ASSERT_NE(a, accesses.end());
    EXPECT_EQ(a->stamp, before);
    EXPECT_NE(a->stamp, FileStamp::of(folder_ / "a"));
    EXPECT_EQ(FileStamp::of(folder_ / "missing"), FileStamp());
}

TEST_F(FileWatchTest, SeveralChildrenInTurn) {
    FileWatch watch;
    for (const char* file : {"a", "deep/b"}) run("cat " + (folder_ / file).string(), &watch);
    std::size_t ours = 0;
    for (const FileAccess& access : all_of(watch))
        ours += access.path.string().starts_with(folder_.string());
    EXPECT_EQ(ours, 2U);
}

TEST_F(FileWatchTest, AWatchedChildThatHangsCanBeEnded) {
    FileWatch watch;
    EXPECT_TRUE(run("while true; do read x </dev/null; done", &watch, [] { return true; }).stopped);
    EXPECT_TRUE(watch.finish());
}

TEST_F(FileWatchTest, RunningTellsOutputMessagesAndEnd) {
    const ChildResult result = run("printf 'a\\0b'; echo wrong >&2; exit 3");
    EXPECT_EQ(std::string(result.output.begin(), result.output.end()), std::string("a\0b", 3));
    EXPECT_EQ(result.messages, "wrong\n");
    EXPECT_EQ(describe_end(result.status), "exited with status 3");
}

TEST_F(FileWatchTest, MoreMessagesThanAPipeHolds) {
    const ChildResult result = run("seq 100000 >&2");
    EXPECT_TRUE(result.messages.ends_with("\n99999\n100000\n"));
    EXPECT_LT(result.messages.size(), 100000U);
}

TEST_F(FileWatchTest, StoppingEndsAllThatWasStarted) {
    const fs::path mark = folder_ / "alive";
    bool asked = false;
    const ChildResult result =
        run("(trap '' TERM; while true; do touch " + mark.string() + "; sleep .05; done) & wait",
            nullptr, [&] { return asked = asked || fs::exists(mark); });
    EXPECT_TRUE(result.stopped);
    fs::remove(mark);
    usleep(300'000);
    EXPECT_FALSE(fs::exists(mark));
}

TEST_F(FileWatchTest, AProgramThatIsNotThereIsNamed) {
    try {
        run_child({.program = "no-such-program",
                   .arguments = {},
                   .environment = {},
                   .remedy = "write it"},
                  [] { return false; });
        FAIL() << "was started";
    } catch (const Error& error) {
        EXPECT_EQ(error.exit(), Exit::usage);
        EXPECT_NE(std::string(error.what()).find("no-such-program"), std::string::npos);
        EXPECT_NE(std::string(error.what()).find("write it"), std::string::npos);
    }
}

}  // namespace
}  // namespace povpreview
