// SPDX-License-Identifier: AGPL-3.0-or-later
#include "adapter/sample_queue.h"

#include <gtest/gtest.h>

#include <random>

namespace povpreview {
namespace {

TEST(SampleQueue, GivesEveryAnswerOnceInOrder) {
    constexpr unsigned seed = 11;
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    SampleQueue queue;
    std::vector<Sequence> waiting;
    std::vector<Sample> taken;
    double pushed = 0;
    for (int round = 0; round < 2000; ++round) {
        for (unsigned n = random() % 40; n > 0; --n) {
            waiting.push_back(queue.end());
            queue.push({{pushed++, 0}, RayKind::full}, Parts::surface);
        }
        std::shuffle(waiting.begin(), waiting.end(), random);
        for (unsigned n = random() % 45; n > 0 && !waiting.empty(); --n) {
            EXPECT_FALSE(queue.answered(waiting.back()));
            queue[waiting.back()].answered = true;
            waiting.pop_back();
        }
        queue.take(taken);
        EXPECT_EQ(queue.first_gap(), queue.begin());
        EXPECT_EQ(queue.begin(), taken.size());
    }
    for (const Sequence s : waiting) queue[s].answered = true;
    EXPECT_EQ(queue.first_gap(), queue.end());
    queue.take(taken);
    EXPECT_TRUE(queue.empty());
    ASSERT_EQ(taken.size(), static_cast<std::size_t>(pushed));
    for (std::size_t i = 0; i < taken.size(); ++i)
        EXPECT_EQ(taken[i].position.x, static_cast<double>(i));
}

}  // namespace
}  // namespace povpreview
