// SPDX-License-Identifier: AGPL-3.0-or-later
#include "adapter/render_state.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <random>
#include <string>

#include "core/error.h"

namespace povpreview {
namespace {

using Bytes = std::vector<std::byte>;

/// Writes what POV-Ray's POVMS_Object::Write does.
class Writer {
   public:
    Writer& text(const std::string& letters) {
        for (const char c : letters) bytes_.push_back(static_cast<std::byte>(c));
        return *this;
    }
    Writer& number(std::uint32_t value) {
        for (int shift = 24; shift >= 0; shift -= 8)
            bytes_.push_back(static_cast<std::byte>(value >> shift & 255));
        return *this;
    }
    Writer& entry(const std::string& key, std::uint32_t value) {
        ++entries;
        return text(key).text("INT4").number(4).number(value);
    }
    Writer& floats(const std::string& key, const std::vector<float>& values) {
        ++entries;
        text(key).text("VFL4").number(std::uint32_t(values.size()));
        for (const float value : values) number(std::bit_cast<std::uint32_t>(value));
        return *this;
    }
    Writer& integers(const std::string& key, const std::vector<std::uint32_t>& values) {
        ++entries;
        text(key).text("VIN4").number(std::uint32_t(values.size()));
        for (const std::uint32_t value : values) number(value);
        return *this;
    }
    std::uint32_t entries = 0;
    const Bytes& bytes() const { return bytes_; }

   private:
    Bytes bytes_;
};

Bytes operator+(Bytes a, const Bytes& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

Bytes head() {
    Bytes bytes = Writer().text("POV-Ray Render State File").bytes();
    bytes.resize(512);
    return bytes;
}

Bytes message(const Writer& entries) {
    const Bytes object = Writer().text("OBJE").number(entries.entries).bytes() + entries.bytes();
    return Writer()
               .text("POVRAYMS")
               .number(0x370)
               .number(std::uint32_t(object.size()))
               .text("RAWS")
               .bytes() +
           object;
}

/// A block of the mosaic.
Bytes block(std::uint32_t x, std::uint32_t y, std::uint32_t size, float grey) {
    return message(Writer()
                       .integers("PPos", {x, y})
                       .floats("PCol", {grey, grey, grey, 0, 0})
                       .entry("PiSi", size));
}

TEST(RenderState, LaterBlocksHideEarlierOnes) {
    RenderState state(6, 4);
    state.append(head() + block(0, 0, 4, .25f) + block(4, 0, 4, .5f) + block(2, 2, 2, .75f));
    EXPECT_EQ(state.samples(), 3u);
    const auto at = [&](int x, int y) { return state.pixels()[std::size_t(y) * 6 + x].x; };
    EXPECT_EQ(at(0, 0), .25f);
    EXPECT_EQ(at(5, 3), .5f);  // cut at the border
    EXPECT_EQ(at(3, 3), .75f);
    EXPECT_EQ(at(1, 2), .25f);
}

TEST(RenderState, RectanglesGoRowByRow) {
    RenderState state(3, 2);
    std::vector<float> colours;
    for (int i = 0; i < 4; ++i) colours.insert(colours.end(), {float(i), 2.f, 3.f, 0, 0});
    state.append(head() + message(Writer()
                                      .floats("PBlo", colours)
                                      .entry("PiSi", 1)
                                      .entry("Left", 1)
                                      .entry("Top ", 0)
                                      .entry("Righ", 2)
                                      .entry("Bott", 1)));
    EXPECT_EQ(state.pixels()[1], glm::vec3(0, 2, 3));
    EXPECT_EQ(state.pixels()[2], glm::vec3(1, 2, 3));
    EXPECT_EQ(state.pixels()[5], glm::vec3(3, 2, 3));
    EXPECT_EQ(state.pixels()[0], glm::vec3(0));
    EXPECT_EQ(state.samples(), 4u);
}

TEST(RenderState, PortionsDoNotMatter) {
    const Bytes all = head() + block(0, 0, 8, .5f) + block(2, 3, 1, .25f) + block(5, 5, 2, 1);
    RenderState whole(8, 8), drops(8, 8);
    whole.append(all);
    for (const std::byte byte : all) drops.append({&byte, 1});
    EXPECT_EQ(drops.pixels(), whole.pixels());
    EXPECT_EQ(drops.samples(), 3u);
}

TEST(RenderState, WhatIsNoSuchFileIsSaidToBe) {
    const auto rejects = [](const Bytes& bytes) {
        RenderState state(8, 8);
        try {
            state.append(bytes);
        } catch (const Error& error) {
            return error.exit() == Exit::tracer;
        }
        return false;
    };
    EXPECT_TRUE(rejects(Bytes(600)));
    EXPECT_TRUE(rejects(head() + Bytes(20)));
    EXPECT_TRUE(rejects(head() + block(8, 0, 1, .5f)));           // outside
    EXPECT_TRUE(rejects(head() + block(0xffffffff, 0, 1, .5f)));  // left of it
    EXPECT_TRUE(rejects(head() + block(0, 0, 1u << 31, .5f)));
    EXPECT_TRUE(rejects(head() + block(0, 0, 0, .5f)));
    EXPECT_TRUE(rejects(head() + message(Writer().integers("PPos", {0, 0}))));  // no colours
    // A length beyond the message's end.
    EXPECT_TRUE(rejects(head() + message(Writer().text("PiSiINT4").number(400).entry("x   ", 1))));
}

TEST(RenderState, NoBrokenByteDoesHarm) {
    const Bytes all = head() + block(0, 0, 8, .5f) + block(2, 3, 1, .25f);
    std::mt19937 random(7);
    for (int i = 0; i < 3000; ++i) {
        Bytes broken = all;
        broken[512 + random() % (broken.size() - 512)] = static_cast<std::byte>(random());
        RenderState state(8, 8);
        try {
            state.append(broken);
        } catch (const Error&) {
        }
        EXPECT_LE(state.samples(), 2u);
    }
}

}  // namespace
}  // namespace povpreview
