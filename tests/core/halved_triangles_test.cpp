// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/halved_triangles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

namespace povpreview {

bool operator<(LatticePoint p, LatticePoint q) { return std::pair(p.y, p.x) < std::pair(q.y, q.x); }

namespace {

constexpr int side = 16, squares = 3, end = side * squares;

bool is_root(LatticePoint p) { return p.x % side == 0 && p.y % side == 0; }
bool is_inside(LatticePoint p) { return p.x >= 0 && p.y >= 0 && p.x <= end && p.y <= end; }
int distance2(LatticePoint p, LatticePoint q) {
    return (p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y);
}
LatticePoint middle(LatticePoint p, LatticePoint q) { return {(p.x + q.x) / 2, (p.y + q.y) / 2}; }
bool has_middle(LatticePoint p, LatticePoint q) { return ((p.x + q.x) | (p.y + q.y)) % 2 == 0; }

template <class Check>
void for_each_centre(const Check& check) {
    for (int y = 0; y <= end; ++y)
        for (int x = 0; x <= end; ++x)
            if (!is_root({x, y})) check(LatticePoint{x, y});
}

TEST(Diamond, IsASquareAroundItsCentre) {
    for_each_centre([](LatticePoint centre) {
        const Diamond diamond(centre);
        const auto [first, second] = diamond.hypotenuse();
        const auto [one, other] = diamond.apexes();
        EXPECT_EQ(middle(first, second), centre);
        EXPECT_EQ(middle(one, other), centre);
        EXPECT_EQ(distance2(first, second), distance2(one, other));
        EXPECT_EQ(distance2(first, one), distance2(second, one));
        const int across =
            diamond.square ? 2 * diamond.reach * diamond.reach : diamond.reach * diamond.reach;
        EXPECT_EQ(distance2(centre, first), across) << centre.x << ", " << centre.y;
    });
}

TEST(Diamond, ComesOfHalvingThoseAroundItsApexes) {
    for_each_centre([](LatticePoint centre) {
        for (LatticePoint apex : Diamond(centre).apexes()) {
            if (!is_inside(apex) || is_root(apex)) continue;
            const auto parts = Diamond(apex).parts();
            EXPECT_EQ(std::count(parts.begin(), parts.end(), centre), 1)
                << centre.x << ", " << centre.y << " of " << apex.x << ", " << apex.y;
        }
        if (!Diamond(centre).has_parts()) return;
        for (LatticePoint part : Diamond(centre).parts()) {
            const auto apexes = Diamond(part).apexes();
            EXPECT_EQ(std::count(apexes.begin(), apexes.end(), centre), 1);
        }
    });
}

TEST(HalvedTriangle, HalvesAreHalvesOfTheDiamondsParts) {
    for_each_centre([](LatticePoint centre) {
        const Diamond diamond(centre);
        for (const HalvedTriangle& triangle : triangles(diamond)) {
            EXPECT_EQ(triangle.centre(), centre);
            for (const HalvedTriangle& half : triangle.halves()) {
                EXPECT_EQ(half.apex, centre);
                EXPECT_EQ(half.has_centre(), diamond.has_parts());
                if (!half.has_centre()) continue;
                const auto parts = diamond.parts();
                EXPECT_EQ(std::count(parts.begin(), parts.end(), half.centre()), 1);
            }
        }
    });
}

/// Diamonds halved at random, each after those that it comes of.
class Halving {
   public:
    void halve(LatticePoint centre) {
        if (!is_inside(centre) || is_root(centre) || !corners_.insert(centre).second) return;
        for (LatticePoint apex : Diamond(centre).apexes()) halve(apex);
    }
    template <class Visit>
    void for_each_leaf(const HalvedTriangle& triangle, const Visit& visit) const {
        if (!triangle.has_centre() || !corners_.contains(triangle.centre())) return visit(triangle);
        for (const HalvedTriangle& half : triangle.halves()) for_each_leaf(half, visit);
    }
    bool is_corner(LatticePoint p) const { return corners_.contains(p); }

   private:
    std::set<LatticePoint> corners_;
};

TEST(HalvedTriangle, NoCornerLiesOnASideAndLeavesCoverAll) {
    for (unsigned seed = 1; seed <= 50; ++seed) {
        std::mt19937 random(seed);
        Halving halving;
        for (unsigned i = 0; i < seed; ++i)
            halving.halve(
                {static_cast<int>(random() % (end + 1)), static_cast<int>(random() % (end + 1))});
        int area2 = 0;
        const auto check = [&](const HalvedTriangle& leaf) {
            area2 += distance2(leaf.apex, leaf.first);
            for (const auto& [p, q] : {std::pair{leaf.apex, leaf.first},
                                       {leaf.apex, leaf.second},
                                       {leaf.first, leaf.second}})
                EXPECT_FALSE(has_middle(p, q) && halving.is_corner(middle(p, q)))
                    << "seed " << seed;
        };
        for (int y = side / 2; y < end; y += side)
            for (int x = side / 2; x < end; x += side)
                for (const HalvedTriangle& triangle : triangles(Diamond({x, y})))
                    halving.for_each_leaf(triangle, check);
        EXPECT_EQ(area2, 2 * end * end) << "seed " << seed;
    }
}

}  // namespace
}  // namespace povpreview
