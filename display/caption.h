// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "display/image.h"

namespace povpreview {

/// A strip `width` pixels wide with light text on dark ground, linear light. Lines of the text
/// (between '\n') stand below each other; one that is too long is set smaller, and at the smallest
/// legible size broken between words. ASCII; any other character becomes a question mark.
/// Throws Error(Exit::usage) if there is no font, naming the package that brings one.
Image caption_strip(const std::string& text, int width);

struct Panel {
    const Image& image;   ///< linear light
    std::string caption;  ///< may be empty
};

/// The images side by side, upper edges aligned, each with its caption below. Panels are never
/// narrower than captions need to be read; a smaller image stands in the middle of its panel.
/// Throws as caption_strip.
Image compose(std::span<const Panel> panels);

}  // namespace povpreview
