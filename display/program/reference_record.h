// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "adapter/file_watch.h"
#include "display/program/content_hash.h"

namespace povpreview {

/// A file and what it held: a hash, or why there is none (see ContentHashes).
struct FileState {
    std::string path, content;
};

/// From what a reference was made, and what came of it. As long as all of it still holds, making it
/// again would give the same. Kept in a file beside the picture.
struct ReferenceRecord {
    std::string made_by;  ///< the program, its options and its surroundings
    std::vector<FileState> files;
    std::string picture;  ///< content_hash() of it; empty: there is none
    std::string failure;  ///< what POV-Ray said then

    /// Whether every file holds what it held; also the picture, if there is one.
    bool holds(const std::filesystem::path& picture_file, ContentHashes& hashes) const;

    void write(const std::filesystem::path& path) const;
    /// Nothing if there is none, or it was not written by this version.
    static std::optional<ReferenceRecord> read(const std::filesystem::path& path);
};

/// What the files hold that a program opened. Files that it made itself count as it left them, and
/// not at all if it took them away again. Nothing if that cannot be told: a file was changed after
/// the program had opened it, or has no contents of its own.
std::optional<std::vector<FileState>> file_states(const std::vector<FileAccess>& accesses,
                                                  ContentHashes& hashes);

}  // namespace povpreview
