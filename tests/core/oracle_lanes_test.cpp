// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/oracle_lanes.h"

#include <gtest/gtest.h>

#include <deque>

namespace povpreview {
namespace {

using namespace std::chrono_literals;

/// Answers at most `grain` requests per collect().
class GrainyOracle : public SampleOracle {
   public:
    explicit GrainyOracle(std::size_t grain) : grain_(grain) {}
    void submit(std::span<const Request> requests, Parts) override {
        queue_.insert(queue_.end(), requests.begin(), requests.end());
    }
    void collect(std::vector<Sample>& samples, std::chrono::nanoseconds) override {
        for (std::size_t i = 0; i < grain_ && !queue_.empty(); ++i) {
            samples.emplace_back().position = queue_.front().position;
            queue_.pop_front();
        }
    }

   private:
    std::size_t grain_;
    std::deque<Request> queue_;
};

class OracleLanesTest : public ::testing::TestWithParam<std::size_t> {};

TEST_P(OracleLanesTest, EachLaneGetsItsOwnAnswersInOrder) {
    GrainyOracle oracle(GetParam());
    OracleLanes lanes(oracle);
    for (int round = 0; round < 20; ++round)
        for (int lane = 0; lane < 2; ++lane) {
            std::vector<Request> requests;
            for (int i = 0; i <= round % 4; ++i) requests.push_back({{lane, round * 10 + i}});
            lanes.lane(lane).submit(requests, Parts::colour);
        }
    std::array<std::vector<Sample>, 2> answers;
    for (int i = 0; i < 200; ++i)
        for (int lane = 0; lane < 2; ++lane)
            lanes.lane(lane).collect(answers[static_cast<std::size_t>(lane)], 0ms);
    for (int lane = 0; lane < 2; ++lane) {
        const auto& got = answers[static_cast<std::size_t>(lane)];
        ASSERT_EQ(got.size(), 50u);
        for (std::size_t i = 0; i < got.size(); ++i) {
            EXPECT_EQ(got[i].position.x, lane);
            if (i > 0) {
                EXPECT_LT(got[i - 1].position.y, got[i].position.y);
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Grains, OracleLanesTest, ::testing::Values(1, 3, 1000));

}  // namespace
}  // namespace povpreview
