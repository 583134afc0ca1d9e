// SPDX-License-Identifier: AGPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "tests/core/polygonal/edge_laws.h"

/// Edges found without rays agree with brute force, over random small scenes of every family.
namespace povpreview {
namespace {

constexpr int image_size = 480;

/// More by POVPREVIEW_SCENES=1000, to look for what is rare.
int scenes_per_family() {
    const char* asked = std::getenv("POVPREVIEW_SCENES");
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    constexpr int usual = 6;
#else
    constexpr int usual = 40;
#endif
    return asked ? std::max(1, std::atoi(asked)) : usual;
}

class Agreement : public testing::TestWithParam<Family> {
   protected:
    /// The sum of a law's tallies over the family's scenes.
    template <class Law>
    Tally over_scenes(Law law, std::uint64_t first_seed) {
        Tally sum;
        for (std::uint64_t seed = first_seed;
             seed < first_seed + std::uint64_t(scenes_per_family()); ++seed) {
            const PolygonScene scene = random_scene(GetParam(), seed, image_size);
            Dice dice(seed);
            const EdgeLaws laws(scene, GetParam() == Family::mirror_hall ? 2 : 1);
            Tally tally = law(laws, dice);
            for (std::string& example : tally.examples)
                example = "seed " + std::to_string(seed) + ": " + example;
            sum += tally;
        }
        std::cout << GetParam() << " from seed " << first_seed << ": " << sum.text() << '\n';
        return sum;
    }
    static void expect_kept(const Tally& tally) {
        EXPECT_EQ(tally.broken, 0) << tally.text();
        // Enough questions that the law can be broken at all; a few scenes may have none.
        if (scenes_per_family() >= 40) {
            EXPECT_GT(tally.asked, 100);
        }
        EXPECT_LT(tally.ties, .05 * tally.asked);
    }
};

TEST_P(Agreement, BetweenDifferentSightsRunsAPiece) {
    expect_kept(over_scenes(
        [](const EdgeLaws& laws, Dice& dice) { return laws.neighbours_are_parted(dice, 80); },
        1000));
}

TEST_P(Agreement, VisiblePointsOfEdgesAndShadowsLieOnPieces) {
    expect_kept(over_scenes(
        [](const EdgeLaws& laws, Dice& dice) { return laws.points_lie_on_pieces(dice, 150); },
        2000));
}

TEST_P(Agreement, GeometricPiecesAreVisible) {
    const Tally tally = over_scenes(
        [](const EdgeLaws& laws, Dice& dice) {
            return laws.pieces_part_the_picture(dice, EdgeKind::geometric);
        },
        3000);
    expect_kept(tally);
    EXPECT_LT(tally.idle, .05 * tally.asked) << tally.text();
}

TEST_P(Agreement, ShadowPiecesPartLightFromDark) {
    const Tally tally =
        over_scenes([](const EdgeLaws& laws,
                       Dice& dice) { return laws.pieces_part_the_picture(dice, EdgeKind::shadow); },
                    4000);
    expect_kept(tally);
    // Where unseen faces cut others, their shadows are taken to begin; some lie in shadow anyhow.
    const double most = GetParam() == Family::mixed_styles ? .1 : .05;
    EXPECT_LT(tally.idle, most * tally.asked) << tally.text();
}

TEST_P(Agreement, ReflectedPiecesPartWhatMirrorsShow) {
    if (GetParam() < Family::mirrors) GTEST_SKIP() << "no mirrors in this family";
    const Tally tally = over_scenes(
        [](const EdgeLaws& laws, Dice& dice) {
            return laws.pieces_part_the_picture(dice, EdgeKind::reflection);
        },
        5000);
    expect_kept(tally);
    EXPECT_LT(tally.idle, .05 * tally.asked) << tally.text();
}

INSTANTIATE_TEST_SUITE_P(Families, Agreement,
                         testing::Values(Family::triangles, Family::boxes, Family::turned_boxes,
                                         Family::blocks, Family::room, Family::smooth_balls,
                                         Family::flat_balls, Family::mirrors, Family::mirror_hall,
                                         Family::mixed_styles),
                         testing::PrintToStringParamName());

}  // namespace
}  // namespace povpreview
