// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "display/image.h"

namespace povpreview {

/// A complete render by the stock povray in `folder`/reference.png, without anti-aliasing: made, or
/// reused when the options are the same and no file in the scene's folder is newer. Returns its
/// encoded values in [0, 1]. `interrupted` is asked whether to give up. Throws Error.
Image stock_reference(const std::vector<std::string>& povray_words,
                      const std::filesystem::path& folder,
                      const std::function<bool()>& interrupted);

}  // namespace povpreview
