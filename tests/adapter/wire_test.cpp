// SPDX-License-Identifier: AGPL-3.0-or-later
//
// The wire's laws: what is sent is read, however it is chunked; what is cut, corrupted or
// contradicts itself is refused, never believed.
#include "adapter/wire.h"

#include <gtest/gtest.h>

#include <cstring>
#include <random>

#include "tests/adapter/fake_world.h"
#include "tests/adapter/frames.h"
#include "tests/fuzz/exercise_wire.h"

namespace povpreview {
namespace {

using fake::Bytes;

constexpr Parts everything = Parts::surface | Parts::shading | Parts::signature;

fake::Slice slice_of(std::uint32_t count, RayKind kind, Parts parts) {
    fake::Slice slice{.batch = 7,
                      .first = 3,
                      .count = count,
                      .samples = {},
                      .kind = kind,
                      .parts = parts,
                      .failed = {}};
    for (std::uint32_t i = 0; i < count; ++i)
        slice.samples.push_back(fake::sample_at({i + .5, 2 * i + .25}));
    return slice;
}

/// Every kind of report, right and complete.
std::vector<Bytes> all_reports() {
    fake::Slice failed = slice_of(4, RayKind::full, everything);
    failed.failed = {1, 3};
    return {fake::hello_frame(wire_version),
            fake::progress_frame(3, 17, 0),
            fake::scene_frame(640, 480),
            fake::failure_frame("File 'x' line 3: Parse Error: no", "x", 3),
            fake::answer_frame(slice_of(5, RayKind::full, Parts::colour)),
            fake::answer_frame(slice_of(5, RayKind::full, everything)),
            fake::answer_frame(slice_of(5, RayKind::probe, Parts::colour)),
            fake::answer_frame(slice_of(5, RayKind::albedo, Parts::colour)),
            fake::answer_frame(failed),
            fake::geometry_frame(fake::small_geometry(), true),
            fake::rung_ready_frame(2)};
}

Bytes content(const Bytes& frame) { return {frame.begin() + 4, frame.end()}; }

std::string fault_of(const Bytes& flatbuffer) {
    try {
        decode_report(flatbuffer);
    } catch (const WireFault& fault) {
        return fault.what();
    }
    return "";
}

std::vector<Bytes> read_in_chunks(const Bytes& stream, const std::function<std::size_t()>& chunk) {
    FrameReader reader;
    std::vector<Bytes> frames;
    for (std::size_t at = 0; at < stream.size();) {
        const std::size_t size = std::min(chunk(), stream.size() - at);
        reader.feed(std::span(stream).subspan(at, size), [&](std::span<const std::byte> frame) {
            EXPECT_EQ(reinterpret_cast<std::uintptr_t>(frame.data()) % 8, 0U);
            frames.emplace_back(frame.begin(), frame.end());
        });
        at += size;
    }
    EXPECT_FALSE(reader.inside_frame());
    return frames;
}

// ---- framing

TEST(FrameReader, EveryChunkingGivesTheSameFrames) {
    constexpr unsigned seed = 5;
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    Bytes stream;
    std::vector<Bytes> expected;
    for (const Bytes& frame : all_reports()) {
        stream.insert(stream.end(), frame.begin(), frame.end());
        expected.push_back(content(frame));
    }
    for (std::size_t size = 1; size < 70; ++size)
        EXPECT_EQ(read_in_chunks(stream, [&] { return size; }), expected) << "chunks of " << size;
    for (int i = 0; i < 200; ++i)
        EXPECT_EQ(read_in_chunks(stream, [&] { return 1 + random() % 500; }), expected);
    EXPECT_EQ(read_in_chunks(stream, [&] { return stream.size(); }), expected);
}

TEST(FrameReader, ATruncatedStreamGivesTheFramesBeforeTheCut) {
    const Bytes frame = fake::hello_frame(wire_version);
    for (std::size_t cut = 0; cut < frame.size(); ++cut) {
        Bytes stream = frame;
        stream.insert(stream.end(), frame.begin(),
                      frame.begin() + static_cast<std::ptrdiff_t>(cut));
        FrameReader reader;
        int frames = 0;
        reader.feed(stream, [&](auto) { ++frames; });
        EXPECT_EQ(frames, 1);
        EXPECT_EQ(reader.inside_frame(), cut > 0);
    }
}

TEST(FrameReader, SizesThatCannotBeAreRefusedAtOnce) {
    for (const std::uint32_t size :
         {0U, 1U, 7U, static_cast<std::uint32_t>(wire_max_frame) + 1, 0x7fffffffU, 0xffffffffU}) {
        Bytes header(4);
        std::memcpy(header.data(), &size, 4);
        FrameReader reader;
        EXPECT_THROW(reader.feed(header, [](auto) { FAIL(); }), WireFault) << size;
    }
    const auto largest = static_cast<std::uint32_t>(wire_max_frame);
    Bytes header(4);
    std::memcpy(header.data(), &largest, 4);
    FrameReader reader;
    EXPECT_NO_THROW(reader.feed(header, [](auto) { FAIL(); }));
}

// ---- orders

TEST(Wire, AnOrderIsReadAsItWasWritten) {
    std::vector<glm::dvec2> positions;
    for (int i = 0; i < 1000; ++i) positions.emplace_back(i / 3., -i * 1e9);
    Bytes out;
    append_trace(out, 41, {RayKind::probe, target_rung, everything}, positions);
    append_trace(out, 42, {RayKind::full, 3, Parts::shading}, std::span(positions).first(1));
    const auto frames = read_in_chunks(out, [] { return std::size_t{1 << 20}; });
    ASSERT_EQ(frames.size(), 2U);
    const fake::Order first = fake::decode_order(frames[0]), second = fake::decode_order(frames[1]);
    EXPECT_EQ(first.batch, 41U);
    EXPECT_EQ(first.kind, RayKind::probe);
    EXPECT_EQ(first.parts, everything);
    EXPECT_EQ(first.positions, positions);
    EXPECT_EQ(second.batch, 42U);
    EXPECT_EQ(second.parts, Parts::shading);
    EXPECT_EQ(first.rung, target_rung);
    EXPECT_EQ(second.rung, 3);
    EXPECT_EQ(second.positions.size(), 1U);
}

TEST(Wire, TheLargestOrderFitsAFrame) {
    const std::vector<glm::dvec2> positions(wire_max_batch);
    Bytes out;
    append_trace(out, ~std::uint64_t{0}, {RayKind::full, 0, everything}, positions);
    EXPECT_LE(out.size(), wire_max_frame);
}

// ---- reports

TEST(Wire, ReportsAreReadAsTheyWereWritten) {
    const auto hello =
        std::get<report::Hello>(decode_report(content(fake::hello_frame(wire_version))));
    EXPECT_EQ(hello.version, wire_version);
    EXPECT_EQ(hello.povray, "3.7.0.10 fake");
    const auto progress =
        std::get<report::Progress>(decode_report(content(fake::progress_frame(3, 17, 90))));
    EXPECT_EQ(progress.stage, report::Stage::radiosity);
    EXPECT_EQ(progress.done, 17U);
    EXPECT_EQ(progress.total, 90U);
    const auto failure =
        std::get<report::Failure>(decode_report(content(fake::failure_frame("m", "f", 9))));
    EXPECT_EQ(failure.message, "m");
    EXPECT_EQ(failure.file, "f");
    EXPECT_EQ(failure.line, 9U);
    const auto scene =
        std::get<SceneDescription>(decode_report(content(fake::scene_frame(640, 480))));
    EXPECT_EQ(scene.width, 640);
    EXPECT_EQ(scene.lights.at(0).points_at, glm::dvec3(0, 0, 4));
    EXPECT_TRUE(scene.lights.at(0).in_group);
    EXPECT_EQ(scene.textures.at(0).count, 3U);
    EXPECT_EQ(scene.first_look, 24U);
    ASSERT_EQ(scene.ladder.rungs.size(), 3U);
    EXPECT_EQ(scene.ladder.rungs[0].name, "sketch");
    EXPECT_TRUE(scene.ladder.rungs[1].ready);
    EXPECT_FALSE(std::get<SceneDescription>(decode_report(content(fake::scene_frame(9, 9, false))))
                     .ladder.rungs[2]
                     .ready);
    EXPECT_EQ(std::get<report::RungReady>(decode_report(content(fake::rung_ready_frame(2)))).rung,
              2);
}

TEST(Wire, AnAnswerCarriesWhatItsKindBrings) {
    for (const RayKind kind : {RayKind::full, RayKind::probe, RayKind::albedo})
        for (unsigned bits = 0; bits < 8; ++bits) {
            const auto parts = static_cast<Parts>(bits);
            const Bytes bytes = content(fake::answer_frame(slice_of(9, kind, parts)));
            const auto answer = std::get<report::Answer>(decode_report(bytes));
            EXPECT_EQ(answer.batch(), 7U);
            EXPECT_NO_THROW(answer.check_asked(12, {kind, target_rung, parts}));
            EXPECT_THROW(answer.check_asked(11, {kind, target_rung, parts}), WireFault);
            for (std::uint32_t i = 0; i < 9; ++i) {
                Sample sample{.position = {i + .5, 2 * i + .25}, .kind = kind};
                answer.read(i, sample);
                const Sample expected = fake::sample_at(sample.position, kind, parts);
                EXPECT_EQ(sample.colour, expected.colour);
                EXPECT_EQ(sample.surface, expected.surface);
                EXPECT_EQ(sample.reflected_surface, expected.reflected_surface);
                EXPECT_EQ(sample.albedo, expected.albedo);
                EXPECT_EQ(sample.remainder, expected.remainder);
                EXPECT_EQ(sample.signature, expected.signature);
            }
        }
}

/// Four such in one pixel would be infinite.
TEST(Wire, LightBeyondAllBoundsIsCutDown) {
    fake::Slice slice = slice_of(3, RayKind::full, Parts::shading);
    for (Sample& sample : slice.samples) {
        sample.colour = {3e38f, -3e38f, .5f};
        sample.illumination = glm::vec3(2e38f);
    }
    slice.samples[2].colour.x = std::numeric_limits<float>::infinity();
    const Bytes bytes = content(fake::answer_frame(slice));
    const auto answer = std::get<report::Answer>(decode_report(bytes));
    Sample sample{.position = {1, 2}};
    answer.read(0, sample);
    EXPECT_EQ(sample.colour, glm::vec3(1e30f, -1e30f, .5f));
    EXPECT_EQ(sample.illumination, glm::vec3(1e30f));
    answer.read(2, sample);
    EXPECT_EQ(sample.colour, glm::vec3(1e30f, -1e30f, .5f));
}

/// Stock POV-Ray shows it black, too.
TEST(Wire, LightThatIsNoNumberIsNone) {
    fake::Slice slice = slice_of(2, RayKind::full, Parts::shading);
    const float nan = std::numeric_limits<float>::quiet_NaN();
    slice.samples[0].colour = {.5f, nan, .25f};
    slice.samples[0].illumination = glm::vec3(nan);
    slice.samples[1].albedo.z = nan;
    const Bytes bytes = content(fake::answer_frame(slice));
    const auto answer = std::get<report::Answer>(decode_report(bytes));
    for (std::uint32_t i = 0; i < 2; ++i) {
        Sample sample{.position = {1, 2}};
        answer.read(i, sample);
        EXPECT_FALSE(sample.failed);
        if (i == 0) EXPECT_EQ(sample.colour, glm::vec3(.5f, 0, .25f));
        EXPECT_EQ(sample.albedo, glm::vec3(0));
        EXPECT_EQ(sample.remainder, sample.colour);
    }
}

TEST(Wire, AnAnswerOfALowerRungThanAskedIsRefused) {
    fake::Slice slice = slice_of(5, RayKind::full, Parts::colour);
    slice.rung = 1;
    const Bytes bytes = content(fake::answer_frame(slice));
    const auto answer = std::get<report::Answer>(decode_report(bytes));
    EXPECT_NO_THROW(answer.check_asked(100, {RayKind::full, 0, Parts::colour}));
    EXPECT_NO_THROW(answer.check_asked(100, {RayKind::full, 1, Parts::colour}));
    EXPECT_THROW(answer.check_asked(100, {RayKind::full, 2, Parts::colour}), WireFault);
    EXPECT_THROW(answer.check_asked(100, {RayKind::full, target_rung, Parts::colour}), WireFault);
    Sample sample{.position = {1, 2}, .rung = 0};
    answer.read(0, sample);
    EXPECT_EQ(sample.rung, 1);
}

TEST(Wire, EveryContradictionHasItsSentence) {
    const auto fault_if = [](const std::function<void(fake::Slice&)>& change) {
        fake::Slice slice = slice_of(5, RayKind::full, everything);
        change(slice);
        return fault_of(content(fake::answer_frame(slice)));
    };
    EXPECT_EQ(fault_if([](auto&) {}), "");
    EXPECT_EQ(fault_if([](auto& s) { s.count = 4; }), "5 colours in an answer of 4");
    EXPECT_EQ(fault_if([](auto& s) { s.count = 0; }), "an answer for samples 3 to 3 of a batch");
    EXPECT_EQ(fault_if([](auto& s) { s.first = 0xffffffff; }),
              "an answer for samples 4294967295 to 4294967300 of a batch");
    EXPECT_EQ(fault_if([](auto& s) { s.failed = {5}; }), "failed sample 5 in an answer of 5");
    EXPECT_EQ(fault_of(content(fake::scene_frame(0, 5))), "an image size of 0 x 5");
    EXPECT_EQ(fault_of(content(fake::progress_frame(6, 0, 0))), "an unknown stage (6)");
    EXPECT_EQ(fault_of(Bytes(64)), "bytes that are no report");
    EXPECT_EQ(fault_of(Bytes()), "bytes that are no report");
}

TEST(Wire, ASmallFrameCannotUnpackToAHugeScene) {
    EXPECT_EQ(fault_of(content(fake::swollen_scene_frame(4096, 256))), "");
    EXPECT_EQ(fault_of(content(fake::swollen_scene_frame(4097, 1))), "a scene of 4097 features");
    EXPECT_EQ(fault_of(content(fake::swollen_scene_frame(1, 257))), "a name of 257 characters");
}

TEST(Wire, AnAnswerWithoutWhatWasAskedIsRefused) {
    const auto refuses = [](RayKind sent, Parts with, RayKind asked, Parts parts) {
        const Bytes bytes = content(fake::answer_frame(slice_of(5, sent, with)));
        const auto answer = std::get<report::Answer>(decode_report(bytes));
        try {
            answer.check_asked(100, {asked, target_rung, parts});
        } catch (const WireFault&) {
            return true;
        }
        return false;
    };
    const Parts none = Parts::colour;
    EXPECT_TRUE(refuses(RayKind::probe, none, RayKind::full, none));
    EXPECT_TRUE(refuses(RayKind::full, none, RayKind::probe, none));
    EXPECT_TRUE(refuses(RayKind::full, none, RayKind::albedo, none));
    for (const Parts part : {Parts::surface, Parts::shading, Parts::signature}) {
        EXPECT_TRUE(refuses(RayKind::full, none, RayKind::full, part));
        EXPECT_FALSE(refuses(RayKind::full, part, RayKind::full, part));
    }
}

// ---- damage

TEST(Wire, EveryTruncationIsRefused) {
    for (const Bytes& frame : all_reports()) {
        const Bytes whole = content(frame);
        // Up to 7 bytes of padding may stand behind the last table.
        for (std::size_t size = 0; size + 8 <= whole.size(); ++size) {
            const Bytes cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
            EXPECT_THROW(decode_report(cut), WireFault) << size << " of " << whole.size();
        }
    }
}

TEST(Wire, CorruptionIsRefusedOrHarmless) {
    constexpr unsigned seed = 77;
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    int refused = 0, taken = 0;
    for (const Bytes& original : all_reports())
        for (int i = 0; i < 3000; ++i) {
            Bytes stream = original;
            for (unsigned n = 1 + random() % 4; n > 0; --n)
                stream[random() % stream.size()] = static_cast<std::byte>(random());
            if (random() % 4 == 0) stream.resize(random() % stream.size());
            (exercise_wire(stream, 1 + random() % 64) ? refused : taken) += 1;
        }
    EXPECT_GT(refused, 1000);
    EXPECT_GT(taken, 1000);
}

}  // namespace
}  // namespace povpreview
