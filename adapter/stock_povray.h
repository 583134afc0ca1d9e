// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace povpreview {

/// Renders by the stock `povray` binary with these arguments, its messages into `log`. Calls
/// `wait` some times a second; when that returns true, the render is ended and false returned.
/// Throws Error(Exit::scene) with POV-Ray's own message if it fails, Error(Exit::usage) if there is
/// no such binary.
bool render_by_stock_povray(const std::vector<std::string>& arguments,
                            const std::filesystem::path& log, const std::function<bool()>& wait);

}  // namespace povpreview
