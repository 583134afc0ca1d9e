// SPDX-License-Identifier: AGPL-3.0-or-later
#include "adapter/crash_search.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace povpreview {
namespace {

/// A tracer that dies over some samples, and answers a chance number of the others before.
struct Result {
    std::set<Sequence> found;
    int deaths = 0;
};
Result hunt(Sequence count, const std::set<Sequence>& killers, std::mt19937& random) {
    CrashSearch search;
    std::vector<bool> answered(count, false);
    Result result;
    const auto first_gap = [&] {
        return static_cast<Sequence>(std::find(answered.begin(), answered.end(), false) -
                                     answered.begin());
    };
    for (Sequence sent = 0; first_gap() < count && result.deaths < 1000;) {
        if (sent == count && first_gap() == count) break;
        // The same rule as the oracle's: one range at a time while searching, else everything.
        const Sequence end = search.searching() ? search.next(sent, count) : count;
        std::vector<Sequence> range;
        for (Sequence s = sent; s < end; ++s)
            if (!answered[s]) range.push_back(s);
        sent = end;
        const bool dies = std::any_of(range.begin(), range.end(),
                                      [&](Sequence s) { return killers.count(s) > 0; });
        for (const Sequence s : range)
            answered[s] = killers.count(s) == 0 && (!dies || random() % 3 == 0);
        if (!dies) continue;
        ++result.deaths;
        const auto outstanding = static_cast<std::size_t>(
            std::count_if(range.begin(), range.end(), [&](Sequence s) { return !answered[s]; }));
        if (const auto killer = search.died(first_gap(), sent, outstanding)) {
            result.found.insert(*killer);
            answered[*killer] = true;
        }
        sent = 0;
    }
    return result;
}

TEST(CrashSearch, FindsExactlyTheKillersInFewDeaths) {
    constexpr unsigned seed = 4;
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    for (int round = 0; round < 80; ++round) {
        const Sequence count = 1 + random() % 1000;
        std::set<Sequence> killers;
        for (unsigned n = random() % 4; n > 0; --n) killers.insert(random() % count);
        const Result result = hunt(count, killers, random);
        EXPECT_EQ(result.found, killers);
        EXPECT_LE(result.deaths, 3 + 3 * static_cast<int>(killers.size()))
            << killers.size() << " killers among " << count;
        EXPECT_EQ(result.deaths > 0, !killers.empty());
    }
}

TEST(CrashSearch, DeathsThatGetPastEachOtherAreNoReasonToSearch) {
    CrashSearch search;
    for (Sequence begin = 0; begin < 100000; begin += 1000) {
        EXPECT_FALSE(search.died(begin + 1000, begin + 2000, 1000).has_value());
        EXPECT_FALSE(search.searching());
    }
}

}  // namespace
}  // namespace povpreview
