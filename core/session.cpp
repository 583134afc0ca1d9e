// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/session.h"

#include <algorithm>
#include <cstdint>

namespace povpreview {

/// Enough for the tracer's threads and the previewer to work at the same time, each on a share.
constexpr std::size_t submissions_per_window = 8;

Session::Session(Previewer& previewer, SampleOracle& oracle)
    : previewer_(previewer), oracle_(oracle) {}

/// Requests outstanding at a time. Few at first, when each answer says much about where the next
/// sample should go; more later, when a choice made too early costs little and latency counts.
std::size_t Session::window() const {
    return std::clamp<std::size_t>(std::max(256 + accepted_ / 16, queued_for_latency()), 256,
                                   16384);
}

/// Requests for the time that we may be away, since other threads want the processor as well: the
/// tracer shall not wait. Where the number of samples is limited, equal scenes give equal runs, and
/// what samples cost is not looked at.
std::size_t Session::queued_for_latency() const {
    constexpr double away_ns = 8e6;  // of one thread of the tracer: 4 ms of two
    constexpr std::size_t known_after = 128, most = 4096;
    const auto full_ns = static_cast<double>(counts_.cost_ns[static_cast<int>(RayKind::full)]);
    if (counts_.full < known_after || full_ns <= 0 || full_limit_ != SIZE_MAX) return 0;
    const double wanted = away_ns * static_cast<double>(counts_.full) / full_ns;
    // No more than a share of what has come: that tells where to ask next.
    return std::min({static_cast<std::size_t>(wanted), 2 * counts_.full, most});
}

void Session::choose() {
    // At the limit not even a probe is of use: it leads to full rays only.
    while (!paused() && outstanding_ < window() && full_asked_ < full_limit_) {
        const auto request = previewer_.next();
        if (!request) return;
        if (request->kind == RayKind::full) ++full_asked_;
        // Those that it wanted when it asked, however late they are submitted.
        if (const Parts parts = previewer_.parts(); parts != parts_) {
            submit();
            parts_ = parts;
        }
        requests_.push_back(*request);
        ++outstanding_;
    }
}

void Session::submit() {
    if (requests_.empty()) return;
    oracle_.submit(requests_, parts_);
    requests_.clear();
}

void Session::accept(const Sample& sample) {
    --outstanding_;
    ++accepted_;
    switch (sample.kind) {
        case RayKind::full:
            ++counts_.full;
            break;
        case RayKind::probe:
            ++counts_.probe;
            break;
        case RayKind::albedo:
            ++counts_.albedo;
            break;
    }
    counts_.cost_ns[static_cast<std::size_t>(sample.kind)] += sample.cost_ns;
    if (sample.failed) ++counts_.failed;
    previewer_.accept(sample);
}

bool Session::advance(std::chrono::nanoseconds patience) {
    const Clock::time_point begin = Clock::now();
    choose();  // finds nothing but on the first round, or after the limit was raised
    submit();
    answers_.clear();
    const Clock::time_point asked = Clock::now();
    if (outstanding_ > 0) oracle_.collect(answers_, patience);
    const Clock::time_point answered = Clock::now();
    for (const Sample& sample : answers_) {
        accept(sample);
        choose();
        // The tracer need not wait until all that has come is dealt with.
        if (requests_.size() >= window() / submissions_per_window) submit();
    }
    submit();
    own_ += (asked - begin) + (Clock::now() - answered);
    return outstanding_ > 0;
}

}  // namespace povpreview
