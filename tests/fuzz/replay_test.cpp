// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Replays the fuzzer's corpora, seeds and whatever once broke, in the ordinary tests; and feeds
// each target with noise, for machines without a fuzzer: from as many seeds as the environment
// variable FUZZ_SEEDS says (100).
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <vector>

#include "tests/fuzz/targets.h"

namespace povpreview {
namespace {

struct Named {
    const char* name;
    fuzz::Target* target;
};

class Fuzz : public testing::TestWithParam<Named> {};

TEST_P(Fuzz, TheCorpusDoesNoHarm) {
    const std::filesystem::path corpus = std::filesystem::path(FUZZ_CORPUS) / GetParam().name;
    int files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(corpus)) {
        std::ifstream file(entry.path(), std::ios::binary);
        const std::vector<char> bytes(std::istreambuf_iterator<char>(file), {});
        std::fprintf(stderr, "%s\n", entry.path().c_str());  // what ends the process is named
        GetParam().target(std::as_bytes(std::span(bytes)));
        ++files;
    }
    EXPECT_GE(files, 5) << "the seeds are missing from " << corpus;
}

TEST_P(Fuzz, NoiseDoesNoHarm) {
    const char* wanted = std::getenv("FUZZ_SEEDS");
    const unsigned long seeds = wanted ? std::strtoul(wanted, nullptr, 10) : 100;
    for (unsigned long seed = 0; seed < seeds; ++seed) {
        std::mt19937 random(static_cast<unsigned>(seed));
        std::vector<std::byte> bytes(random() % 700);
        for (std::byte& byte : bytes) byte = static_cast<std::byte>(random());
        SCOPED_TRACE(seed);
        GetParam().target(bytes);
    }
}

INSTANTIATE_TEST_SUITE_P(Targets, Fuzz,
                         testing::Values(Named{"wire", fuzz::wire}, Named{"mesh", fuzz::mesh},
                                         Named{"edges", fuzz::edges}, Named{"items", fuzz::items},
                                         Named{"options", fuzz::options}),
                         [](const auto& named) { return std::string(named.param.name); });

}  // namespace
}  // namespace povpreview
