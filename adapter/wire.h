// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <span>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "adapter/geometry.h"
#include "adapter/scene.h"
#include "core/oracle.h"
#include "core/pixel_light.h"

/// The wire between previewer and tracer as pure functions on bytes; the schema is wire.fbs.
///
///     | size: u32, little endian | flatbuffer of `size` bytes | size | flatbuffer | ...
///
/// Nothing from the other end is believed: sizes are limited before anything is allocated for them,
/// buffers are verified before they are read, and every count is checked against every other.
namespace povpreview {

namespace wire {
struct Answer;  // the generated table
}

/// Version of the schema; both ends must have the same.
constexpr std::uint32_t wire_version = 9;
/// A frame's flatbuffer is at most this long, bytes. Room for 2^17 samples with all their parts, or
/// for a scene of 10^5 lights.
constexpr std::size_t wire_max_frame = std::size_t{16} << 20;
/// Samples in one batch at most: one Trace order is then about 1 MiB.
constexpr std::uint32_t wire_max_batch = 1u << 16;

/// Texels of all images of a scene at most.
constexpr std::uint32_t wire_max_texels = 8'000'000;

/// The tracer broke the protocol; the text says how, as the end of "the tracer sent ...".
class WireFault : public std::runtime_error {
   public:
    using std::runtime_error::runtime_error;
};

/// Cuts a stream of bytes into frames, however the stream is chunked.
class FrameReader {
   public:
    /// Calls `frame` for every frame that `bytes` complete; the span is valid during the call and
    /// aligned for any flatbuffer. Throws WireFault on a size that cannot be.
    void feed(std::span<const std::byte> bytes,
              const std::function<void(std::span<const std::byte>)>& frame);
    /// A frame has begun and is not complete.
    bool inside_frame() const { return header_have_ > 0; }

   private:
    std::size_t take_header(std::span<const std::byte> bytes);

    std::uint8_t header_[4] = {};
    std::size_t header_have_ = 0;  ///< bytes of header_ that have come
    std::size_t size_ = 0;         ///< of the frame, known once the header is there
    std::vector<std::byte> body_;  ///< grows as bytes come, not as the header claims
};

/// Rungs of a scene at most.
constexpr std::size_t wire_max_rungs = 8;

/// What the samples of a batch have in common.
struct BatchKind {
    RayKind kind = RayKind::full;
    Rung rung = target_rung;
    Parts parts = Parts::colour;
};
/// Appends a frame with a Trace order. REQUIRES: 0 < positions.size() <= wire_max_batch.
void append_trace(std::vector<std::byte>& out, std::uint64_t batch, const BatchKind& kind,
                  std::span<const glm::dvec2> positions);

/// Appends a frame with a part of the completed picture, from the pixel `first` on; `last` has
/// POV-Ray make its image of all. REQUIRES: pixels.size() <= wire_max_batch.
void append_image(std::vector<std::byte>& out, std::uint32_t first,
                  std::span<const PixelLight> pixels, bool last);

/// What the tracer reports, decoded.
namespace report {

struct Hello {
    std::uint32_t version = 0;
    std::string povray;         ///< version of POV-Ray, for the log
    std::uint32_t threads = 0;  ///< that trace
};

enum class Stage : std::uint8_t { parsing, bounding, photons, radiosity, ready, finishing };

struct Progress {
    Stage stage = Stage::parsing;
    std::uint64_t done = 0, total = 0;  ///< in units of the stage's own; total 0: not known
};

/// The tracer's last word, POV-Ray's own.
struct Failure {
    std::string message;
    std::string file;  ///< empty where it has no place in a file
    std::uint32_t line = 0;
};

/// A verified slice of a batch's answers. A view: valid as long as the frame it was decoded from.
class Answer {
   public:
    explicit Answer(const wire::Answer& table);  ///< throws WireFault if its counts disagree

    std::uint64_t batch() const { return batch_; }
    std::uint32_t first() const { return first_; }  ///< offset in the batch of its first sample
    std::uint32_t count() const { return count_; }
    Rung rung() const { return rung_; }

    /// Throws WireFault unless it lies inside a batch of `batch_count` samples and carries what was
    /// asked of rays of this kind.
    void check_asked(std::uint32_t batch_count, const BatchKind& asked) const;
    /// Writes the i-th sample over `sample`, except for its position and kind. A sample whose
    /// depth, normal or transmittance is not finite comes out as failed; light that is no number is
    /// none, and beyond 1e30 it is cut down to that. REQUIRES: i < count().
    void read(std::uint32_t i, Sample& sample) const;

   private:
    const wire::Answer* table_;
    std::uint64_t batch_;
    std::uint32_t first_, count_;
    Rung rung_;
    std::vector<bool> failed_;  ///< empty, or by offset
};

/// A rung that was not ready is now, by its number on the scene's ladder; the last is the target.
/// Or one that was has become better.
struct RungReady {
    std::uint8_t rung = 0;
};

/// Part of what can be drawn of the scene. Indices are in range and counts agree, but those of
/// looks and images, which may be in other parts; conditions run on a stack as deep as allowed and
/// leave one value; coordinates may be anything.
struct GeometryChunk {
    Geometry part;
    bool last = false;
};

/// Texels of an image, from the first on, in its rows; which images there are and how large they
/// are, the geometry says.
struct Texels {
    std::uint32_t image = 0, first = 0;
    std::vector<std::array<std::uint16_t, 4>> texels;
};

}  // namespace report

using Report =
    std::variant<report::Hello, report::Progress, report::Failure, report::Answer,
                 report::GeometryChunk, report::Texels, report::RungReady, SceneDescription>;

/// Decodes one frame. Throws WireFault on anything but a well-formed report. REQUIRES: `frame`
/// starts at an address that is a multiple of 8, as FrameReader's do.
Report decode_report(std::span<const std::byte> frame);

}  // namespace povpreview
