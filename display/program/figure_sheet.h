// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "display/image.h"

namespace povpreview {

/// What has to do with one letter of a figure.
struct FigurePart {
    std::string name;
    Image image;          ///< linear light
    std::string caption;  ///< begins with the name
};

/// Writes NAME.png for each part, figure.png with all of them, three in a row above their captions,
/// and the captions to the standard output, a line each. Throws Error.
void write_figure(const std::vector<FigurePart>& parts, const std::filesystem::path& folder);

}  // namespace povpreview
