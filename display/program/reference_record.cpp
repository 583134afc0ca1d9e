// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/program/reference_record.h"

#include <algorithm>
#include <fstream>
#include <iomanip>
#include <sstream>

#include "display/atomic_file.h"

namespace povpreview {
namespace {

namespace fs = std::filesystem;

constexpr const char* first_line = "povpreview reference 1";

}  // namespace

bool ReferenceRecord::holds(const fs::path& picture_file, ContentHashes& hashes) const {
    if (!picture.empty() && hashes.of(picture_file) != picture) return false;
    return std::all_of(files.begin(), files.end(),
                       [&](const FileState& file) { return hashes.of(file.path) == file.content; });
}

void ReferenceRecord::write(const fs::path& path) const {
    std::ostringstream text;
    text << first_line << '\n'
         << std::quoted(made_by) << '\n'
         << std::quoted(picture) << '\n'
         << std::quoted(failure) << '\n'
         << files.size() << '\n';
    for (const FileState& file : files)
        text << file.content << ' ' << std::quoted(file.path) << '\n';
    write_text(path, text.str());
}

std::optional<ReferenceRecord> ReferenceRecord::read(const fs::path& path) {
    std::ifstream text(path);
    std::string line;
    ReferenceRecord record;
    std::size_t count = 0;
    if (!std::getline(text, line) || line != first_line) return std::nullopt;
    text >> std::quoted(record.made_by) >> std::quoted(record.picture) >>
        std::quoted(record.failure) >> count;
    for (FileState file; count > 0 && text >> file.content >> std::quoted(file.path); --count)
        record.files.push_back(file);
    if (!text || count > 0) return std::nullopt;
    return record;
}

std::optional<std::vector<FileState>> file_states(const std::vector<FileAccess>& accesses,
                                                  ContentHashes& hashes) {
    std::vector<FileState> result;
    for (const FileAccess& access : accesses) {
        const std::string content = hashes.of(access.path);
        if (access.made && content == "absent") continue;
        if (content == "special") return std::nullopt;
        const bool kept = FileStamp::of(access.path) == access.stamp;
        if (!access.made && content != "folder" && !kept) return std::nullopt;
        result.push_back({access.path.string(), content});
    }
    return result;
}

}  // namespace povpreview
