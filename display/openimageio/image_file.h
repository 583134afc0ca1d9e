// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "display/image_file.h"

/// What display/image_file.h promises, by OpenImageIO.
namespace povpreview::openimageio {

/// The bytes of the file that write_image() writes. `path` is named in errors only.
std::vector<unsigned char> encoded_image(const Image& linear, FileFormat format,
                                         const std::filesystem::path& path);
AnnotatedImage annotated_image(std::span<const unsigned char> file, const ImageNotes& notes,
                               const std::filesystem::path& path);
Image read_image(const std::filesystem::path& path);

}  // namespace povpreview::openimageio
