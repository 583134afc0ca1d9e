// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace povpreview {

class FileWatch;

/// Renders by the stock `povray` binary with these arguments and returns what it wrote to its
/// standard output. Calls `wait` some times a second; when that returns true, the render is ended
/// and nothing returned. `watch` (may be null) is told what files it opens. Throws
/// Error(Exit::scene) with POV-Ray's own message if it fails, all its messages then being in `log`;
/// Error(Exit::usage) if there is no such binary.
std::optional<std::vector<unsigned char>> render_by_stock_povray(
    const std::vector<std::string>& arguments, const std::filesystem::path& log,
    const std::function<bool()>& wait, FileWatch* watch = nullptr);

/// POV-Ray's sentence about what stopped it, from its messages.
std::string reason_of_failure(std::string_view messages);

}  // namespace povpreview
