// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/end_to_end/image_of_samples.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cmath>

#include "adapter/povray_options.h"
#include "adapter/stock_povray.h"
#include "core/error.h"

namespace povpreview {

namespace {

/// As IEC 61966-2-1, in single precision like POV-Ray's own.
float encode(float linear) {
    return linear <= 0.0031308f ? linear * 12.92f : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
}

int encode16(float linear) {
    return static_cast<int>(std::floor(std::clamp(encode(linear), 0.0f, 1.0f) * 65535.0f + 0.5f));
}

}  // namespace

Difference compare_with_stock(const TracedImage& image, const std::vector<std::string>& words,
                              const WorkFolder& folder) {
    const std::string output = folder.path() / "stock.png";
    render_by_stock_povray(read_povray_options(words).stock_arguments({.output = output}),
                           folder.path() / "stock.log", [] { return false; });
    const auto input = OIIO::ImageInput::open(output);
    if (!input) throw Error(Exit::usage, "cannot read stock POV-Ray's image", output, "");
    const OIIO::ImageSpec spec = input->spec();
    if (spec.width != image.width || spec.height != image.height)
        throw Error(Exit::usage, "stock POV-Ray's image has another size", output, "");
    const int channels = spec.nchannels;
    std::vector<std::uint16_t> stock(image.samples.size() * channels);
    input->read_image(0, 0, 0, channels, OIIO::TypeDesc::UINT16, stock.data());

    Difference result;
    double squares = 0;
    for (std::size_t i = 0; i < image.samples.size(); ++i) {
        const Sample& sample = image.samples[i];
        if (sample.failed) {
            ++result.failed;
            continue;
        }
        int worst = 0;
        for (int c = 0; c < 3; ++c) {
            // A grey image has one channel.
            const int there = stock[i * channels + std::min(c, channels < 3 ? 0 : 2)];
            const int off = std::abs(encode16(sample.colour[c]) - there);
            worst = std::max(worst, off);
            squares += static_cast<double>(off) * off;
        }
        result.worst = std::max(result.worst, worst);
        result.differing += worst > 1;
    }
    result.root_mean_square =
        std::sqrt(squares / static_cast<double>(3 * image.samples.size())) / 65535;
    return result;
}

}  // namespace povpreview
