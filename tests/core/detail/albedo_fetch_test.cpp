// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/detail/albedo_fetch.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace povpreview::test {
namespace {

constexpr int width = 64, height = 48;
constexpr float jump = .1f;

/// The upper half shows item 0, the lower half items 1 and 2; all vary.
class AlbedoFetchTest : public testing::Test {
   protected:
    AlbedoFetchTest() {
        ItemBuffer drawn{width, height, {}, {}, {}};
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                drawn.surfaces.push_back(y < height / 2 ? 10 : x < width / 2 ? 20 : 30);
                drawn.kinds.push_back(Look::Kind::traced);
            }
        detail.accept(drawn, numbers);
    }

    /// All that is fetched, each pixel answered at once.
    std::multiset<Pixel> fetch_all() {
        std::multiset<Pixel> fetched;
        while (const auto pixel = fetch.next(&detail)) {
            fetched.insert(*pixel);
            Sample sample;
            sample.surface = 10 + 10 * detail.item(*pixel);
            sample.albedo = glm::vec3(.5f);
            detail.accept_albedo(*pixel, sample, numbers);
        }
        return fetched;
    }
    void earn(int full_samples) {
        for (int i = 0; i < full_samples; ++i) fetch.full_asked();
    }
    void tell(std::uint32_t item, int edges, bool explained = true, float by = jump) {
        for (int i = 0; i < edges; ++i) fetch.tells(item, item, by, explained);
    }

    BfSquares squares{width, height};
    AlbedoFetch fetch{squares};
    DetailMap detail{width, height};
    ItemNumbers numbers;
};

TEST_F(AlbedoFetchTest, NothingIsWantedUntilThePriceIsKnown) {
    EXPECT_FALSE(fetch.tells(0, 0, jump, true));
    EXPECT_FALSE(fetch.next(&detail));
}

TEST_F(AlbedoFetchTest, NothingIsWantedWhereRaysAreDear) {
    fetch.set_price(.9);
    EXPECT_FALSE(fetch.tells(0, 0, jump, true));
    tell(0, 100);
    for (int i = 0; i < 1000; ++i) fetch.full_asked();
    EXPECT_FALSE(fetch.next(&detail));
}

TEST_F(AlbedoFetchTest, WhereManyEdgesToldOfLightNoLookIsTaken) {
    fetch.set_price(.01);
    tell(0, 14, false);
    EXPECT_TRUE(fetch.tells(0, 0, jump, false));
    EXPECT_FALSE(fetch.tells(0, 0, jump, false));
    EXPECT_TRUE(fetch.tells(0, 0, jump, true)) << "what tells of a texture is heard";
    EXPECT_TRUE(fetch.tells(0, 1, jump, false)) << "the border may lie anywhere";
    EXPECT_TRUE(fetch.tells(1, 1, jump, false));
    tell(0, 2);
    EXPECT_TRUE(fetch.tells(0, 0, jump, false)) << "more than one in eight";
}

TEST_F(AlbedoFetchTest, WhatHardlyDiffersTellsNothing) {
    fetch.set_price(.01);
    EXPECT_FALSE(fetch.tells(0, 0, 1e-6f, true));
    for (int i = 0; i < 100; ++i) fetch.tells(0, 0, 1e-6f, true);
    fetch.full_asked();
    EXPECT_FALSE(fetch.next(&detail));
}

TEST_F(AlbedoFetchTest, ExplainedEdgesAreWorthMoreThanOthers) {
    fetch.set_price(.3);
    EXPECT_TRUE(fetch.tells(0, 0, jump, true));
    EXPECT_FALSE(fetch.tells(0, 0, jump, false));
    fetch.set_price(.01);
    EXPECT_TRUE(fetch.tells(0, 0, jump, false)) << "at that price a look does no harm";
    EXPECT_TRUE(fetch.tells(DetailMap::unknown, 0, jump, false));
}

