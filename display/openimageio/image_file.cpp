// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/openimageio/image_file.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string_view>

#include "core/colour.h"
#include "core/error.h"

namespace povpreview::openimageio {

namespace {

namespace fs = std::filesystem;

/// Encodes and rounds as POV-Ray 3.7's IntEncode: the float nearest, halves up.
template <class Integer>
std::vector<Integer> quantise(const Image& linear) {
    constexpr float most = static_cast<Integer>(-1);
    std::vector<Integer> values;
    values.reserve(linear.pixels.size() * 3);
    for (const glm::vec3& colour : linear.pixels) {
        const glm::vec3 encoded = display_encoded(colour);
        for (int channel = 0; channel < 3; ++channel)
            values.push_back(static_cast<Integer>(std::floor(encoded[channel] * most + 0.5f)));
    }
    return values;
}

/// Brings the file into memory first: then a full disk is met by our own write, which can hear of
/// it, and not by the last flush inside a library.
std::vector<unsigned char> compress(const Image& image, const char* extension,
                                    OIIO::TypeDesc stored, OIIO::TypeDesc given, const void* data,
                                    const fs::path& path) {
    const auto failure = [&](const std::string& cause) {
        return Error(Exit::usage, "cannot write: " + cause, path.string(),
                     "choose another name or format");
    };
    const auto output = OIIO::ImageOutput::create(extension);
    if (!output) throw failure(OIIO::geterror());
    OIIO::ImageSpec spec(image.width, image.height, 3, stored);
    const bool encoded = stored == OIIO::TypeUInt8 || stored == OIIO::TypeUInt16;
    spec.attribute("oiio:ColorSpace", encoded ? "sRGB" : "Linear");
    if (std::string_view(extension) == "jpg") {
        spec.attribute("Compression", "jpeg:88");
        spec.attribute("jpeg:subsampling", "4:4:4");  // else coloured edges are blurred
    }
    OIIO::Filesystem::IOVecOutput memory;
    if (!output->set_ioproxy(&memory)) throw failure("the image library cannot write to memory");
    if (!output->open(extension, spec) || !output->write_image(given, data) || !output->close())
        throw failure(output->geterror());
    return memory.buffer();
}

}  // namespace

std::vector<unsigned char> encoded_image(const Image& linear, FileFormat format,
                                         const fs::path& path) {
    switch (format) {
        case FileFormat::png8:
            return compress(linear, "png", OIIO::TypeUInt8, OIIO::TypeUInt8,
                            quantise<std::uint8_t>(linear).data(), path);
        case FileFormat::png16:
            return compress(linear, "png", OIIO::TypeUInt16, OIIO::TypeUInt16,
                            quantise<std::uint16_t>(linear).data(), path);
        case FileFormat::exr_half:
            return compress(linear, "exr", OIIO::TypeHalf, OIIO::TypeFloat, linear.pixels.data(),
                            path);
        case FileFormat::exr_float:
            return compress(linear, "exr", OIIO::TypeFloat, OIIO::TypeFloat, linear.pixels.data(),
                            path);
        case FileFormat::jpeg:
            return compress(linear, "jpg", OIIO::TypeUInt8, OIIO::TypeUInt8,
                            quantise<std::uint8_t>(linear).data(), path);
    }
    return {};
}

Image read_image(const fs::path& path) {
    const auto failure = [&](const std::string& cause) {
        return Error(Exit::usage, "cannot read: " + cause, path.string(),
                     "give a PNG or EXR image that can be read");
    };
    OIIO::ImageSpec as_stored;
    as_stored.attribute("oiio:UnassociatedAlpha", 1);  // colours as they are, not times alpha
    const auto input = OIIO::ImageInput::open(path.string(), &as_stored);
    if (!input) throw failure(OIIO::geterror());
    const OIIO::ImageSpec& spec = input->spec();
    if (spec.width < 1 || spec.height < 1 || spec.depth > 1 || spec.nchannels < 1)
        throw failure("it is not a picture");
    const int channels = spec.nchannels;
    const std::size_t pixels = static_cast<std::size_t>(spec.width) * spec.height;
    std::vector<float> values(pixels * channels);
    if (!input->read_image(0, 0, 0, channels, OIIO::TypeFloat, values.data()))
        throw failure(input->geterror());

    Image image(spec.width, spec.height);
    const bool grey = channels < 3;
    for (std::size_t i = 0; i < pixels; ++i)
        for (int c = 0; c < 3; ++c) image.pixels[i][c] = values[i * channels + (grey ? 0 : c)];
    return image;
}

}  // namespace povpreview::openimageio
