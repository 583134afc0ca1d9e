// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/detail/detail_map.h"

#include <gtest/gtest.h>

#include <future>
#include <limits>
#include <random>
#include <set>
#include <vector>

#include "core/detail/drawn_detail.h"

namespace povpreview::test {
namespace {

using Albedo = DetailMap::Albedo;
constexpr int width = 20, height = 11;
constexpr Pixel pixels = width * height;

Sample albedo_ray(std::uint32_t surface, glm::vec3 albedo) {
    Sample sample;
    sample.kind = RayKind::albedo;
    sample.surface = surface;
    sample.reflected_surface = Sample::no_reflection;
    sample.albedo = albedo;
    return sample;
}

constexpr Look::Kind kinds[] = {Look::Kind::plain, Look::Kind::image, Look::Kind::traced,
                                Look::Kind::mixed};

/// Columns of surfaces 10, 20, 30, 40 of several kinds of look, then unknown ones, five wide each
/// but for the last two.
ItemBuffer columns() {
    ItemBuffer buffer{width, height, {}, {}, {}};
    for (Pixel p = 0; p < pixels; ++p) {
        const Pixel x = p % width;
        buffer.surfaces.push_back(x < 18 ? 10 * (1 + x / 5) : ItemBuffer::unknown);
        buffer.kinds.push_back(x < 18 ? kinds[x / 5] : Look::Kind::mixed);
        buffer.albedos.push_back(glm::vec3(float(p) / pixels, .5f, 2));
    }
    return buffer;
}

/// What was drawn comes, in numbers of its own, after rays have told a map something.
DetailMap with_told(const DetailMap& told, ItemNumbers& numbers) {
    const DrawnDetail drawn(columns());
    DetailMap map = drawn.map();
    ItemNumbers all = drawn.numbers();
    map.accept_told(told, all.add(numbers));
    numbers = all;
    return map;
}

TEST(SharedPixels, CopiesChangeByThemselves) {
    constexpr std::size_t count = 10000;  // several blocks
    std::mt19937 random(5);
    std::vector<SharedPixels<int>> shared(1, SharedPixels<int>(count, 7));
    std::vector<std::vector<int>> plain(1, std::vector<int>(count, 7));
    for (int i = 0; i < 3000; ++i) {
        const std::size_t which = random() % shared.size(), at = random() % count;
        if (i % 500 == 0) {
            shared.push_back(SharedPixels<int>(shared[which]));
            plain.push_back(std::vector<int>(plain[which]));
        }
        shared[which].set(at, i % 9);
        plain[which][at] = i % 9;
    }
    for (std::size_t i = 0; i < shared.size(); ++i)
        for (std::size_t at = 0; at < count; ++at) ASSERT_EQ(shared[i][at], plain[i][at]);
}

TEST(SharedPixels, RunsEndWhereTheValueChangesOrAtTheEnd) {
    constexpr std::size_t count = 20000;
    SharedPixels<int> shared(count, 7);
    std::vector<int> plain(count, 7);
    std::mt19937 random(6);
    for (int i = 0; i < 12; ++i) {
        const std::size_t at = random() % count;
        shared.set(at, i % 3);
        plain[at] = i % 3;
    }
    for (std::size_t begin = 0; begin < count; begin += 1 + random() % 40) {
        const std::size_t end = begin + 1 + random() % (count - begin);
        std::size_t expected = begin;
        while (expected < end && plain[expected] == plain[begin]) ++expected;
        ASSERT_EQ(shared.end_of_run(begin, end), expected);
    }
}

TEST(SharedPixels, CopiesAreForThreadsOfTheirOwn) {
    SharedPixels<int> all(20000, 0);
    for (std::size_t i = 0; i < 20000; ++i) all.set(i, int(i));
    const auto change = [](SharedPixels<int> mine, int by) {
        for (int turn = 0; turn < 20; ++turn) {
            const SharedPixels<int> before = mine;
            for (std::size_t i = turn; i < 20000; i += 97) mine.set(i, before[i] + by);
        }
        return mine;
    };
    auto more = std::async(std::launch::async, change, all, 1);
    const SharedPixels<int> less = change(all, -1), most = more.get();
    for (std::size_t i = 0; i < 20000; ++i) {
        ASSERT_EQ(all[i], int(i));
        ASSERT_EQ(less[i] + most[i], 2 * int(i));
    }
}

TEST(ItemNumbers, AreAddedToOthers) {
    ItemNumbers some, others;
    for (const std::uint32_t surface : {3u, 5u, 7u}) some.of(surface);
    others.set_mirrors({9});
    for (const std::uint32_t surface : {5u, 8u, 3u}) others.of(surface);
    const std::uint32_t reflection = others.of(9, 4);
    const std::vector<std::uint32_t> here = some.add(others);
    EXPECT_EQ(here, (std::vector<std::uint32_t>{1, 3, 0, 4}));
    some.set_mirrors({9});
    EXPECT_EQ(some.of(9, 4), here[reflection]);
    EXPECT_EQ(some.surface(4), 9u);
}

TEST(ItemNumbers, OfASurfaceThatBecomesAMirrorAreSeveral) {
    ItemNumbers before, now;
    before.of(9);
    before.of(3);
    now.set_mirrors({9});
    EXPECT_EQ(now.add(before), (std::vector<std::uint32_t>{ItemNumbers::several, 0}));
}

TEST(DetailMap, WhatARayMetInAMirrorIsAsDrawn) {
    ItemNumbers numbers;
    DetailMap map(width, height);
    const Pixel p = 3 * width + 7;
    map.accept_albedo(p, albedo_ray(20, {1, 2, 3}), numbers);
    ItemBuffer buffer = columns();
    buffer.mirrors = {20};
    buffer.mirrored.assign(pixels, 30);
    const DrawnDetail drawn(buffer);
    ItemNumbers all = drawn.numbers();
    DetailMap now = drawn.map();
    now.accept_told(map, all.add(numbers));
    EXPECT_EQ(now.item(p), all.of(20, 30));
    EXPECT_EQ(now.albedo(p), glm::vec3(1, 2, 3));
}

TEST(ItemNumbers, AreGivenInTheOrderOfMeeting) {
    ItemNumbers numbers;
    EXPECT_EQ(numbers.of(77), 0u);
    EXPECT_EQ(numbers.of(0xfffffffe), 1u);
    EXPECT_EQ(numbers.of(0), 2u);
    EXPECT_EQ(numbers.of(77), 0u);
    EXPECT_EQ(numbers.size(), 3u);
}

TEST(ItemNumbers, OfMirrorsTellApartWhatTheyReflect) {
    ItemNumbers numbers;
    const std::uint32_t before = numbers.of(77, 5);
    EXPECT_EQ(numbers.of(77, 6), before);
    numbers.set_mirrors({70, 77});
    const std::uint32_t five = numbers.of(77, 5), six = numbers.of(77, 6), sky = numbers.of(77, 0);
    EXPECT_EQ((std::set{five, six, sky, numbers.of(70, 5), numbers.of(78)}.size()), 5u);
    EXPECT_EQ(numbers.of(77, 5), five);
    EXPECT_EQ(numbers.of(78, 5), numbers.of(78, 6));
    for (const std::uint32_t item : {five, six, sky}) EXPECT_EQ(numbers.surface(item), 77u);
}

TEST(DetailMap, MirrorsShowWhatTheyMirror) {
    ItemBuffer buffer = columns();
    buffer.mirrors = {20};
    for (Pixel p = 0; p < pixels; ++p) {
        const Pixel y = p / width;
        buffer.mirrored.push_back(y < 3 ? ItemBuffer::unknown : y < 6 ? 30 : 40);
    }
    ItemNumbers numbers;
    numbers.set_mirrors(buffer.mirrors);
    DetailMap map(width, height);
    map.accept(buffer, numbers);
    const auto at = [](Pixel x, Pixel y) { return y * width + x; };
    for (Pixel y = 0; y < height; ++y) {
        const std::uint32_t item = map.item(at(7, y));
        if (y < 3)
            EXPECT_EQ(item, DetailMap::unknown);
        else
            EXPECT_EQ(item, numbers.of(20, y < 6 ? 30 : 40));
        EXPECT_EQ(map.item(at(2, y)), numbers.of(10));
        EXPECT_EQ(map.item(at(12, y)), numbers.of(30));
    }
    // An albedo ray does not tell what the mirror shows, but that it is there.
    map.accept_albedo(at(7, 4), albedo_ray(20, glm::vec3(.5f)), numbers);
    EXPECT_EQ(map.item(at(7, 4)), numbers.of(20, 30));
    EXPECT_EQ(map.albedo(at(7, 4)), glm::vec3(.5f));
    map.accept_albedo(at(7, 1), albedo_ray(20, glm::vec3(.5f)), numbers);
    EXPECT_EQ(map.item(at(7, 1)), DetailMap::unknown);
    map.accept_albedo(at(12, 4), albedo_ray(20, glm::vec3(.5f)), numbers);
    EXPECT_EQ(map.item(at(12, 4)), DetailMap::unknown) << "a mirror where none was thought to be";
    map.accept_albedo(at(7, 5), albedo_ray(30, glm::vec3(.5f)), numbers);
    EXPECT_EQ(map.item(at(7, 5)), numbers.of(30));
    // Of a mirror of one colour it does.
    Sample of_mirrored = albedo_ray(20, glm::vec3(.25f));
    of_mirrored.reflected_surface = 40;
    for (const Pixel y : {2u, 3u}) {
        map.accept_albedo(at(7, y), of_mirrored, numbers);
        EXPECT_EQ(map.item(at(7, y)), numbers.of(20, 40));
        EXPECT_EQ(map.albedo(at(7, y)), glm::vec3(.25f));
    }
}

TEST(DetailMap, WhatMirrorsShowIsKnownLater) {
    ItemBuffer buffer = columns();
    ItemNumbers numbers;
    DetailMap map(width, height);
    const auto then = [&](Look::Kind kind) {
        buffer.kinds[0] = kind;
        map.accept(buffer, numbers);
        return map.albedo_state(0);
    };
    EXPECT_EQ(then(Look::Kind::traced), Albedo::wanted);
    EXPECT_EQ(then(Look::Kind::plain), Albedo::constant);
    EXPECT_EQ(then(Look::Kind::image), Albedo::known);
    EXPECT_EQ(map.albedo(0), buffer.albedos[0]);
}

TEST(DetailMap, KnowsNothingAtFirst) {
    const DetailMap map(width, height);
    for (Pixel p = 0; p < pixels; ++p) {
        EXPECT_EQ(map.item(p), DetailMap::unknown);
        EXPECT_TRUE(map.wants_albedo(p));
        EXPECT_FALSE(map.contradicts(p, 3));
    }
    EXPECT_EQ(map.known() + map.albedos() + map.contradicted(), 0u);
}

TEST(DetailMap, PositionsAreClampedToTheImage) {
    const DetailMap map(width, height);
    EXPECT_EQ(map.pixel_at({0, 0}), 0u);
    EXPECT_EQ(map.pixel_at({-3, 4.9}), 4u * width);
    EXPECT_EQ(map.pixel_at({width, height}), pixels - 1);
    EXPECT_EQ(map.pixel_at({7.999, 2}), 2u * width + 7);
}

TEST(DetailMap, TakesWhatWasDrawn) {
    DetailMap map(width, height);
    ItemNumbers numbers;
    const ItemBuffer drawn = columns();
    map.accept(drawn, numbers);
    EXPECT_EQ(numbers.size(), 4u);
    EXPECT_EQ(map.known(), 18u * height);
    EXPECT_EQ(map.albedos(), 5u * height);
    for (Pixel p = 0; p < pixels; ++p) {
        const Pixel x = p % width;
        EXPECT_EQ(map.item(p), x < 18 ? x / 5 : DetailMap::unknown);
        const Albedo expected[] = {Albedo::constant, Albedo::known, Albedo::wanted, Albedo::wanted};
        EXPECT_EQ(map.albedo_state(p), x < 18 ? expected[x / 5] : Albedo::wanted);
        if (x / 5 == 1) {
            EXPECT_EQ(map.albedo(p), drawn.albedos[p]);
        }
        EXPECT_EQ(map.contradicts(p, 2), x < 18 && x / 5 != 2);
    }
}

TEST(DetailMap, RaysAreRightWhicheverCameFirst) {
    for (const bool ray_first : {false, true}) {
        DetailMap map(width, height);
        ItemNumbers numbers;
        const Pixel p = 3 * width + 2, q = p + 1, r = p + 4;
        const auto rays = [&] {
            map.accept_albedo(p, albedo_ray(99, {1, 2, 3}), numbers);
            map.accept_albedo(q, albedo_ray(0, {0, 0, 0}), numbers);
            Sample failed;
            failed.failed = true;
            map.accept_albedo(r, failed, numbers);
        };
        if (ray_first) {
            rays();
            map = with_told(map, numbers);
        } else {
            map.accept(columns(), numbers);
            rays();
        }
        EXPECT_EQ(map.item(p), numbers.of(99));
        EXPECT_EQ(map.albedo(p), glm::vec3(1, 2, 3));
        EXPECT_EQ(map.item(q), numbers.of(0)) << "the background is an item as well";
        EXPECT_EQ(map.albedo_state(q), Albedo::known);
        EXPECT_EQ(map.item(r), DetailMap::unknown);
        EXPECT_EQ(map.albedo_state(r), Albedo::unreliable);
        EXPECT_FALSE(map.wants_albedo(r));
        EXPECT_EQ(map.known(), 18u * height - 1);
        EXPECT_EQ(map.albedos(), 5u * height - 1 + 2);
    }
}

TEST(DetailMap, AlbedosThatAreNoNumbersAreNotBelieved) {
    for (const float bad :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        DetailMap map(width, height);
        ItemNumbers numbers;
        map.accept_albedo(7, albedo_ray(5, {.5f, bad, 1}), numbers);
        EXPECT_EQ(map.albedo_state(7), Albedo::unreliable);
        EXPECT_EQ(map.known() + map.albedos(), 0u);
    }
}

TEST(DetailMap, ContradictionsCostTheWholeSquareButWhatRaysTold) {
    DetailMap map(width, height);
    ItemNumbers numbers;
    map.accept(columns(), numbers);
    const Pixel told = 9 * width + 9, at = 10 * width + 8;  // in the square at (8, 8)
    map.accept_albedo(told, albedo_ray(99, {1, 2, 3}), numbers);
    ASSERT_TRUE(map.contradicts(at, numbers.of(12345)));
    map.distrust(at);
    EXPECT_EQ(map.contradicted(), 1u);
    std::size_t known = 0, albedos = 0;
    for (Pixel p = 0; p < pixels; ++p) {
        const bool inside = p % width / 8 == 1 && p / width / 8 == 1;
        if (inside && p != told) {
            EXPECT_EQ(map.item(p), DetailMap::unknown);
            EXPECT_EQ(map.albedo_state(p), Albedo::unreliable);
            EXPECT_FALSE(map.contradicts(p, 0)) << "it is not counted again";
        } else {
            EXPECT_EQ(map.item(p) != DetailMap::unknown, p % width < 18);
        }
        known += map.item(p) != DetailMap::unknown;
        albedos += map.albedo_state(p) == Albedo::known;
    }
    EXPECT_EQ(map.albedo(told), glm::vec3(1, 2, 3));
    EXPECT_EQ(map.known(), known);
    EXPECT_EQ(map.albedos(), albedos);
    map = with_told(map, numbers);
    EXPECT_EQ(map.item(at), DetailMap::unknown) << "what was drawn is not believed there again";
    EXPECT_EQ(map.item(told), numbers.of(99));
    EXPECT_EQ(map.known(), known);
    EXPECT_EQ(map.albedos(), albedos);
    EXPECT_EQ(map.contradicted(), 1u);
}

TEST(DetailMap, DistrustTwiceIsDistrustOnceButForTheCount) {
    DetailMap map(width, height);
    ItemNumbers numbers;
    map.accept(columns(), numbers);
    map.distrust(pixels - 1);  // a square of 4 x 3 pixels
    const std::size_t known = map.known();
    EXPECT_EQ(known, 18u * height - 2 * 3);
    map.distrust(pixels - 1);
    EXPECT_EQ(map.known(), known);
    EXPECT_EQ(map.contradicted(), 2u);
}

TEST(DetailMap, ExtentsCountPixelsAndLieInside) {
    std::mt19937 random(4);
    DetailMap map(width, height);
    ItemNumbers numbers;
    ItemBuffer drawn = columns();
    for (Pixel p = 0; p < pixels; ++p)
        if (random() % 3 == 0) drawn.surfaces[p] = random() % 7 + 1;
    map.accept(drawn, numbers);
    numbers.of(4711);  // met by a sample, but seen in no pixel
    const auto extents = map.extents(numbers);
    ASSERT_EQ(extents.size(), numbers.size());
    std::vector<std::uint32_t> counts(extents.size());
    for (Pixel p = 0; p < pixels; ++p)
        if (map.item(p) != DetailMap::unknown) ++counts[map.item(p)];
    for (std::uint32_t item = 0; item < extents.size(); ++item) {
        EXPECT_EQ(extents[item].pixels, counts[item]);
        if (counts[item] > 0) {
            EXPECT_EQ(map.item(extents[item].middle), item);
        }
    }
    EXPECT_EQ(extents.back().pixels, 0u);
}

TEST(DetailMap, TheMiddleOfAnExtentIsThatOfItsLongestRun) {
    DetailMap map(width, height);
    ItemNumbers numbers;
    ItemBuffer drawn{width,
                     height,
                     std::vector<std::uint32_t>(pixels, 1),
                     std::vector<Look::Kind>(pixels, Look::Kind::plain),
                     {}};
    for (Pixel x = 4; x < 9; ++x) drawn.surfaces[2 * width + x] = 2;
    for (Pixel x = 13; x < 20; ++x) drawn.surfaces[5 * width + x] = 2;
    for (Pixel x = 0; x < 6; ++x) drawn.surfaces[6 * width + x] = 2;  // another run, not a longer
    map.accept(drawn, numbers);
    const auto extents = map.extents(numbers);
    EXPECT_EQ(extents[1].middle, 5u * width + 16);
    EXPECT_EQ(extents[1].pixels, 5u + 7 + 6);
    EXPECT_EQ(extents[0].middle, 0u * width + 10);
}

}  // namespace
}  // namespace povpreview::test
