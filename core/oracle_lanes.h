// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <deque>
#include <vector>

#include "core/oracle.h"

namespace povpreview {

/// Lets two previewers share one oracle: each lane is an ordered pipe of its own, and the answers
/// that arrive for the other lane wait there for it.
class OracleLanes {
   public:
    explicit OracleLanes(SampleOracle& oracle)
        : oracle_(oracle), lanes_{Lane(*this), Lane(*this)} {}
    OracleLanes(const OracleLanes&) = delete;
    OracleLanes& operator=(const OracleLanes&) = delete;

    SampleOracle& lane(int index) { return lanes_[static_cast<std::size_t>(index)]; }

   private:
    class Lane : public SampleOracle {
       public:
        explicit Lane(OracleLanes& lanes) : lanes_(lanes) {}
        void submit(std::span<const Request> requests, Parts parts) override;
        void collect(std::vector<Sample>& samples, std::chrono::nanoseconds patience) override;

       private:
        friend OracleLanes;
        OracleLanes& lanes_;
        std::vector<Sample> waiting_;
    };
    /// Requests that follow each other in the shared pipe and belong to one lane.
    struct Run {
        Lane* lane;
        std::size_t left;
    };

    void distribute(std::chrono::nanoseconds patience);

    SampleOracle& oracle_;
    std::array<Lane, 2> lanes_;
    std::deque<Run> runs_;
    std::vector<Sample> arrived_;
};

}  // namespace povpreview
