// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Solids of outlines and fields: laws of the root finder, and pictures against rays that take the
// definitions at their word.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/detail/bernstein_roots.h"
#include "core/detail/outline.h"
#include "tests/core/detail/item_agreement.h"

namespace povpreview::test {
namespace {

template <std::size_t Degree>
Bernstein<Degree> with_roots(const std::vector<double>& roots) {
    if constexpr (Degree == 0) {
        return {1};
    } else {
        const double root = roots[Degree - 1];
        return bernstein_product<Degree - 1, 1>(with_roots<Degree - 1>(roots), {-root, 1 - root});
    }
}

TEST(BernsteinRoots, AreThoseThatTheProductWasMadeOf) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> place(-.5, 1.5);
    for (int i = 0; i < 2000; ++i) {
        std::vector<double> roots(6), within;
        for (double& root : roots) root = place(random);
        std::sort(roots.begin(), roots.end());
        bool apart = true;
        for (int k = 0; k < 6; ++k) {
            apart = apart && (k == 0 || roots[k] - roots[k - 1] > 1e-3);
            if (roots[k] > 0 && roots[k] < 1) within.push_back(roots[k]);
        }
        if (!apart) continue;
        const BernsteinRoots<6> found(with_roots<6>(roots));
        ASSERT_EQ(std::size_t(found.end() - found.begin()), within.size()) << "case " << i;
        for (std::size_t k = 0; k < within.size(); ++k)
            EXPECT_NEAR(found.begin()[k], within[k], 1e-8) << "case " << i;
    }
}

TEST(BernsteinRoots, ChangeTheSignOnceWhereCurvesMeet) {
    // Halves of a cubic that share a coefficient: however near to 0 that is, and also where it is.
    for (const double joint : {-1e-300, -0., 0., 1e-300, 1e-17, -1e-17, .1, -.1}) {
        const BernsteinRoots<3> left(Bernstein<3>{-1, -.7, -.2, joint}),
            right(Bernstein<3>{joint, .2, .7, 1});
        EXPECT_EQ(left.end() - left.begin() + (right.end() - right.begin()), 1) << joint;
    }
}

TEST(BernsteinRoots, ThereAreNoneWhereTheCoefficientsHaveOneSign) {
    const BernsteinRoots<4> found(Bernstein<4>{1, 2, 0, .1, 3});
    EXPECT_EQ(found.begin(), found.end());
}

std::vector<double> straight(const std::vector<glm::dvec2>& corners) {
    std::vector<double> numbers;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const glm::dvec2 a = corners[i], b = corners[(i + 1) % corners.size()];
        for (int k = 0; k < 4; ++k) {
            const glm::dvec2 p = k == 3 ? b : a + k / 3. * (b - a);
            numbers.insert(numbers.end(), {p.x, p.y});
        }
    }
    return numbers;
}

/// A wavy ring: two closed curves of four segments each, the inner one turned a little.
std::vector<double> wavy(const glm::dvec2& centre, double size) {
    std::vector<double> numbers;
    for (const double radius : {1., .5})
        for (int i = 0; i < 4; ++i)
            for (int k = 0; k < 4; ++k) {
                const double angle = (i % 4 * 3 + k) % 12 / 12. * 6.283185307179586 + radius;
                const double r = size * radius * (k % 3 == 0 ? 1 : 1.35);
                numbers.insert(numbers.end(),
                               {centre.x + r * std::cos(angle), centre.y + r * std::sin(angle)});
            }
    return numbers;
}

TEST(Outline, CornersAtTheHeightOfThePointCountOnce) {
    const Outline diamond(straight({{1, 0}, {0, 1}, {-1, 0}, {0, -1}}));
    EXPECT_LT(diamond.side({-.5, 0}), 0);
    EXPECT_LT(diamond.side({.5, 0}), 0);
    EXPECT_GT(diamond.side({-1.5, 0}), 0);
    EXPECT_GT(diamond.side({-.5, 1}), 0);
    EXPECT_GT(diamond.side({-.5, -1}), 0);
    EXPECT_EQ(diamond.side({1, 0}), 0);
    EXPECT_EQ(diamond.side({.5, .5}), 0);
}

constexpr int width = 80, height = 60;

ItemScene empty_scene(bool orthographic) {
    ItemScene made(look_at({1, 2, -4}, {0, 0, 0}, orthographic ? 4 : 4. / 3), width, height);
    made.pose.orthographic = orthographic;
    made.scene.polygons.camera = made.pose.straight(width, height);
    made.box({-4, -3, 3}, {4, 3, 3.5});
    return made;
}
const Bounds around_all{glm::dvec3(-2), glm::dvec3(2)};
const glm::dmat4x3 slanted = frame_along({.3, 1, .4}, {0, -.2, 0}, 1, 1);

/// What is between two heights of an endless solid, closed.
void add_slab(ItemScene& made, std::uint32_t endless, const glm::dmat4x3& frame, double low_z,
              double high_z) {
    const glm::dvec3 z = frame[2];
    const auto low = static_cast<int>(made.half_space(-z, frame[3] + low_z * z)),
               high = static_cast<int>(made.half_space(z, frame[3] + high_z * z));
    made.piece(endless, {low, high, condition_and});
    made.piece(static_cast<std::uint32_t>(low), {static_cast<int>(endless)});
    made.piece(static_cast<std::uint32_t>(high), {static_cast<int>(endless)});
    made.object(around_all);
}

class IntricateSolids : public testing::TestWithParam<bool> {};

TEST_P(IntricateSolids, Prisms) {
    ItemScene made = empty_scene(GetParam());
    add_slab(made, made.listed_solid(Solid::Kind::prism, slanted, wavy({.1, 0}, 1.2)), slanted, -.3,
             .5);
    expect_right(made, 2000, .02);
}

