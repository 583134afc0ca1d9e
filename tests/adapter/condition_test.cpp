// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Conditions against truth tables: whatever expression is built, its program says the same.
#include "backend/oracle/condition.h"

#include <gtest/gtest.h>

#include <functional>
#include <random>

namespace povpreview::tracer {
namespace {

constexpr unsigned solids = 5;
/// Whether a point is inside, which is in solid i where bit i is set.
using Truth = std::function<bool(unsigned)>;

bool run(const Condition& condition, unsigned point) {
    if (condition.is_nowhere()) return false;
    if (condition.steps().empty()) return true;
    std::vector<bool> stack;
    for (const std::int32_t step : condition.steps()) {
        if (step >= 0) {
            stack.push_back((point >> step & 1) != 0);
            EXPECT_LE(stack.size(), std::size_t{Condition::max_depth});
        } else if (step == -1) {
            stack.back() = !stack.back();
        } else {
            const bool top = stack.back();
            stack.pop_back();
            stack.back() = step == -2 ? stack.back() && top : stack.back() || top;
        }
    }
    EXPECT_EQ(stack.size(), 1U);
    return stack.back();
}

TEST(Condition, SaysWhatItsExpressionSays) {
    std::mt19937 random(5);
    for (int round = 0; round < 300; ++round) {
        std::vector<std::pair<Condition, Truth>> known{
            {Condition::everywhere(), [](unsigned) { return true; }},
            {Condition::nowhere(), [](unsigned) { return false; }}};
        for (unsigned i = 0; i < solids; ++i)
            known.push_back({Condition::inside(i), [i](unsigned p) { return (p >> i & 1) != 0; }});
        for (int step = 0; step < 12; ++step) {
            const auto [a, of_a] = known[random() % known.size()];
            const auto [b, of_b] = known[random() % known.size()];
            switch (random() % 3) {
                case 0:
                    known.push_back({!a, [of_a = of_a](unsigned p) { return !of_a(p); }});
                    break;
                case 1:
                    known.push_back({a & b, [of_a = of_a, of_b = of_b](unsigned p) {
                                         return of_a(p) && of_b(p);
                                     }});
                    break;
                default:
                    known.push_back({a | b, [of_a = of_a, of_b = of_b](unsigned p) {
                                         return of_a(p) || of_b(p);
                                     }});
            }
        }
        for (const auto& [condition, truth] : known)
            for (unsigned point = 0; point < 1u << solids && !condition.too_long(); ++point)
                ASSERT_EQ(run(condition, point), truth(point)) << "round " << round;
    }
}

TEST(Condition, TellsWhenItIsTooLong) {
    Condition chain = Condition::inside(0);
    for (int i = 0; i < 127; ++i) chain = chain & Condition::inside(1);
    EXPECT_FALSE(chain.too_long());
    EXPECT_TRUE((chain & (chain | Condition::inside(2))).too_long());
    Condition tree = Condition::inside(0);
    for (int i = 0; i < 6; ++i) tree = tree & tree;
    EXPECT_FALSE(tree.too_long());
}

}  // namespace
}  // namespace povpreview::tracer
