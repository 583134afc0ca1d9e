// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/program/detail_pictures.h"

#include <algorithm>
#include <cmath>

#include "core/detail/detail_map.h"

namespace povpreview {

namespace {

Picture dark(const Picture& preview) {
    Picture picture;
    picture.width = preview.width;
    picture.height = preview.height;
    picture.pixels.resize(std::size_t(preview.width) * std::size_t(preview.height));
    picture.known.assign(picture.pixels.size(), 1);
    return picture;
}

/// Neighbouring numbers have colours far apart: steps of the golden ratio around the hues.
glm::vec3 unique_colour(std::uint32_t item) {
    const float hue = std::fmod(float(item) * .618034f, 1.f) * 6;
    const auto channel = [hue](float peak) {
        const float away = std::abs(std::fmod(hue - peak + 9, 6.f) - 3);
        return .04f + .8f * std::clamp(2 - away, 0.f, 1.f);
    };
    return {channel(0), channel(2), channel(4)};
}

}  // namespace

Picture albedo_picture(const Picture& preview) {
    Picture picture = dark(preview);
    const DetailMap& detail = *preview.detail;
    for (Pixel i = 0; i < picture.pixels.size(); ++i)
        if (detail.albedo_state(i) == DetailMap::Albedo::known)
            picture.pixels[i] = detail.albedo(i);
    return picture;
}

Picture traced_surfaces_picture(const Picture& preview) {
    Picture picture = dark(preview);
    const DetailMap& detail = *preview.detail;
    for (Pixel i = 0; i < picture.pixels.size(); ++i)
        if (detail.albedo_state(i) == DetailMap::Albedo::wanted &&
            detail.item(i) != DetailMap::unknown)
            picture.pixels[i] = unique_colour(detail.item(i));
    return picture;
}

Picture detail_map_picture(const Picture& preview) {
    Picture picture = albedo_picture(preview);
    for (Pixel i = 0; i < picture.pixels.size(); ++i)
        if (preview.known[i]) picture.pixels[i] = preview.pixels[i];
    return picture;
}

}  // namespace povpreview
