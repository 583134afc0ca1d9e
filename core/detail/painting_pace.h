// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <atomic>
#include <chrono>
#include <thread>

namespace povpreview {

/// How painting gets on beside the samples that are traced at the same time. It is shared by all
/// threads that paint.
class PaintingPace {
   public:
    using Clock = std::chrono::steady_clock;

    /// Painting that begins now.
    PaintingPace() = default;

    /// Ends it as soon as may be; what it has come to is of no use.
    void stop() { stopped_ = true; }
    bool stopped() const { return stopped_; }

    /// To be called after each row that was worked on. At first samples tell more than what is
    /// painted, and whoever has waited for one is let in at once: the system itself lets a thread
    /// that works go on for milliseconds, however low its priority. Later that would be too little
    /// of the processors, of which the tracer takes all that it can get.
    void row_done() const {
        thread_local Clock::time_point let_in{};
        const Clock::time_point now = Clock::now();
        if (now > early_until_ || now - let_in < turn) return;
        std::this_thread::yield();
        let_in = Clock::now();
    }

   private:
    static constexpr std::chrono::microseconds turn{50};
    static constexpr std::chrono::milliseconds early{200};

    std::atomic<bool> stopped_{false};
    const Clock::time_point early_until_ = Clock::now() + early;
};

}  // namespace povpreview
