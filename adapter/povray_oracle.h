// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "adapter/crash_search.h"
#include "adapter/geometry_arrival.h"
#include "adapter/sample_queue.h"
#include "adapter/scene.h"
#include "adapter/tracer_process.h"
#include "adapter/wire.h"
#include "core/error.h"
#include "core/oracle.h"

namespace povpreview {

/// What the tracer has done so far.
struct TracerStatistics {
    std::array<std::uint64_t, 3> rays{};  ///< answered, by RayKind
    std::uint64_t failed = 0;             ///< of them, answered by a failed sample
    unsigned restarts = 0;                ///< times it died and was started again
    double busy = 0;  ///< share of the time since the scene came that it had something to do, 0..1

    std::uint64_t of(RayKind kind) const { return rays[static_cast<std::size_t>(kind)]; }
};

/// A patched POV-Ray in a process of its own, as a SampleOracle.
///
/// Orders are pipelined: whatever is submitted is sent at once, and answers are put back in the
/// order of the requests. A tracer that dies is started again, and what it had not answered is sent
/// again; a sample that kills it time and again is answered as failed, and faults() says so. What
/// cannot be mended (a scene error, garbage, a stall, dying on and on) ends the tracer and throws
/// Error, from then on from every call. All calls must come from one thread, and that thread must
/// live as long as the oracle (see TracerProcess).
class PovrayOracle : public SampleOracle {
   public:
    struct Settings {
        std::string program;                       ///< the patched POV-Ray
        std::vector<std::string> arguments;        ///< POV-Ray's options, see povray_options.h
        bool geometry = true;                      ///< ask for the scene's polygons
        bool writes = false;                       ///< the scene may write files
        std::filesystem::path finish_folder = {};  ///< for finish(): a folder of its own
        std::optional<SandboxRules> sandbox = {};  ///< else it may do what we may
        FileWatch* watch = nullptr;                ///< is told what files it opens, or nobody
        /// Silence while answers are outstanding that counts as a stall. Parsing has no limit.
        std::chrono::milliseconds stall_timeout = std::chrono::seconds(60);
    };

    /// Starts the tracer, and returns while it still parses. Throws Error if it cannot be started.
    explicit PovrayOracle(Settings settings);
    ~PovrayOracle() override;

    /// Waits until the scene is parsed. `progress` (may be empty) is called for every step that the
    /// tracer reports, `interrupted` (may be empty) about twenty times a second. Throws Error:
    /// Exit::scene with POV-Ray's message if the scene is at fault, Exit::interrupted as soon as
    /// `interrupted` says so, Exit::tracer otherwise.
    const SceneDescription& wait_for_scene(
        const std::function<void(const report::Progress&)>& progress,
        const std::function<bool()>& interrupted);

    /// The scene's polygons, once, when all of them have come; they come beside the samples, soon
    /// after the scene. Nothing before that and afterwards.
    std::optional<Geometry> take_geometry() { return arrival_.take_geometry(); }
    /// Waits until take_geometry() has something to give, or has given it. Throws Error as
    /// wait_for_scene() does, and after a silence as long as a stall. REQUIRES: the scene has come,
    /// and Settings::geometry asked for its polygons.
    void wait_for_geometry(const std::function<bool()>& interrupted);

    /// The texels of Geometry::images, once, when all of them have come, which is after the
    /// geometry. Nothing before that and afterwards.
    std::optional<std::vector<ImageTexels>> take_images() { return arrival_.take_images(); }
    /// As wait_for_geometry(), for take_images().
    void wait_for_images(const std::function<bool()>& interrupted);

    void submit(std::span<const Request> requests, Parts parts) override;
    /// As SampleOracle says; a signal ends the wait early.
    void collect(std::vector<Sample>& samples, std::chrono::nanoseconds patience) override;

