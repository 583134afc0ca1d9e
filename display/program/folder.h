// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "core/error.h"

namespace povpreview {

/// Makes the folder that `option` names, if it is not there. Throws Error(Exit::usage).
inline void make_folder(const std::filesystem::path& folder, const std::string& option) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error || !std::filesystem::is_directory(folder, error))
        throw Error(Exit::usage, "cannot make this folder: " + error.message(), folder.string(),
                    "give " + option + " a folder that you may write");
}

}  // namespace povpreview
