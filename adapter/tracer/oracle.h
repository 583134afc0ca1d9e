// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "backend/oracle/known_pixels.h"
#include "backend/oracle/scene_facts.h"
#include "backend/oracle/wire_end.h"
#include "backend/oracle/work_queue.h"

namespace povpreview::tracer {

/// What the patches call to turn a run of POV-Ray into a sample oracle.
///
/// With POVPREVIEW_WIRE in the environment (the number of a descriptor, one end of a stream socket
/// pair) POV-Ray parses its scene once and then answers orders until the previewer closes its end.
/// Without it every function here does nothing and POV-Ray is what it always was.
class Oracle {
   public:
    static Oracle& instance();

    bool enabled() const { return socket_ >= 0; }
    /// Whether the previewer wants the scene's polygons: POVPREVIEW_GEOMETRY is in the environment.
    bool geometry_wanted() const { return geometry_wanted_; }
    /// Called when samples can be answered, and when no more are.
    void serve(bool serving = true) { serving_ = serving; }
    bool serving() const { return serving_; }
    /// The folder into which the previewer wants POV-Ray's image in the end (POVPREVIEW_FINISH in
    /// the environment); empty where it wants none.
    const std::string& finish_folder() const { return finish_folder_; }
    WorkQueue& queue() { return queue_; }
    KnownPixels& known() { return known_; }
    WireEnd& wire() { return *wire_; }

    /// Says Hello. Called when the options are known.
    void start(const std::string& povray, unsigned threads);

    /// The scene has been announced: the previewer makes a first picture, of about so many samples,
    /// before photons and radiosity are prepared for the target.
    void begin_first_look(std::int64_t samples);
    /// So many full samples have been traced without preparation.
    void note_early_samples(std::size_t count) {
        first_samples_left_ -= static_cast<std::int64_t>(count);
    }
    /// Whether the previewer has had the tracer for itself long enough for a first picture, or has
    /// no use for samples that come before the preparation.
    bool first_look_over();
    /// Whether the preparation comes first from now on, if both want the processors.
    bool preparation_first() const;

    /// Tells the previewer that a rung is ready when the radiosity pretrace has `advance`d so far,
    /// and again whenever it has taken twice as long as the last time.
    void announce_rung(std::uint8_t rung, std::uint64_t pretraced);

    /// Progress of a stage that counts what it has done; `total` 0: not known.
    void progress(Stage stage, std::uint64_t done, std::uint64_t total);
    /// The same for a stage that several threads advance.
    void expect(Stage stage, std::uint64_t total);
    void advance(std::uint64_t done);

    /// Keeps the name of a file that was opened for reading.
    void note_read(const std::string& file);
    std::vector<std::string> files_read();

    /// Keeps POV-Ray's message for `fail`. Its errors are certain or possible ones; the latter may
    /// turn out to explain a later, certain one.
    void note_error(const std::string& text, const std::string& file, long line, bool certain);
    /// Passes on what was noted, or else `text`, as the last word.
    void fail(const std::string& text);

   private:
    using Clock = std::chrono::steady_clock;
    Oracle();

    int socket_ = -1;
    bool geometry_wanted_ = false;
    std::string finish_folder_;
    WorkQueue queue_;
    KnownPixels known_;
    std::unique_ptr<WireEnd> wire_;
    std::atomic<bool> serving_{false};

    std::mutex files_mutex_;
    std::set<std::string> files_;

    std::mutex error_mutex_;
    std::string error_, error_file_;
    std::string earlier_possible_error_, possible_error_;  ///< the last two
    unsigned error_line_ = 0;

    std::atomic<Stage> stage_{Stage::parsing};
    std::atomic<std::uint64_t> done_{0}, total_{0};
    std::uint8_t announced_rung_ = 0;
    std::uint64_t announced_from_ = UINT64_MAX;
    std::atomic<Clock::rep> announced_at_{0};  // after stage_begun_
    Clock::time_point stage_begun_;
    std::atomic<Clock::rep> first_look_from_{0};
    std::atomic<std::int64_t> first_samples_left_{0};
    std::atomic<bool> first_look_over_{false};
};

/// Short for use inside POV-Ray.
inline bool enabled() { return Oracle::instance().enabled(); }

/// POV-Ray's threads ask each other by polling every 10 to 100 ms, and a start takes five or six
/// such rounds: .25 s in which nothing happens. Milliseconds to wait instead of `usual` ones.
inline unsigned poll_interval(unsigned usual) {
    constexpr unsigned prompt = 1, unnoticed = 5;
    const Oracle& oracle = Oracle::instance();
    if (!oracle.enabled()) return usual;
    return std::min(usual, oracle.serving() ? unnoticed : prompt);
}

/// The previewer has asked for the image, of so many pixels, and POV-Ray begins to make it.
inline void begin_image(std::uint64_t pixels) {
    Oracle::instance().serve(false);
    Oracle::instance().expect(Stage::finishing, pixels);
}

}  // namespace povpreview::tracer
