// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/image_file.h"

#include <algorithm>
#include <cctype>

#include "core/error.h"
#include "display/atomic_file.h"
#include "display/image_library.h"

namespace povpreview {

FileFormat format_for(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (extension == ".png") return FileFormat::png16;
    if (extension == ".exr") return FileFormat::exr_half;
    throw Error(Exit::usage, "no image format is known by this name", path.string(),
                "end the name in .png or .exr");
}

void write_image(const Image& linear, const std::filesystem::path& path, FileFormat format) {
    write_file(path, image_library().encoded_image(linear, format, path));
}

AnnotatedImage annotated_image(std::span<const unsigned char> file, const ImageNotes& notes,
                               const std::filesystem::path& path) {
    return image_library().annotated_image(file, notes, path);
}

std::vector<unsigned char> encoded_image(const Image& linear, FileFormat format) {
    return image_library().encoded_image(linear, format, "an image in memory");
}

Image read_image(const std::filesystem::path& path) { return image_library().read_image(path); }

}  // namespace povpreview
