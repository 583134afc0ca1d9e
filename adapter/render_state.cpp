// SPDX-License-Identifier: AGPL-3.0-or-later
#include "adapter/render_state.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "core/error.h"

namespace povpreview {
namespace {

constexpr std::string_view file_mark = "POV-Ray Render State File", message_mark = "POVRAYMS";
constexpr std::size_t file_head = 512, message_head = 20;
constexpr std::int32_t largest_block = 64;    // pixels a side
constexpr std::size_t floats_per_colour = 5;  // red, green, blue, filter, transmit

[[noreturn]] void fail(const char* what) {
    throw Error(Exit::tracer,
                std::string("POV-Ray's render state file is not as expected: ") + what,
                "stock-mosaic", "leave this method out by --methods");
}

std::uint32_t number(std::span<const std::byte> bytes, std::size_t at) {
    if (at + 4 > bytes.size()) fail("a number is cut off");
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i)
        value = value << 8 | std::to_integer<std::uint32_t>(bytes[at + i]);
    return value;
}

/// Four letters as the number they make in the file.
constexpr std::uint32_t key(const char (&letters)[5]) {
    std::uint32_t value = 0;
    for (int i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(letters[i]);
    return value;
}

/// A vector of 4-byte numbers in a message.
struct Numbers {
    std::span<const std::byte> bytes;
    std::size_t size() const { return bytes.size() / 4; }
    std::int32_t integer(std::size_t i) const {
        return std::bit_cast<std::int32_t>(number(bytes, 4 * i));
    }
    float real(std::size_t i) const { return std::bit_cast<float>(number(bytes, 4 * i)); }
    glm::vec3 colour(std::size_t i) const {
        const std::size_t first = floats_per_colour * i;
        return {real(first), real(first + 1), real(first + 2)};
    }
};

bool begins_with(std::span<const std::byte> bytes, std::string_view mark) {
    return std::memcmp(bytes.data(), mark.data(), mark.size()) == 0;
}

}  // namespace

RenderState::RenderState(int width, int height)
    : width_(width), height_(height), pixels_(static_cast<std::size_t>(width) * height) {}

void RenderState::append(std::span<const std::byte> bytes) {
    waiting_.erase(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(read_));
    read_ = 0;
    waiting_.insert(waiting_.end(), bytes.begin(), bytes.end());
    if (!begun_) {
        if (waiting_.size() < file_head) return;
        if (!begins_with(waiting_, file_mark)) fail("it begins otherwise");
        begun_ = true;
        read_ = file_head;
    }
    while (take_message()) {
    }
}

bool RenderState::take_message() {
    const std::span<const std::byte> rest = std::span(waiting_).subspan(read_);
    if (rest.size() < message_head) return false;
    if (!begins_with(rest, message_mark)) fail("a message begins otherwise");
    const std::size_t size = number(rest, 12);
    if (number(rest, 16) != key("RAWS")) fail("an unknown encoding");
    if (rest.size() - message_head < size) return false;
    draw_object(rest.subspan(message_head, size));
    read_ += message_head + size;
    return true;
}

void RenderState::draw_object(std::span<const std::byte> object) {
    if (number(object, 0) != key("OBJE")) fail("a message is no object");
    Numbers positions, colours;
    std::int32_t block = 1, left = 0, top = 0, right = -1, bottom = -1;
    std::size_t at = 8;
    for (std::uint32_t entries = number(object, 4); entries > 0; --entries) {
        const std::uint32_t name = number(object, at), type = number(object, at + 4);
        const bool vector = type == key("VIN4") || type == key("VFL4");
        const std::size_t length = std::size_t{number(object, at + 8)} * (vector ? 4 : 1);
        at += 12;
        if (length > object.size() - at) fail("an entry is too long");
        const Numbers value{object.subspan(at, length)};
        at += length;
        if (name == key("PPos")) positions = value;
        if (name == key("PCol") || name == key("PBlo")) colours = value;
        if (name == key("PiSi")) block = value.integer(0);
        if (name == key("Left")) left = value.integer(0);
        if (name == key("Top ")) top = value.integer(0);
        if (name == key("Righ")) right = value.integer(0);
        if (name == key("Bott")) bottom = value.integer(0);
    }
    const auto draw = [&](int x, int y, const glm::vec3& colour) {
        if (x < 0 || y < 0 || x >= width_ || y >= height_) fail("a block outside the picture");
        for (int j = y; j < std::min(y + block, height_); ++j)
            for (int i = x; i < std::min(x + block, width_); ++i)
                pixels_[static_cast<std::size_t>(j) * width_ + i] = colour;
        ++samples_;
    };
    const std::size_t count = colours.size() / floats_per_colour;
    if (block < 1 || block > largest_block) fail("a block of an impossible size");
    if (positions.size() > 0) {  // blocks, each with its place
        if (positions.size() / 2 != count) fail("places and colours differ in number");
        for (std::size_t i = 0; i < count; ++i)
            draw(positions.integer(2 * i), positions.integer(2 * i + 1), colours.colour(i));
        return;
    }
    if (count == 0) return;  // a rectangle, row by row
    if (right < left || bottom < top || left < 0 || top < 0 || right >= width_ || bottom >= height_)
        fail("a rectangle outside the picture");
    const int columns = right - left + 1;
    if (std::size_t(columns) * std::size_t(bottom - top + 1) != count || block != 1)
        fail("a rectangle and its colours differ in number");
    for (std::size_t i = 0; i < count; ++i)
        draw(left + static_cast<int>(i) % columns, top + static_cast<int>(i) / columns,
             colours.colour(i));
}

}  // namespace povpreview
