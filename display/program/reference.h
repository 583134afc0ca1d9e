// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "display/image.h"

namespace povpreview {

/// Off: one sample per pixel. On: POV-Ray's default (+A0.3 +AM1 +R3), without jitter.
enum class Antialiasing { off, on };

/// A complete render by the stock povray in `folder`/reference.png, or reference-aa.png if
/// anti-aliased: made, or reused when the options are the same and no file in the scene's folder is
/// newer. Returns its encoded values in [0, 1]. `interrupted` is asked whether to give up. Throws
/// Error.
Image stock_reference(const std::vector<std::string>& povray_words,
                      const std::filesystem::path& folder, const std::function<bool()>& interrupted,
                      Antialiasing antialiasing = Antialiasing::off);

}  // namespace povpreview