TEST_F(AlbedoFetchTest, AWantedSquareIsFetchedOnceAndWhole) {
    fetch.set_price(.1);
    const Pixel somewhere = 13 * width + 21;
    for (int times = 0; times < 3; ++times) fetch.want(squares.square_of(somewhere));
    EXPECT_TRUE(fetch_all().empty()) << "nothing earned yet";
    earn(20);
    const std::multiset<Pixel> fetched = fetch_all();
    EXPECT_EQ(fetched.size(), 64u);
    for (const Pixel p : fetched) {
        EXPECT_EQ(squares.square_of(p), squares.square_of(somewhere));
        EXPECT_EQ(fetched.count(p), 1u);
    }
    fetch.want(squares.square_of(somewhere));
    EXPECT_TRUE(fetch_all().empty());
}

TEST_F(AlbedoFetchTest, WhatIsKnownOrFilledIsNotFetched) {
    fetch.set_price(.1);
    Sample sample;
    sample.surface = 10;
    for (Pixel p = 0; p < 5; ++p) detail.accept_albedo(p, sample, numbers);
    fetch.want(0);
    earn(20);
    EXPECT_EQ(fetch_all().size(), 64u - 5);
    squares.fill(3);
    fetch.want(3);
    EXPECT_TRUE(fetch_all().empty());
}

TEST_F(AlbedoFetchTest, ASurfaceOfWhichManyEdgesTellIsFetchedWholeForItsShare) {
    fetch.set_price(.1);
    tell(0, 3);
    earn(1);
    EXPECT_TRUE(fetch_all().empty()) << "three edges are not many";
    tell(0, 1);
    // A full sample's time buys ten rays.
    const std::multiset<Pixel> first = fetch_all();
    EXPECT_EQ(first.size(), 10u);
    std::multiset<Pixel> all = first;
    for (int i = 0; i < 1000; ++i) {
        earn(1);
        all.merge(fetch_all());
    }
    EXPECT_EQ(all.size(), std::size_t(width) * height / 2) << "every pixel of item 0, and no other";
    for (const Pixel p : all) {
        EXPECT_EQ(all.count(p), 1u);
        EXPECT_EQ(detail.item(p), 0u);
    }
}

TEST_F(AlbedoFetchTest, SurfacesLitRatherThanTexturedAreNotFetchedWhole) {
    fetch.set_price(.1);
    tell(1, 20, false);
    tell(1, 12, true);
    fetch.full_asked();
    EXPECT_TRUE(fetch_all().empty());
    tell(1, 20, true);
    fetch.full_asked();
    EXPECT_FALSE(fetch_all().empty()) << "most edges tell of texture by now";
}

TEST_F(AlbedoFetchTest, TheTextureThatIsSeenMostComesFirst) {
    fetch.set_price(.1);
    tell(1, 6, true, .01f);
    tell(2, 6, true, .2f);
    for (int i = 0; i < 20; ++i) {
        fetch.full_asked();
        for (const Pixel p : fetch_all()) ASSERT_EQ(detail.item(p), 2u) << i;
    }
}

TEST_F(AlbedoFetchTest, NoPixelIsAskedForTwiceWhoeverWantsIt) {
    fetch.set_price(.02);
    tell(0, 5);
    tell(1, 5);
    std::map<Pixel, int> asked;
    // Answers stay out for a while: nothing but the fetch itself remembers what was asked.
    for (int round = 0; round < 300; ++round) {
        if (round % 3 == 0) fetch.want(static_cast<std::size_t>(round * 7) % squares.squares());
        fetch.full_asked();
        for (int i = 0; i < 40; ++i)
            if (const auto pixel = fetch.next(&detail)) ++asked[*pixel];
    }
    int twice = 0;
    for (const auto& [pixel, times] : asked) twice += times > 1;
    EXPECT_EQ(twice, 0);
    EXPECT_GT(asked.size(), 1000u);
}

TEST_F(AlbedoFetchTest, ForgetsWhatIsCleared) {
    fetch.set_price(.1);
    fetch.want(5);
    tell(0, 5);
    fetch.full_asked();
    fetch.clear();
    EXPECT_TRUE(fetch_all().empty());
}

}  // namespace
}  // namespace povpreview::test
