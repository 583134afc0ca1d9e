// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>

namespace povpreview {

/// How a tracer is to be run.
struct TracerWishes {
    double stall_timeout_s = 60;
    std::filesystem::path finish_folder = {};  ///< see PovrayOracle::Settings
    std::uint64_t memory = 0;                  ///< bytes that it may use; 0: any number
    bool writes = false;                       ///< the scene may write files, beside itself
};

}  // namespace povpreview
