// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "core/oracle.h"

namespace povpreview {

/// An oracle to which one rung of the ladder is the target: whoever asks it climbs nowhere.
class FixedRung : public SampleOracle {
   public:
    FixedRung(SampleOracle& oracle, Rung rung) : oracle_(oracle), rung_(rung) {}

    void submit(std::span<const Request> requests, Parts parts) override {
        requests_.assign(requests.begin(), requests.end());
        for (Request& request : requests_)
            if (request.kind == RayKind::full) request.rung = rung_;
        oracle_.submit(requests_, parts);
    }
    void collect(std::vector<Sample>& samples, std::chrono::nanoseconds patience) override {
        const std::size_t before = samples.size();
        oracle_.collect(samples, patience);
        for (std::size_t i = before; i < samples.size(); ++i) samples[i].rung = target_rung;
    }

   private:
    SampleOracle& oracle_;
    Rung rung_;
    std::vector<Request> requests_;
};

}  // namespace povpreview
