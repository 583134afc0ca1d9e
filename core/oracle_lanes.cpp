// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/oracle_lanes.h"

namespace povpreview {

void OracleLanes::Lane::submit(std::span<const Request> requests, Parts parts) {
    if (requests.empty()) return;
    lanes_.oracle_.submit(requests, parts);
    lanes_.runs_.push_back({this, requests.size()});
}

void OracleLanes::Lane::collect(std::vector<Sample>& samples, std::chrono::nanoseconds patience) {
    lanes_.distribute(waiting_.empty() ? patience : std::chrono::nanoseconds::zero());
    samples.insert(samples.end(), waiting_.begin(), waiting_.end());
    waiting_.clear();
}

void OracleLanes::distribute(std::chrono::nanoseconds patience) {
    arrived_.clear();
    oracle_.collect(arrived_, patience);
    for (const Sample& sample : arrived_) {
        Run& run = runs_.front();
        run.lane->waiting_.push_back(sample);
        if (--run.left == 0) runs_.pop_front();
    }
}

}  // namespace povpreview