    /// Has POV-Ray make its image, as its options ask for, out of all pixels of the completed
    /// picture, row by row; what they do not tell, such as its samples for anti-aliasing, it
    /// traces. Returns the image's file in Settings::finish_folder, to be called
    /// description().output. This ends the tracer. A tracer that dies is started again once. Throws
    /// Error as wait_for_scene() does. REQUIRES: the scene has come, a finish_folder, and every
    /// request is answered.
    std::filesystem::path finish(std::span<const PixelLight> pixels,
                                 const std::function<void(const report::Progress&)>& progress,
                                 const std::function<bool()>& interrupted);
    /// Hears what the tracer has to tell within `patience` beside samples.
    void listen(std::chrono::nanoseconds patience);
    /// How often each rung of the scene's ladder has become ready, or better; by tracers that have
    /// died since, too. REQUIRES: the scene has come.
    const std::vector<unsigned>& rungs_ready() const { return ready_; }
    bool target_ready() const { return ready_.back() > 0; }
    /// The tracer's last step towards that.
    const report::Progress& preparation() const { return preparation_; }

    TracerStatistics statistics() const;
    /// The most memory that the tracer has had resident so far, bytes; 0 where it is not known.
    std::size_t peak_memory() const { return process_ ? process_->peak_memory() : 0; }
    /// What was mended, a sentence each; the first hundred.
    const std::vector<std::string>& faults() const { return faults_; }
    /// The tracer's introduction; empty before the scene has come.
    const report::Hello& tracer() const { return hello_; }

   private:
    using Clock = std::chrono::steady_clock;
    enum class State { greeting, parsing, serving, finishing, ended };

    /// Samples under one id on the wire; the i-th one is number first + offsets[i], or first + i.
    struct Batch {
        BatchKind kind;
        Sequence first;
        std::uint32_t count = 0, answered = 0;
        std::vector<std::uint32_t> offsets;  ///< empty where they follow one another
        Sequence sequence(std::uint32_t i) const {
            return first + (offsets.empty() ? i : offsets[i]);
        }
    };

    void start();
    bool advance(Clock::time_point deadline);
    bool receive();
    void handle(std::span<const std::byte> frame);
    void handle_hello(const report::Hello& hello);
    void handle_scene(SceneDescription scene);
    void handle_answer(const report::Answer& answer);
    void wait_until(const std::function<bool()>& come, const char* awaited,
                    const std::function<bool()>& interrupted);
    void handle_ready(const report::RungReady& ready);
    [[noreturn]] void handle_failure(const report::Failure& failure);

    void send_image(std::span<const PixelLight> pixels);
    void send_waiting();
    void send_range(Sequence begin, Sequence end);
    void send_batch(Batch batch);
    void flush();

    void restart();
    void leave_out(Sequence killer);
    void answer_failed(Sequence sequence);
    bool is_killer(const Request& request) const;
    void set_outstanding(std::size_t count);
    void check_stall(Clock::time_point before, Clock::time_point deadline);
    void remember(std::string fault);
    [[noreturn]] void fail(Exit exit, const std::string& cause, const std::string& remedy);

    Settings settings_;
    State state_ = State::greeting;
    std::unique_ptr<TracerProcess> process_;
    std::optional<Error> broken_;  ///< thrown by every call from now on

    FrameReader reader_;
    std::vector<std::byte> received_;  ///< room for one receive
    std::vector<std::byte> out_;       ///< to be sent, from out_sent_ on
    std::size_t out_sent_ = 0;

    SampleQueue queue_;
    Sequence sent_end_ = 0;  ///< everything before it has been sent to this process, or answered
    std::deque<Batch> batches_;
    std::uint64_t first_batch_ = 1;  ///< id of batches_.front()
    std::size_t outstanding_ = 0;    ///< samples sent to this process and not answered
    std::vector<glm::dvec2> positions_;

    CrashSearch crash_search_;
    int barren_deaths_ = 0;         ///< in a row, without an answer between
    std::vector<Request> killers_;  ///< not sent again: every one costs parsing anew

    report::Hello hello_;
    std::optional<SceneDescription> scene_;
    std::vector<unsigned> ready_;  ///< by rung: how often that was said
    report::Progress preparation_;
    std::function<void(const report::Progress&)> progress_;

    GeometryArrival arrival_;
    const char* awaited_ = nullptr;  ///< what is due beside samples, or null
    std::vector<std::string> faults_;

    TracerStatistics statistics_;
    Clock::time_point scene_at_{}, busy_since_{}, last_look_{};
    Clock::duration busy_{}, silence_{};
};

}  // namespace povpreview
