// SPDX-License-Identifier: AGPL-3.0-or-later
#include "backend/oracle/pretrace_rounds.h"

#include <algorithm>
#include <chrono>

namespace povpreview::tracer {

namespace {

/// Blocks of a round: in the first step a share of those that are done, and one at least; later,
/// where what most blocks need is there, of all. On cornell and patio-radio_37 halving or doubling
/// either makes no difference; rounds of two blocks at first cost 4 % more.
constexpr unsigned share_of_done = 4, share_of_all = 8;

}  // namespace

PretraceRounds::PretraceRounds(unsigned blocks, unsigned steps) : blocks_(blocks), steps_(steps) {
    begin_round();
}

void PretraceRounds::begin_round() {
    const unsigned size = step_ == 0 ? next_ / share_of_done : blocks_ / share_of_all;
    end_ = std::min(blocks_, next_ + std::max(1u, size));
}

PretraceRounds::Answer PretraceRounds::next(Turn& turn) {
    std::unique_lock lock(mutex_);
    if (next_ == end_ && step_ < steps_) begun_.wait_for(lock, std::chrono::milliseconds(5));
    if (step_ == steps_) return over;
    if (next_ == end_) return wait;
    turn = {next_++, step_, round_};
    ++running_;
    return taken;
}

void PretraceRounds::done() {
    const std::lock_guard lock(mutex_);
    if (--running_ > 0 || next_ < end_) return;
    ++round_;
    if (next_ == blocks_) {
        next_ = 0;
        ++step_;
    }
    if (step_ < steps_) begin_round();
    begun_.notify_all();
}

}  // namespace povpreview::tracer
