// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "display/image.h"
#include "display/image_file.h"

namespace povpreview {

/// What is done by OpenImageIO. It brings some 250 shared libraries, which take .1 to .3 s to load:
/// longer than a simple scene takes to its first picture. So it stands in a module of its own
/// (display/openimageio), loaded when a file is read or written or a caption is set. Callers need
/// not know: the functions of image_file.h and caption.h go through here.
struct ImageLibrary {
    std::vector<unsigned char> (*encoded_image)(const Image&, FileFormat,
                                                const std::filesystem::path&);
    Image (*read_image)(const std::filesystem::path&);
    Image (*caption_strip)(const std::string&, int width);
    AnnotatedImage (*annotated_image)(std::span<const unsigned char>, const ImageNotes&,
                                      const std::filesystem::path&);
};

/// Loads it on the first call; from any thread. Throws Error(Exit::usage) if it cannot be loaded.
const ImageLibrary& image_library();

}  // namespace povpreview
