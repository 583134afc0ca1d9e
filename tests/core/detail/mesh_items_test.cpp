// SPDX-License-Identifier: AGPL-3.0-or-later
//
// The mesh previewer with an item buffer, right and wrong, early and late, and with albedo rays.
#include <gtest/gtest.h>

#include <glm/common.hpp>
#include <limits>
#include <map>
#include <random>
#include <set>

#include "core/colour.h"
#include "core/mesh_previewer.h"
#include "core/session.h"
#include "tests/core/detail/textured_life.h"
#include "tests/core/function_oracle.h"
#include "tests/core/painted_cards.h"

namespace povpreview::test {
namespace {

using namespace std::chrono_literals;
using glm::dvec2;
using glm::vec3;

constexpr std::size_t all = std::numeric_limits<std::size_t>::max();

FunctionImage cards(int width, int height) { return PaintedCards({width, height}, 60, 5).image(); }

constexpr std::uint32_t mirror = 1000;

/// Cards, most of them seen in a mirror that fills the middle of the image.
FunctionImage mirrored_cards(int width, int height) {
    FunctionImage image = cards(width, height);
    const auto in_mirror = [=](dvec2 p) {
        return p.x > .1 * width && p.x < .9 * width && p.y > .15 * height && p.y < .85 * height;
    };
    image.reflected = [in_mirror, shown = image.surface](dvec2 p) {
        return in_mirror(p) ? shown(p) : Sample::no_reflection;
    };
    image.surface = [in_mirror, shown = image.surface](dvec2 p) {
        return in_mirror(p) ? mirror : shown(p);
    };
    return image;
}

/// The same, knowing what the mirror shows.
ItemBuffer mirrored_items_of(const FunctionImage& image, int width, int height) {
    ItemBuffer items = items_of(image, width, height);
    items.mirrors = {mirror};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) items.mirrored.push_back(image.reflected({x + .5, y + .5}));
    return items;
}

/// Some pixels, by a seed, show a surface that they do not.
void spoil(ItemBuffer& items, double share, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(0, 1);
    for (std::size_t i = 0; i < items.surfaces.size(); ++i)
        if (unit(random) < share) {
            items.surfaces[i] = items.surfaces[random() % items.surfaces.size()] + random() % 2;
            items.albedos[i] = vec3(float(unit(random)));
        }
}

/// A previewer and its tracer; items come once so many full samples are there.
struct Preview {
    Preview(const FunctionImage& of, int width, int height, std::uint32_t grouping = 0)
        : image(of), previewer(width, height), oracle(of, grouping), session(previewer, oracle) {}

    void to(std::size_t full, const ItemBuffer* items = nullptr, std::size_t when = 0) {
        session.limit_full(full);
        do {
            if (items && session.counts().full >= when) {
                previewer.accept_items(DrawnDetail(*items));
                items = nullptr;
            }
            if (validating) {
                ASSERT_EQ(previewer.validate(), "") << "after " << session.counts().full;
            }
        } while (session.advance(1ms));
    }
    double error() const { return error_of(previewer.picture(Overlay::none), image); }

