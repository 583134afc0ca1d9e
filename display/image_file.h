// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "display/image.h"

namespace povpreview {

enum class FileFormat {
    png8,       ///< 8 bit a channel, sRGB-encoded
    png16,      ///< 16 bit a channel, sRGB-encoded
    exr_half,   ///< linear light, 16-bit float
    exr_float,  ///< linear light, 32-bit float
    jpeg,       ///< 8 bit a channel, sRGB-encoded, lossy; for small files alone
};

/// What a path's extension asks for: png16 for ".png", exr_half for ".exr", in any case. Anything
/// else throws Error(Exit::usage); so a wrong name can be refused before hours of work.
FileFormat format_for(const std::filesystem::path& path);

/// Writes an image of linear light, all or nothing (see write_file). PNG is encoded and rounded as
/// POV-Ray does it (+FN8, +FN16), so that equal colours give equal files; what no display can show
/// is clamped there, and not-a-number is written as 0. EXR keeps every value.
/// Throws Error(Exit::usage) with the path, the cause and a remedy.
void write_image(const Image& linear, const std::filesystem::path& path, FileFormat format);
inline void write_image(const Image& linear, const std::filesystem::path& path) {
    write_image(linear, path, format_for(path));
}

/// The bytes of the file that write_image() writes.
std::vector<unsigned char> encoded_image(const Image& linear, FileFormat format);

/// Texts by their names. PNG files carry them as text chunks, EXR files as attributes.
using ImageNotes = std::vector<std::pair<std::string, std::string>>;

/// An image file in memory.
struct AnnotatedImage {
    std::vector<unsigned char> bytes;
    std::size_t not_finite = 0;  ///< pixels with a channel that is infinite or not a number
};
/// The same PNG or EXR file, every value as it was, with these texts in place of its own, but for
/// "Software", which is put behind what the file named as its maker. The same input gives the same
/// bytes. Throws Error(Exit::usage), naming `path`, if it is no such file.
AnnotatedImage annotated_image(std::span<const unsigned char> file, const ImageNotes& notes,
                               const std::filesystem::path& path);

/// Reads an image as it stands in the file, without decoding: the channels of a PNG come as
/// encoded values in [0, 1]. Grey becomes equal channels; alpha is left out.
/// Throws Error(Exit::usage) with the path, the cause and a remedy.
Image read_image(const std::filesystem::path& path);

}  // namespace povpreview
