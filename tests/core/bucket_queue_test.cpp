// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/bucket_queue.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <random>

namespace povpreview::test {
namespace {

TEST(BucketQueue, GivesTheHeaviestToWithinAnEighthOfAPowerOfTwo) {
    std::mt19937 random(3);
    BucketQueue<int> queue;
    std::multimap<float, int> held;
    std::vector<float> weights;
    for (int turn = 0; turn < 20000; ++turn) {
        if (held.empty() || random() % 3 > 0) {
            weights.push_back(std::exp2(float(random() % 4000) / 100 - 22));
            queue.push(weights.back(), int(weights.size()) - 1);
            held.emplace(weights.back(), int(weights.size()) - 1);
        } else {
            const int thing = queue.pop();
            const float weight = weights[std::size_t(thing)];
            EXPECT_GE(weight * 1.1251f, held.rbegin()->first);
            for (auto [it, end] = held.equal_range(weight); it != end; ++it)
                if (it->second == thing) {
                    held.erase(it);
                    break;
                }
        }
        ASSERT_EQ(queue.size(), held.size());
        ASSERT_EQ(queue.empty(), held.empty());
    }
}

TEST(BucketQueue, GivesTheOldestOfEqualsFirst) {
    BucketQueue<int> queue;
    for (int i = 0; i < 100; ++i) queue.push(.25f, i);
    for (int i = 0; i < 50; ++i) EXPECT_EQ(queue.pop(), i);
    for (int i = 100; i < 150; ++i) queue.push(.25f, i);
    for (int i = 50; i < 150; ++i) EXPECT_EQ(queue.pop(), i);
    EXPECT_TRUE(queue.empty());
}

TEST(BucketQueue, TakesWeightsOfAnySize) {
    BucketQueue<int> queue;
    queue.push(0, 3);
    queue.push(std::numeric_limits<float>::max(), 1);
    queue.push(1e-3f, 2);
    queue.push(std::numeric_limits<float>::infinity(), 1);
    for (const int expected : {1, 1, 2, 3}) EXPECT_EQ(queue.pop(), expected);
}

}  // namespace
}  // namespace povpreview::test
