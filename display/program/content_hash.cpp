// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/program/content_hash.h"

#define XXH_INLINE_ALL
#include <fmt/format.h>
#include <xxhash.h>

#include <fstream>
#include <memory>
#include <vector>

namespace povpreview {
namespace {

namespace fs = std::filesystem;

std::string hexadecimal(XXH128_hash_t hash) {
    return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

std::string hash_of_file(const fs::path& path) {
    std::ifstream stream(path, std::ios::binary);
    if (!stream) return "absent";
    const std::unique_ptr<XXH3_state_t, decltype(&XXH3_freeState)> state(XXH3_createState(),
                                                                         XXH3_freeState);
    XXH3_128bits_reset(state.get());
    std::vector<char> part(1 << 18);
    while (stream.read(part.data(), std::ssize(part)) || stream.gcount() > 0)
        XXH3_128bits_update(state.get(), part.data(), static_cast<std::size_t>(stream.gcount()));
    return stream.bad() ? "absent" : hexadecimal(XXH3_128bits_digest(state.get()));
}

}  // namespace

std::string content_hash(std::span<const unsigned char> bytes) {
    return hexadecimal(XXH3_128bits(bytes.data(), bytes.size()));
}

std::string ContentHashes::of(const fs::path& path) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (!fs::exists(status)) return "absent";
    if (fs::is_directory(status)) return "folder";
    if (!fs::is_regular_file(status)) return "special";
    const FileStamp stamp = FileStamp::of(path);
    {
        const std::lock_guard lock(mutex_);
        const auto known = known_.find(path);
        if (known != known_.end() && known->second.stamp == stamp) return known->second.hash;
    }
    const std::string hash = hash_of_file(path);
    const std::lock_guard lock(mutex_);
    known_[path] = {stamp, hash};
    return hash;
}

}  // namespace povpreview
