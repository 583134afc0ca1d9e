// SPDX-License-Identifier: AGPL-3.0-or-later
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <cmath>

#include "core/error.h"
#include "display/openimageio/image_file.h"

namespace povpreview::openimageio {
namespace {

std::size_t count_not_finite(OIIO::ImageInput& input, const OIIO::ImageSpec& spec) {
    if (!spec.format.is_floating_point()) return 0;
    const auto channels = static_cast<std::size_t>(spec.nchannels);
    std::vector<float> values(spec.image_pixels() * channels);
    input.read_image(0, 0, 0, spec.nchannels, OIIO::TypeFloat, values.data());
    std::size_t count = 0;
    for (std::size_t pixel = 0; pixel < values.size(); pixel += channels) {
        bool finite = true;
        for (std::size_t c = 0; c < channels; ++c) finite &= std::isfinite(values[pixel + c]);
        count += !finite;
    }
    return count;
}

}  // namespace

AnnotatedImage annotated_image(std::span<const unsigned char> file, const ImageNotes& notes,
                               const std::filesystem::path& path) {
    const auto failure = [&](const std::string& cause) {
        return Error(Exit::usage, "cannot write: " + cause, path.string(),
                     "choose another name or format");
    };
    const std::string name = "memory" + path.extension().string();  // its end tells the format
    OIIO::Filesystem::IOMemReader source(OIIO::cspan<unsigned char>(file.data(), file.size()));
    OIIO::ImageSpec as_stored;
    as_stored.attribute("oiio:UnassociatedAlpha", 1);  // colours as they are, not times alpha
    const auto input = OIIO::ImageInput::create(name, false, &as_stored, &source);
    OIIO::ImageSpec found;
    if (!input) throw failure(OIIO::geterror());
    if (!input->set_ioproxy(&source) || !input->open(name, found, as_stored))
        throw failure(input->geterror());
    std::vector<unsigned char> values(found.image_bytes(true));
    if (!input->read_image(0, 0, 0, found.nchannels, OIIO::TypeUnknown, values.data()))
        throw failure(input->geterror());

    AnnotatedImage result;
    result.not_finite = count_not_finite(*input, found);
    // A specification of its own: what else the file said (the time of its making) is left behind.
    OIIO::ImageSpec spec(found.width, found.height, found.nchannels, found.format);
    spec.channelnames = found.channelnames;
    spec.alpha_channel = found.alpha_channel;
    spec.attribute("oiio:UnassociatedAlpha", 1);
    spec.attribute("oiio:ColorSpace", found.format.is_floating_point() ? "Linear" : "sRGB");
    spec.attribute("DateTime", "");  // else EXR files get that of their writing
    const std::string maker(found.get_string_attribute("Software"));
    for (const auto& [key, text] : notes)
        spec.attribute(key, key == "Software" && !maker.empty() ? maker + ", " + text : text);

    const auto output = OIIO::ImageOutput::create(name);
    if (!output) throw failure(OIIO::geterror());
    OIIO::Filesystem::IOVecOutput memory;
    if (!output->set_ioproxy(&memory)) throw failure("the image library cannot write to memory");
    if (!output->open(name, spec) || !output->write_image(OIIO::TypeUnknown, values.data()) ||
        !output->close())
        throw failure(output->geterror());
    result.bytes = memory.buffer();
    return result;
}

}  // namespace povpreview::openimageio
