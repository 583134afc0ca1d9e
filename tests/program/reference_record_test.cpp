// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/program/reference_record.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>

#include "tests/display/temporary_folder.h"

namespace povpreview {
namespace {

namespace fs = std::filesystem;

class ReferenceRecordTest : public testing::Test {
   protected:
    void write(const std::string& file, const std::string& text) const {
        std::ofstream(folder_ / file) << text;
    }
    FileAccess read(const std::string& file) const {
        return {folder_ / file, false, FileStamp::of(folder_ / file)};
    }
    std::optional<std::vector<FileState>> states(const std::vector<FileAccess>& accesses) {
        return file_states(accesses, hashes_);
    }
    test::TemporaryFolder folder_;
    ContentHashes hashes_;
};

TEST_F(ReferenceRecordTest, HashesTellContentsAndWhatHasNone) {
    write("a", "one");
    write("b", "one");
    write("c", "two");
    write("empty", "");
    EXPECT_EQ(hashes_.of(folder_ / "a"), hashes_.of(folder_ / "b"));
    EXPECT_NE(hashes_.of(folder_ / "a"), hashes_.of(folder_ / "c"));
    EXPECT_NE(hashes_.of(folder_ / "empty"), "absent");
    EXPECT_EQ(hashes_.of(folder_ / "missing"), "absent");
    EXPECT_EQ(hashes_.of(folder_.path()), "folder");
    ASSERT_EQ(mkfifo((folder_ / "pipe").c_str(), 0600), 0);
    EXPECT_EQ(hashes_.of(folder_ / "pipe"), "special");
    const unsigned char bytes[] = {'o', 'n', 'e'};
    EXPECT_EQ(content_hash(bytes), hashes_.of(folder_ / "a"));
    write("a", "six");  // as long as before
    EXPECT_EQ(hashes_.of(folder_ / "a"), ContentHashes().of(folder_ / "a"));
}

TEST_F(ReferenceRecordTest, HoldsUntilAnyFileChangesEitherWay) {
    write("scene", "s");
    write("include", "i");
    write("picture", "p");
    ReferenceRecord record{"me", *states({read("scene"), read("include"), read("later")}),
                           hashes_.of(folder_ / "picture"), ""};
    const auto holds = [&] { return record.holds(folder_ / "picture", hashes_); };
    EXPECT_TRUE(holds());
    for (const char* file : {"scene", "include", "picture"}) {
        std::string text;
        std::ifstream(folder_ / file) >> text;
        write(file, text + "!");
        EXPECT_FALSE(holds()) << file;
        write(file, text);
        EXPECT_TRUE(holds()) << file;
        fs::rename(folder_ / file, folder_ / "away");
        EXPECT_FALSE(holds()) << file;
        fs::rename(folder_ / "away", folder_ / file);
    }
    write("later", "");
    EXPECT_FALSE(holds());
}

TEST_F(ReferenceRecordTest, FilesThatChangedInUseTellNothing) {
    write("a", "before");
    const FileAccess a = read("a"), missing = read("missing");
    EXPECT_TRUE(states({a, missing}));
    write("a", "after");
    EXPECT_FALSE(states({a}));
    write("missing", "come");
    EXPECT_FALSE(states({missing}));
}

TEST_F(ReferenceRecordTest, FilesItMadeCountAsItLeftThem) {
    FileAccess made = read("made"), gone = read("gone");
    made.made = gone.made = true;
    write("made", "by the scene");
    const auto files = states({made, gone});
    ASSERT_TRUE(files);
    ASSERT_EQ(files->size(), 1U);
    EXPECT_EQ(files->front().content, hashes_.of(folder_ / "made"));
}

TEST_F(ReferenceRecordTest, ComesBackAsItWasWritten) {
    const ReferenceRecord record{"line\n\"quoted\" \\ line\n",
                                 {{"/a b\n\"c\"", "absent"}, {"/d", "0123"}},
                                 "abc",
                                 "it's \"wrong\""};
    record.write(folder_ / "r");
    const auto back = ReferenceRecord::read(folder_ / "r");
    ASSERT_TRUE(back);
    EXPECT_EQ(back->made_by, record.made_by);
    EXPECT_EQ(back->picture, record.picture);
    EXPECT_EQ(back->failure, record.failure);
    ASSERT_EQ(back->files.size(), 2U);
    EXPECT_EQ(back->files[0].path, record.files[0].path);
    EXPECT_EQ(back->files[1].content, record.files[1].content);
}

TEST_F(ReferenceRecordTest, AnyTruncationIsNoRecord) {
    ReferenceRecord{"me", {{"/a", "absent"}, {"/b", "12"}}, "p", ""}.write(folder_ / "r");
    std::ifstream stream(folder_ / "r");
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    for (std::size_t size = 0; size + 1 < text.size(); ++size) {
        write("short", text.substr(0, size));
        EXPECT_FALSE(ReferenceRecord::read(folder_ / "short")) << size;
    }
    EXPECT_FALSE(ReferenceRecord::read(folder_ / "missing"));
    EXPECT_FALSE(ReferenceRecord::read(folder_.path()));
}

}  // namespace
}  // namespace povpreview
