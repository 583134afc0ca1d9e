// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>
#include <string_view>

namespace povpreview {

/// Writes `bytes` as the file `path`, all or nothing: into a temporary file beside it, which then
/// takes its name. A link is followed; what is not a regular file (a device, a pipe) is written to
/// as it is. Throws Error(Exit::usage) with the path, the cause and a remedy; the old file, if any,
/// is then untouched and nothing is left behind.
void write_file(const std::filesystem::path& path, std::span<const unsigned char> bytes);
inline void write_text(const std::filesystem::path& path, std::string_view text) {
    write_file(path, {reinterpret_cast<const unsigned char*>(text.data()), text.size()});
}

}  // namespace povpreview
