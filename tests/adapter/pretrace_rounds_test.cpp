// SPDX-License-Identifier: AGPL-3.0-or-later
#include "backend/oracle/pretrace_rounds.h"

#include <gtest/gtest.h>

#include <chrono>
#include <map>
#include <mutex>
#include <random>
#include <thread>
#include <utility>
#include <vector>

namespace povpreview::tracer {
namespace {

using Place = std::pair<unsigned, unsigned>;  // step, block

/// The round of each block of each step, as threads that take their time are handed them; checks
/// that all blocks of earlier rounds are done by then.
std::map<Place, unsigned> rounds_of(unsigned blocks, unsigned steps, unsigned threads) {
    PretraceRounds rounds(blocks, steps);
    std::mutex mutex;
    std::map<Place, unsigned> taken;
    std::multimap<unsigned, Place> running;  // by round
    const auto work = [&](unsigned seed) {
        std::minstd_rand random(seed);
        for (PretraceRounds::Turn turn;;) {
            const auto answer = rounds.next(turn);
            if (answer == PretraceRounds::over) return;
            if (answer == PretraceRounds::wait) continue;
            const Place place{turn.step, turn.block};
            {
                const std::lock_guard lock(mutex);
                EXPECT_TRUE(taken.emplace(place, turn.round).second) << "handed out twice";
                running.emplace(turn.round, place);
                EXPECT_EQ(running.begin()->first, turn.round) << "an earlier round is not done";
            }
            std::this_thread::sleep_for(std::chrono::microseconds(random() % 100));
            {
                const std::lock_guard lock(mutex);
                running.erase(running.lower_bound(turn.round));
            }
            rounds.done();
        }
    };
    std::vector<std::thread> workers;
    for (unsigned i = 0; i < threads; ++i) workers.emplace_back(work, i + 1);
    for (std::thread& worker : workers) worker.join();
    return taken;
}

TEST(PretraceRounds, AreTheSameForAnyNumberOfThreads) {
    for (const auto& [blocks, steps] : {Place{1, 1}, {3, 2}, {80, 3}, {300, 6}}) {
        const auto alone = rounds_of(blocks, steps, 1);
        EXPECT_EQ(alone.size(), std::size_t{blocks} * steps);
        EXPECT_EQ(rounds_of(blocks, steps, 2), alone);
        EXPECT_EQ(rounds_of(blocks, steps, 7), alone);
    }
}

TEST(PretraceRounds, BeginWithOneBlockAndAreFew) {
    std::map<unsigned, unsigned> sizes;
    for (const auto& [place, round] : rounds_of(2040, 5, 2)) ++sizes[round];  // 1920 x 1080
    EXPECT_EQ(sizes[0], 1u);
    // POV-Ray tells 253 passes of the pretrace apart.
    EXPECT_LT(sizes.size(), 100u);
}

TEST(PretraceRounds, AThreadThatWaitsIsToldSo) {
    PretraceRounds rounds(2, 1);
    PretraceRounds::Turn turn;
    EXPECT_EQ(rounds.next(turn), PretraceRounds::taken);
    EXPECT_EQ(rounds.next(turn), PretraceRounds::wait);
    rounds.done();
    EXPECT_EQ(rounds.next(turn), PretraceRounds::taken);
    EXPECT_EQ(turn.block, 1u);
    rounds.done();
    EXPECT_EQ(rounds.next(turn), PretraceRounds::over);
}

}  // namespace
}  // namespace povpreview::tracer