    FunctionImage image;
    MeshPreviewer previewer;
    FunctionOracle oracle;
    Session session;
    bool validating = false;
};

constexpr int width = 320, height = 240;

TEST(MeshWithItems, TheEndIsTheImageWheneverItemsComeAndWhateverTheySay) {
    constexpr int w = 120, h = 90;
    const FunctionImage image = textured_life(w, h);
    for (const double wrong : {0., .03, 1.}) {
        ItemBuffer items = items_of(image, w, h);
        spoil(items, wrong, 3);
        for (const std::size_t when : {0u, 1u, 700u, 3000u, w * h - 200u}) {
            Preview run(image, w, h, 5);
            run.to(all, &items, when);
            ASSERT_TRUE(run.previewer.done());
            const Picture picture = run.previewer.picture(Overlay::none);
            for (int y = 0; y < h; ++y)
                for (int x = 0; x < w; ++x) {
                    const auto i = static_cast<std::size_t>(y * w + x);
                    ASSERT_TRUE(picture.known[i]) << x << ", " << y;
                    ASSERT_EQ(picture.pixels[i], image.colour({x + .5, y + .5})) << x << ", " << y;
                }
            EXPECT_EQ(run.previewer.validate(), "") << wrong << " wrong, after " << when;
        }
    }
}

/// What is painted later has numbers of its own; what was known before keeps its meaning.
TEST(MeshWithItems, ComeAgainInOtherNumbers) {
    const FunctionImage image = textured_life(width, height);
    const ItemBuffer items = items_of(image, width, height);
    DrawnDetail renumbered(items);
    ItemBuffer backwards = items;
    std::reverse(backwards.surfaces.begin(), backwards.surfaces.end());
    DrawnDetail other(backwards);
    other.accept(items);
    Preview once(image, width, height), twice(image, width, height);
    for (Preview* run : {&once, &twice}) {
        run->to(500);
        run->previewer.accept_items(renumbered);
        run->to(2000);
    }
    twice.previewer.accept_items(other);
    EXPECT_EQ(twice.previewer.validate(), "");
    const auto shown = [](const Preview& run) {
        return rasterise_detail(run.previewer.picture(Overlay::none));
    };
    EXPECT_EQ(shown(once), shown(twice));
    twice.to(6000);
    once.to(6000);
    EXPECT_LT(twice.error(), 1.2 * once.error());
}

TEST(MeshWithItems, AreNotWantedOnceRefinementIsOver) {
    const FunctionImage image = textured_life(96, 72);
    Preview run(image, 96, 72);
    EXPECT_TRUE(run.previewer.wants_items());
    while (run.previewer.wants_items() && run.session.advance(1ms)) {
    }
    ASSERT_FALSE(run.previewer.wants_items());
    ASSERT_FALSE(run.previewer.done());
    const double before = run.error();
    run.previewer.accept_items(DrawnDetail(items_of(image, 96, 72)));
    EXPECT_EQ(run.error(), before);
    run.to(all);
    EXPECT_EQ(run.error(), 0);
}

TEST(MeshWithItems, KeepsItsInvariantsAtEveryStep) {
    const FunctionImage image = textured_life(96, 72);
    for (const double wrong : {0., .1}) {
        for (const std::size_t when : {0u, 60u, 900u}) {
            ItemBuffer items = items_of(image, 96, 72);
            spoil(items, wrong, 7);
            Preview run(image, 96, 72, 4);
            run.validating = true;
            run.to(2500, &items, when);
        }
    }
}

struct Gain {
    const char* name;
    FunctionImage image;
    double factor;  ///< of the error at equal samples, at most
};

TEST(MeshWithItems, AreWorthManySamples) {
    for (const auto& [name, image, factor] : {Gain{"still life", textured_life(width, height), .02},
                                              Gain{"cards", cards(width, height), .1}}) {
        const ItemBuffer items = items_of(image, width, height);
        for (const std::size_t samples : {500u, 1500u, 4000u}) {
            Preview with(image, width, height), without(image, width, height);
            with.to(samples, &items);
            without.to(samples);
            EXPECT_LT(with.error(), factor * without.error()) << name << ", " << samples;
        }
    }
}

TEST(MeshWithItems, LateItemsCatchUp) {
    const FunctionImage image = textured_life(width, height);
    const ItemBuffer items = items_of(image, width, height);
    Preview early(image, width, height), late(image, width, height), without(image, width, height);
    early.to(3000, &items);
    late.to(3000, &items, 1500);
    without.to(3000);
    EXPECT_LT(late.error(), .2 * without.error());
    // 20 times where samples that were asked for without shading are taken for dark ones.
    EXPECT_LT(late.error(), 12 * early.error());
}

TEST(MeshWithItems, WrongPixelsHereAndThereCostLittle) {
    for (const auto& [name, image] :
         {std::pair{"still life", textured_life(width, height)}, {"cards", cards(width, height)}}) {
        for (const double wrong : {.0005, .003}) {
            ItemBuffer items = items_of(image, width, height);
            spoil(items, wrong, 11);
            for (const std::size_t samples : {500u, 1500u, 4000u, 20000u}) {
                Preview with(image, width, height), without(image, width, height);
                with.to(samples, &items);
                without.to(samples);
                // A wrong pixel stays wrong until a sample comes.
                EXPECT_LT(with.error(), 1.05 * without.error() + .2 * wrong)
                    << name << ", " << wrong << " wrong, " << samples;
            }
        }
    }
}

TEST(MeshWithItems, WhatMirrorsShowIsWorthManySamples) {
    const FunctionImage image = mirrored_cards(width, height);
    const ItemBuffer items = items_of(image, width, height),
                     mirrored = mirrored_items_of(image, width, height);
    const auto compare = [&](std::size_t samples, std::size_t when, double factor) {
        Preview with(image, width, height), without(image, width, height);
        with.to(samples, &mirrored, when);
        without.to(samples, &items, when);
        EXPECT_LT(with.error(), factor * without.error()) << samples << ", after " << when;
        EXPECT_EQ(with.previewer.statistics().contradicted, 0u);
        EXPECT_EQ(with.previewer.validate(), "");
    };
    compare(500, 0, .15);
    compare(1500, 0, .15);
    compare(1500, 700, .5);
}

TEST(MeshWithItems, WhatMirrorsAreSaidToShowMayBeWrong) {
    constexpr int w = 200, h = 150;
    const FunctionImage image = mirrored_cards(w, h);
    const ItemBuffer items = items_of(image, w, h);
    for (const double wrong : {.001, .02, 1.}) {
        ItemBuffer mirrored = mirrored_items_of(image, w, h);
        std::mt19937 random(7);
        std::uniform_real_distribution<double> unit(0, 1);
        for (std::uint32_t& shown : mirrored.mirrored)
            if (unit(random) < wrong)
                shown = random() % 2 ? ItemBuffer::unknown : 1 + random() % 60;
        Preview with(image, w, h), without(image, w, h);
        with.to(1000, &mirrored);
        // Where all is wrong even the mirrors' own borders are forgotten in the end.
        without.to(1000, wrong < 1 ? &items : nullptr);
        EXPECT_LT(with.error(), 1.05 * without.error() + .2 * std::min(wrong, .003)) << wrong;
        with.to(all);
        EXPECT_EQ(with.error(), 0) << wrong;
    }
}

TEST(MeshWithItems, ContradictionsAreCountedAndForgotten) {
    const FunctionImage image = textured_life(width, height);
    ItemBuffer items = items_of(image, width, height);
    for (int y = 100; y < 164; ++y)  // a block that shows something that is not there
        for (int x = 100; x < 164; ++x) items.surfaces[static_cast<std::size_t>(y * width + x)] = 9;
    Preview run(image, width, height);
    run.to(4000, &items);
    const auto detail = run.previewer.picture(Overlay::none).detail;
    ASSERT_TRUE(detail);
    EXPECT_GT(detail->contradicted(), 3u);
    EXPECT_LE(detail->contradicted(), 100u) << "once or so a square";
    EXPECT_EQ(detail->item(detail->pixel_at({130, 130})), DetailMap::unknown);
    Preview plain(image, width, height);
    plain.to(4000);
    EXPECT_LT(run.error(), plain.error());
}

/// Albedo rays beyond the few that tell what they cost, by surface.
std::map<std::uint32_t, std::size_t> albedo_rays(const Preview& run) {
    std::map<std::uint32_t, std::size_t> rays;
    for (const Request& request : run.oracle.asked)
        if (request.kind == RayKind::albedo) ++rays[run.image.surface(request.position)];
    return rays;
}
std::size_t sum(const std::map<std::uint32_t, std::size_t>& rays) {
    std::size_t all_rays = 0;
    for (const auto& [surface, count] : rays) all_rays += count;
    return all_rays;
}

TEST(AlbedoRays, AreAskedForWhereTheyPay) {
    FunctionImage image = textured_life(width, height);
    image.full_ns = 1'000'000;  // six seconds would fill it all
    image.albedo_ns = 100'000;
    Preview with(image, width, height);
    with.to(3000);
    auto rays = albedo_rays(with);
    EXPECT_GT(rays[2], 5000u) << "the floor";
    EXPECT_LT(rays[1] + rays[3], rays[2] / 4) << "sky and ball";
    EXPECT_LE(sum(rays), std::size_t{width} * height);
    FunctionImage dear = image;
    dear.albedo_ns = 900'000;
    Preview without(dear, width, height);
    without.to(3000);
    EXPECT_LT(sum(albedo_rays(without)), 100u) << "but for a few to learn what they cost";
    EXPECT_LT(with.error(), .4 * without.error());
}

TEST(AlbedoRays, AreNotAskedForWhereNothingVaries) {
    FunctionImage image = cards(width, height);
    image.full_ns = 1'000'000;
    image.albedo_ns = 100'000;
    image.albedo = [surface = image.surface](dvec2 p) {
        return vec3(float(surface(p) % 5) / 5, .5f, 1);
    };
    Preview run(image, width, height);
    const ItemBuffer items = items_of(image, width, height);
    run.to(3000, &items);
    EXPECT_LT(sum(albedo_rays(run)), 400u);
}

TEST(AlbedoRays, AskForNoPixelTwice) {
    FunctionImage image = textured_life(width, height);
    image.full_ns = 1'000'000;
    image.albedo_ns = 30'000;
    const ItemBuffer items = items_of(image, width, height);
    for (const bool given : {false, true}) {
        Preview run(image, width, height, 6);
        run.to(6000, given ? &items : nullptr, 2000);
        std::multiset<std::pair<double, double>> asked;
        for (const Request& r : run.oracle.asked)
            if (r.kind == RayKind::albedo) asked.insert({r.position.x, r.position.y});
        const std::set<std::pair<double, double>> once(asked.begin(), asked.end());
        EXPECT_LE(asked.size(), once.size() + 60) << "but for those asked to learn the cost";
        EXPECT_GT(asked.size(), 3000u);
    }
}

TEST(AlbedoRays, KeepInvariantsAndTheEnd) {
    FunctionImage image = textured_life(96, 72);
    image.full_ns = 1'000'000;
    image.albedo_ns = 50'000;
    image.fails = [](dvec2 p) { return p.x > 30 && p.x < 34 && p.y > 50; };
    Preview run(image, 96, 72, 8);
    run.validating = true;
    run.to(1500);
    run.validating = false;
    run.to(all);
    ASSERT_TRUE(run.previewer.done());
    const Picture picture = run.previewer.picture(Overlay::none);
    for (int y = 0; y < 72; ++y)
        for (int x = 0; x < 96; ++x) {
            const dvec2 centre(x + .5, y + .5);
            if (image.fails(centre)) continue;
            ASSERT_EQ(picture.pixels[static_cast<std::size_t>(y * 96 + x)], image.colour(centre));
        }
}

}  // namespace
}  // namespace povpreview::test
