// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/adapter/oracle_fixture.h"

#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>

namespace povpreview {

namespace {
std::vector<std::string> fresh_files;
}

void OracleTest::TearDown() {
    for (const std::string& file : fresh_files) std::filesystem::remove(file);
    fresh_files.clear();
    EXPECT_EQ(open_descriptors(), descriptors_);
    int status = 0;
    const pid_t child = waitpid(-1, &status, WNOHANG);
    EXPECT_TRUE(child == -1 && errno == ECHILD) << "a child is left: " << child;
    EXPECT_LT(std::chrono::steady_clock::now() - start_, 30s);
}

std::string OracleTest::error_of(const PovrayOracle::Settings& settings, Exit exit) {
    PovrayOracle oracle(settings);
    std::vector<Sample> samples;
    try {
        oracle.wait_for_scene(nullptr, nullptr);
        oracle.submit(all_pixels(), Parts::surface);
        const auto deadline = std::chrono::steady_clock::now() + 20s;
        while (std::chrono::steady_clock::now() < deadline) oracle.collect(samples, 20ms);
    } catch (const Error& error) {
        EXPECT_EQ(error.exit(), exit) << error.what();
        EXPECT_THROW(oracle.collect(samples, 0ns), Error);
        EXPECT_THROW(oracle.submit(all_pixels(), Parts::colour), Error);
        return error.what();
    }
    ADD_FAILURE() << "no Error was thrown; " << samples.size() << " samples came";
    return "";
}

std::string OracleTest::fresh_file() {
    std::string path = (std::filesystem::temp_directory_path() / "povpreview-once-XXXXXX").string();
    const int fd = mkstemp(path.data());
    if (fd >= 0) close(fd);
    std::filesystem::remove(path);
    fresh_files.push_back(path);
    return path;
}

}  // namespace povpreview
