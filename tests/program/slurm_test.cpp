// SPDX-License-Identifier: AGPL-3.0-or-later
//
// The batch file is run as Slurm runs it: by sh, an element after the other.
#include "display/program/slurm.h"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <fstream>

#include "tests/display/temporary_folder.h"

namespace povpreview {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
    std::ifstream stream(file);
    return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<ReferenceItem> items(std::size_t count, int threads) {
    ReferenceItem item;
    item.povray.threads = threads;
    return std::vector<ReferenceItem>(count, item);
}

TEST(Slurm, EachElementRunsTheProgramOnItsShare) {
    const test::TemporaryFolder folder;
    const fs::path here = folder / "it's here";
    fs::create_directory(here);
    // Stands for povpreview: says where it is and what it was given.
    std::ofstream(folder / "pre view")
        << "#!/bin/sh\npwd >>../said; printf '<%s>' \"$@\" >>../said\n";
    fs::permissions(folder / "pre view", fs::perms::owner_all);
    ReferenceOptions options;
    options.povray = {"+W64", "a b.pov", "Declare=T=\"$HOME 'x'\"", "c.pov"};
    options.out = "o 1";
    options.engine = Engine::tracer;
    options.format = FileFormat::exr_half;
    options.timeout = 2.5;
    options.jobs = 7;
    options.slurm = true;
    std::ofstream(folder / "batch") << slurm_batch(options, items(3, 4), folder / "pre view", here);
    const std::string batch = text_of(folder / "batch");
    EXPECT_TRUE(batch.starts_with("#!/bin/sh\n"));
    for (const char* line :
         {"#SBATCH --array=0-2\n", "#SBATCH --cpus-per-task=4\n", "#SBATCH --ntasks=1\n"})
        EXPECT_NE(batch.find(line), std::string::npos) << batch;

    const std::string run = "SLURM_ARRAY_TASK_ID=2 sh '" + (folder / "batch").string() + "'";
    ASSERT_EQ(system(run.c_str()), 0);
    EXPECT_EQ(text_of(folder / "said"),
              here.string() +
                  "\n<reference><+W64><a b.pov><Declare=T=\"$HOME 'x'\"><c.pov><--out><o 1>"
                  "<--engine><tracer><--format><exr><--timeout><2.5><--jobs><1><--share><2/3>");
}

TEST(Slurm, MorePicturesThanAnArrayHolds) {
    const std::string batch = slurm_batch({}, items(2500, 1), "p", "/");
    EXPECT_NE(batch.find("--array=0-999\n"), std::string::npos) << batch;
    EXPECT_NE(batch.find("$SLURM_ARRAY_TASK_ID/1000"), std::string::npos) << batch;
}

}  // namespace
}  // namespace povpreview