TEST_P(IntricateSolids, ConicPrisms) {
    ItemScene made = empty_scene(GetParam());
    add_slab(made, made.listed_solid(Solid::Kind::conic_prism, slanted, wavy({.2, .1}, 1)), slanted,
             -.6, 1.1);
    expect_right(made, 2000, .02);
}

TEST_P(IntricateSolids, Lathes) {
    ItemScene made = empty_scene(GetParam());
    made.piece(made.listed_solid(Solid::Kind::lathe, slanted, wavy({1, .2}, .6)));
    made.object(around_all);
    made.piece(made.listed_solid(Solid::Kind::lathe, frame_along({0, 1, 0}, {0, 1.2, 0}, 1, 1),
                                 straight({{0, 0}, {.4, 0}, {.1, .3}, {.5, .5}})));
    made.object(around_all);
    expect_right(made, 2000, .02);
}

TEST_P(IntricateSolids, SurfacesOfRevolution) {
    ItemScene made = empty_scene(GetParam());
    // Squares of radii at four heights, and again: two segments, open at both ends.
    made.piece(made.listed_solid(Solid::Kind::surface_of_revolution, slanted,
                                 {.2, -1, 2, -.6, .3, -.3, .5, 0, .5, 0, .9, .3, 1.5, .6, .6, 1}));
    made.object(around_all);
    expect_right(made, 2000, .02);
}

TEST_P(IntricateSolids, Superellipsoids) {
    int kind = 0;
    for (const auto& [around, along] : {std::pair(2., 2.), std::pair(8., 2.), std::pair(2., 20.),
                                        std::pair(1., 1.5), std::pair(40., 10.)}) {
        ItemScene made = empty_scene(GetParam());
        made.piece(made.solid(Solid::Kind::superellipsoid, slanted, {around, along}));
        made.object(around_all);
        SCOPED_TRACE(kind++);
        expect_right(made, 2000, .05);  // what grazes it is found in steps
    }
}

TEST_P(IntricateSolids, Blobs) {
    const auto component = [](const glm::dvec3& centre, double radius, double strength,
                              double shape) {
        const double s = 1 / radius;
        return std::vector<double>{
            s,        0,    0, 0, s, 0, 0, 0, s, -s * centre.x, -s * centre.y, -s * centre.z,
            strength, shape};
    };
    std::vector<double> numbers{.5};
    for (const auto& part : {component({-.5, 0, 0}, 1, 1.2, 0), component({.6, .1, 0}, .9, 1, 0),
                             component({0, .3, .5}, .8, -1.5, 0), component({0, .4, -.2}, .8, 2, 1),
                             component({.2, -.6, 0}, .5, 1.5, 2)})
        numbers.insert(numbers.end(), part.begin(), part.end());
    ItemScene made = empty_scene(GetParam());
    made.piece(made.listed_solid(Solid::Kind::blob, slanted, numbers));
    made.object(around_all);
    expect_right(made, 2000, .05);
}

TEST_P(IntricateSolids, CutEachOther) {
    ItemScene made = empty_scene(GetParam());
    const glm::dmat4x3 other = frame_along({1, .2, -.3}, {.2, 0, 0}, 1, 1);
    const auto body = static_cast<int>(made.solid(Solid::Kind::superellipsoid, slanted, {4, 4}));
    const auto hole =
        static_cast<int>(made.listed_solid(Solid::Kind::prism, other, wavy({0, 0}, .6)));
    const auto ring =
        static_cast<int>(made.listed_solid(Solid::Kind::lathe, slanted, wavy({.9, .3}, .4)));
    made.piece(static_cast<std::uint32_t>(body),
               {hole, condition_not, ring, condition_not, condition_and});
    made.piece(static_cast<std::uint32_t>(hole), {body, ring, condition_not, condition_and});
    made.piece(static_cast<std::uint32_t>(ring), {body, hole, condition_not, condition_and});
    made.object(around_all);
    expect_right(made, 2000, .05);
}

INSTANTIATE_TEST_SUITE_P(Cameras, IntricateSolids, testing::Bool(), [](const auto& orthographic) {
    return orthographic.param ? "orthographic" : "perspective";
});

TEST(IntricateSolid, SenselessListsAreUnknown) {
    const auto unknown_with = [](Solid::Kind kind, const std::vector<double>& numbers,
                                 const std::array<double, 10>& coefficients = {}) {
        ItemScene made = empty_scene(false);
        const std::uint32_t solid = made.listed_solid(kind, slanted, numbers);
        made.scene.solids[solid].coefficients = coefficients;
        made.piece(solid);
        made.object({glm::dvec3(-.5), glm::dvec3(.5)});
        EXPECT_EQ(painted(made.scene).surfaces[height / 2 * width + width / 2],
                  ItemBuffer::unknown);
    };
    std::vector<double> outline = wavy({0, 0}, 1);
    unknown_with(Solid::Kind::prism, {});
    unknown_with(Solid::Kind::lathe, {1, 2, 3});
    unknown_with(Solid::Kind::blob, {1, 2});
    unknown_with(Solid::Kind::superellipsoid, {}, {.5, 2});
    outline[5] = std::nan("");
    unknown_with(Solid::Kind::conic_prism, outline);
    ItemScene made = empty_scene(false);
    const std::uint32_t solid = made.listed_solid(Solid::Kind::prism, slanted, wavy({0, 0}, 1));
    made.scene.solids[solid].first_number = 1;
    made.piece(solid);
    made.object({glm::dvec3(-.5), glm::dvec3(.5)});
    EXPECT_EQ(painted(made.scene).surfaces[height / 2 * width + width / 2], ItemBuffer::unknown);
}

}  // namespace
}  // namespace povpreview::test
