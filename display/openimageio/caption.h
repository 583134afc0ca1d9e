// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "display/caption.h"

/// What display/caption.h promises, by OpenImageIO.
namespace povpreview::openimageio {

Image caption_strip(const std::string& text, int width);

}  // namespace povpreview::openimageio
