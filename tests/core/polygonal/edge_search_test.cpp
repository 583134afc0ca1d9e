// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/edge_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "core/polyline.h"
#include "tests/core/polygonal/growth_scenes.h"

namespace povpreview {
namespace {

using namespace std::chrono_literals;

void finish(EdgeSearch& search) {
    while (!search.finished()) search.wait_for(1s);
}

double distance_to(const EdgeChain& chain, glm::dvec2 p) {
    double least = INFINITY;
    for (std::size_t i = 0; i + 1 < chain.vertices.size(); ++i)
        least = std::min(least, distance_to_segment(p, chain.vertices[i], chain.vertices[i + 1]));
    return least;
}

TEST(EdgeSearch, FindsWhatIsFoundWithoutAThread) {
    const PolygonScene scene = office_of(300);
    std::vector<ImageEdge> pieces;
    find_edges(scene, {}, [&](std::vector<ImageEdge>&& some, std::uint64_t) {
        pieces.insert(pieces.end(), some.begin(), some.end());
        return true;
    });
    EdgeSearch search([&] { return std::optional(scene); }, {});
    finish(search);
    const std::vector<EdgeChain> chains = search.take();
    ASSERT_GT(pieces.size(), 100u);
    EXPECT_EQ(search.report().pieces, pieces.size());
    EXPECT_EQ(search.report().chains, chains.size());
    EXPECT_EQ(search.report().faces, scene.faces.size());
    for (const ImageEdge& piece : pieces) {
        if (glm::distance(piece.from, piece.to) < 1) continue;  // may be snapped to a point
        double least = INFINITY;
        for (const EdgeChain& chain : chains)
            least = std::min(least, distance_to(chain, (piece.from + piece.to) / 2.));
        EXPECT_LT(least, 1) << piece.from.x << ", " << piece.from.y;
    }
    EXPECT_TRUE(search.take().empty()) << "each chain comes once";
}

TEST(EdgeSearch, HasNothingWithoutAScene) {
    EdgeSearch search([] { return std::optional<PolygonScene>(); }, {});
    finish(search);
    EXPECT_TRUE(search.take().empty());
    EXPECT_FALSE(search.report().scene);
}

TEST(EdgeSearch, EndsAtOnceWhereverItIs) {
    const PolygonScene scene = office_of(30000);
    const auto begin = std::chrono::steady_clock::now();
    std::chrono::steady_clock::duration whole{};
    {
        EdgeSearch search([&] { return std::optional(scene); }, {});
        finish(search);
        whole = std::chrono::steady_clock::now() - begin;
    }
    const auto again = std::chrono::steady_clock::now();
    {
        EdgeSearch search([&] { return std::optional(scene); }, {});
        search.wait_for(20ms);
        EXPECT_FALSE(search.finished());
    }
    EXPECT_LT(std::chrono::steady_clock::now() - again, whole * 3 / 4);
}

TEST(EdgeSearch, GivesSurfacesFirst) {
    EdgeSearch search([] { return std::optional(office_of(300)); }, {});
    finish(search);
    const std::vector<EdgeChain> chains = search.take();
    const auto is = [](EdgeKind kind) {
        return [kind](const EdgeChain& chain) { return chain.kind == kind; };
    };
    const auto last = std::find_if(chains.rbegin(), chains.rend(), is(EdgeKind::geometric));
    const auto first = std::find_if(chains.begin(), chains.end(), is(EdgeKind::shadow));
    ASSERT_NE(last, chains.rend());
    ASSERT_NE(first, chains.end());
    EXPECT_LT(&*last, &*first);
}

}  // namespace
}  // namespace povpreview
