// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "adapter/file_watch.h"
#include "display/program/reference.h"

namespace povpreview {

/// A complete picture as its engine made it.
struct EnginePicture {
    std::vector<unsigned char> file;  ///< in the job's format
    std::string software;             ///< that made it, where the file does not say
};

/// Renders; `watch` is told what files are opened. `stop` is asked some times a second; when it
/// returns true, the render is ended and nothing returned. Throws Error: Exit::scene with POV-Ray's
/// message, or Exit::usage.
std::optional<EnginePicture> render_complete(const ReferenceJob& job,
                                             const std::function<bool()>& stop, FileWatch& watch);

/// The program that renders, by its path. Throws Error(Exit::usage) if it is not there.
std::filesystem::path engine_program(Engine engine);
/// How it is called.
std::string engine_command(const ReferenceJob& job);

}  // namespace povpreview
