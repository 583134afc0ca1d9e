// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <memory>
#include <mutex>

#include "backend/oracle/samples.h"

namespace povpreview::tracer {

/// A run of positions within a batch, to be traced by one thread in one go.
struct Slice {
    std::shared_ptr<const Batch> batch;
    std::size_t first = 0, count = 0;
};

/// The batches received and not yet traced, handed out to POV-Ray's threads in slices, in order.
///
/// Slices are short enough for an answer to leave about every `slice_time`, whatever a sample
/// costs: the queue learns the cost of each kind of ray and rung from the threads. What waits is
/// shared, so that no thread idles while another traces what is left: answers reach the previewer
/// in order, and where few are outstanding it asks for nothing before the oldest has come.
///
/// Full samples of the target rung are held back until photons and radiosity are prepared for them;
/// all else may be traced before.
class WorkQueue {
   public:
    /// More samples than this wait for nobody: the previewer breaks its promise (see `add`).
    static constexpr std::size_t max_waiting = std::size_t{1} << 22;
    static constexpr std::size_t max_slice = 1024;
    static constexpr std::chrono::nanoseconds slice_time = std::chrono::milliseconds(5);
    /// What is traced in less time than this is not shared: an answer costs time as well.
    static constexpr std::chrono::nanoseconds least_slice_time = std::chrono::microseconds(200);

    void set_threads(std::size_t threads);

    /// Appends a batch; false if the queue would exceed `max_waiting` samples.
    bool add(std::shared_ptr<const Batch> batch);

    /// No more orders come: the threads may go when all that waits is traced.
    void close();
    /// Closed, and nothing waits.
    bool finished();

    /// The next slice; an empty one when none came within `patience`. Those who cannot trace for
    /// the target get nothing any more, at once, when it is ready.
    Slice take(std::chrono::nanoseconds patience, bool for_target);

    /// Hands out what was held back, from now on.
    void release_target();
    bool target_released();
    /// Samples are wanted, and all of them are held back.
    bool only_target_wanted();

    /// Tells what tracing `count` samples of a batch cost altogether.
    void learn(const Batch& batch, std::size_t count, std::chrono::nanoseconds cost);
    /// How many samples were traced so far.
    std::size_t traced();

   private:
    std::size_t slice_size(const Batch& batch) const;

    static std::size_t cost_class(const Batch& batch);
    void append(std::shared_ptr<const Batch> batch);

    std::mutex mutex_;
    std::condition_variable filled_;
    std::deque<std::shared_ptr<const Batch>> batches_;
    std::deque<std::shared_ptr<const Batch>> held_;  ///< for the target, until it is ready
    std::size_t held_positions_ = 0;
    bool target_released_ = false;
    std::size_t taken_ = 0;    ///< positions of the oldest batch already handed out
    std::size_t waiting_ = 0;  ///< positions in the queue not yet handed out
    std::size_t traced_ = 0;
    std::size_t threads_ = 1;
    bool closed_ = false;
    /// Mean cost of a sample, ns; starts at a guess that makes the first slices short.
    std::array<double, 5> cost_{100e3, 100e3, 100e3, 100e3, 100e3};
};

}  // namespace povpreview::tracer
