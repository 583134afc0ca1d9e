// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "adapter/geometry.h"
#include "core/oracle.h"
#include "core/pixel_light.h"

/// The tracer's end of the wire for tests: makes frames, right ones and wrong ones.
namespace povpreview::fake {

using Bytes = std::vector<std::byte>;

/// A slice of answers, with the counts as claimed, whatever the samples.
struct Slice {
    std::uint64_t batch = 1;
    std::uint32_t first = 0;
    std::uint32_t count = 0;
    std::vector<Sample> samples;
    RayKind kind = RayKind::full;
    Parts parts = Parts::colour;
    std::vector<std::uint32_t> failed;
    Rung rung = target_rung;
};

Bytes hello_frame(std::uint32_t version);
Bytes progress_frame(std::uint8_t stage, std::uint64_t done, std::uint64_t total);
/// A scene that uses every field of the schema: a ladder of three rungs.
Bytes scene_frame(std::uint32_t width, std::uint32_t height, bool target_ready = true);
Bytes rung_ready_frame(std::uint8_t rung);
/// A scene whose `features` are `count` times the same name of `length` characters, stored once.
Bytes swollen_scene_frame(std::size_t count, std::size_t length);
Bytes answer_frame(const Slice& slice);
/// A chunk of geometry, its indices and counts as they are, right or wrong. Of a polygon's face all
/// but its corners is sent.
Bytes geometry_frame(const Geometry& geometry, bool last);
using Texel = std::array<std::uint16_t, 4>;
Bytes texels_frame(std::uint32_t image, std::uint32_t first, const std::vector<Texel>& texels);
Bytes raw_texels_frame(std::uint32_t image, std::uint32_t first,
                       const std::vector<std::uint16_t>& halves);
/// All texels of the image that small_geometry() names.
std::vector<Texel> small_texels();
/// Two triangles with a common edge and a square with a hole, and something left out.
Geometry small_geometry();
Bytes failure_frame(const std::string& message, const std::string& file, std::uint32_t line);

/// For samples or, if it has `image`, a part of the finished picture.
struct Order {
    struct Image {
        std::uint32_t first = 0;
        std::vector<PixelLight> pixels;
        bool last = false;
    };
    std::optional<Image> image = std::nullopt;
    std::uint64_t batch = 0;
    RayKind kind = RayKind::full;
    Parts parts = Parts::colour;
    std::vector<glm::dvec2> positions;
    Rung rung = target_rung;
};
/// Decodes the previewer's orders. Throws std::runtime_error if it is none.
Order decode_order(const Bytes& flatbuffer);

}  // namespace povpreview::fake
