// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "backend/oracle/geometry_facts.h"
#include "backend/oracle/known_pixels.h"
#include "backend/oracle/samples.h"
#include "backend/oracle/scene_facts.h"
#include "backend/oracle/work_queue.h"

namespace povpreview::tracer {

/// As wire::Stage.
enum class Stage : std::uint8_t { parsing, bounding, photons, radiosity, ready, finishing };

/// The tracer's end of the wire (see wire.fbs): a thread reads orders, another writes reports.
///
/// Its threads never run POV-Ray's code and POV-Ray's threads never wait for the socket. When the
/// previewer goes away the process ends there and then, whatever POV-Ray is busy with; nothing
/// that it has is worth saving.
class WireEnd {
   public:
    static constexpr std::uint32_t version = 9;
    static constexpr std::size_t max_frame = 16u << 20;
    static constexpr std::size_t max_positions = std::size_t{1} << 20;
    /// How often progress is reported while the previewer waits for the scene.
    static constexpr std::chrono::milliseconds heartbeat{150};

    /// Takes over the socket, says Hello and starts the threads.
    WireEnd(int socket, const std::string& povray, unsigned threads, WorkQueue& queue,
            KnownPixels& known);
    WireEnd(const WireEnd&) = delete;
    WireEnd& operator=(const WireEnd&) = delete;

    /// Cheap enough for inner loops. A later stage ends the earlier one; `ready` ends progress.
    void progress(Stage stage, std::uint64_t done, std::uint64_t total);
    void send_scene(const SceneFacts& scene);
    /// `rung`: the one that full samples were traced at, that asked for or a higher one.
    void send_answer(const Slice& slice, std::uint8_t rung, const std::vector<Sample>& samples);
    /// A rung is ready from now on, by its place on the ladder.
    void send_rung_ready(std::uint8_t rung);
    void send_geometry(const GeometryChunk& chunk);
    void send_texels(const TexelChunk& chunk);
    /// Whether something waits to be sent.
    bool is_busy();
    /// The last word: returns when it is written, or when the previewer does not read.
    void send_failure(const std::string& message, const std::string& file, unsigned line);

   private:
    using Frame = std::vector<std::uint8_t>;

    void read_orders();
    void read_exactly(void* data, std::size_t size, bool end_allowed);
    void accept_order(const Frame& content);
    void write_reports();
    void send(Frame frame);
    bool try_write(Frame& frame);
    void write_all(const Frame& frame);

    int socket_;
    WorkQueue& queue_;
    KnownPixels& known_;
    std::atomic<Stage> stage_{Stage::parsing};
    std::atomic<std::uint64_t> done_{0}, total_{0};

    std::mutex mutex_;  ///< guards the frames and, while none waits, the writing side of the socket
    std::condition_variable filled_, drained_;
    std::deque<Frame> frames_;
    bool writing_ = false;  ///< the writer thread is in the middle of a frame
    std::thread reader_, writer_;
};

}  // namespace povpreview::tracer
