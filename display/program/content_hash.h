// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <mutex>
#include <span>
#include <string>

#include "adapter/file_watch.h"

namespace povpreview {

/// 128 bits of a hash (XXH3) in hexadecimal.
std::string content_hash(std::span<const unsigned char> bytes);

/// Hashes of files' contents. Each is read once as long as its stamp stays the same. From any
/// thread.
class ContentHashes {
   public:
    /// content_hash() of a file; "absent" if it cannot be read, "folder", or "special" for what has
    /// no contents of its own (a pipe, a device).
    std::string of(const std::filesystem::path& path);

   private:
    struct Known {
        FileStamp stamp;
        std::string hash;
    };
    std::mutex mutex_;
    std::map<std::filesystem::path, Known> known_;
};

}  // namespace povpreview
