// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/oracle.h"
#include "core/previewer.h"

namespace povpreview {

/// Leads one previewer and one oracle through a run.
///
/// A window of requests is kept outstanding so that the tracer never waits. Samples are chosen one
/// by one after each answer, so what is asked for depends on the answers alone and not on how they
/// come grouped in time: equal scenes give equal runs.
class Session {
   public:
    struct Counts {
        std::size_t full = 0, probe = 0, albedo = 0;  ///< answers accepted
        std::size_t failed = 0;                       ///< those of them without a value
        /// What they cost the tracer, by RayKind: nanoseconds of one thread.
        std::array<std::uint64_t, 3> cost_ns{};
    };

    /// Both must outlive the session.
    Session(Previewer& previewer, SampleOracle& oracle);

    /// Asks for no more full rays than this, from the run's beginning on. A run that has stopped
    /// there goes on when the limit is raised.
    void limit_full(std::size_t limit) { full_limit_ = limit; }

    /// For now asks for no more full rays than this, and for nothing else once it has; what was
    /// asked for comes.
    void pause_at(std::size_t full) { pause_at_ = full; }
    bool paused() const { return full_asked_ >= pause_at_; }

    /// One round: takes the answers that have come, waiting at most `patience` for the first, and
    /// submits what the previewer wants next. Returns whether the run goes on.
    bool advance(std::chrono::nanoseconds patience);

    const Counts& counts() const { return counts_; }
    /// Seconds spent on choosing samples and on their answers, without the waiting.
    double own_s() const { return std::chrono::duration<double>(own_).count(); }
    std::size_t outstanding() const { return outstanding_; }

   private:
    using Clock = std::chrono::steady_clock;
    std::size_t window() const;
    std::size_t queued_for_latency() const;
    void accept(const Sample& sample);
    void choose();
    void submit();

    Previewer& previewer_;
    SampleOracle& oracle_;
    std::size_t full_limit_ = std::numeric_limits<std::size_t>::max();
    std::size_t pause_at_ = std::numeric_limits<std::size_t>::max();
    std::size_t full_asked_ = 0, accepted_ = 0, outstanding_ = 0;
    Counts counts_;
    Clock::duration own_{};
    std::vector<Request> requests_;  // chosen and not yet submitted
    Parts parts_{};                  // of those
    std::vector<Sample> answers_;
};

}  // namespace povpreview
