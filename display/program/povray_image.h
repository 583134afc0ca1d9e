// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace povpreview {

/// A folder of its own, in which a tracer may write; gone at the end.
class ScratchFolder {
   public:
    /// Throws Error(Exit::usage).
    ScratchFolder();
    ~ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }

   private:
    std::filesystem::path path_;
};

/// Refuses an image of this name, POV-Ray's own choice, before hours of work: where it makes none,
/// where it would write to its standard output, where the folder cannot be written. Throws
/// Error(Exit::usage).
void check_image(const std::string& name);

/// Copies the image that POV-Ray made, all or nothing (see write_file). Throws Error(Exit::usage).
void save_povray_image(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace povpreview
