// SPDX-License-Identifier: AGPL-3.0-or-later
//
// What flat mirrors show, painted, against rays that are reflected.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <random>
#include <set>

#include "core/detail/item_painter.h"
#include "tests/core/detail/item_agreement.h"

namespace povpreview::test {
namespace {

constexpr int width = 160, height = 120;

/// Materials: 0 is matt, 1 a mirror, 2 reflects too little for one.
ItemScene scene_seen(const CameraPose& pose) {
    ItemScene made(pose, width, height);
    made.scene.looks.resize(3, {Look::Kind::plain, {}});
    made.scene.looks[1].mirror = .8f;
    made.scene.looks[2].mirror = .01f;
    return made;
}

void as_mirror(ItemScene& made, const std::vector<glm::dvec3>& corners) {
    made.material = 1;
    made.face(corners);
    made.material = 0;
}

/// Upright, 4 wide and 3 high, in the plane z = 0, facing the eye.
void add_mirror(ItemScene& made) {
    as_mirror(made, {{-2, -1, 0}, {2, -1, 0}, {2, 2, 0}, {-2, 2, 0}});
}

bool is_mirror(const ItemBuffer& buffer, std::size_t at) {
    return std::binary_search(buffer.mirrors.begin(), buffer.mirrors.end(), buffer.surfaces[at]);
}

struct Shown {
    std::size_t known = 0, unknown = 0;
    std::set<std::uint32_t> surfaces;  ///< that mirrors show
};

/// Holds every pixel of a mirror against a ray. Unknown is right where the ray meets something
/// unknown, on borders, and where what it meets is as near as `touch` to the mirror.
Shown expect_mirrored_right(const ItemScene& made) {
    constexpr double touch = .011;
    const ItemBuffer buffer = painted(made.scene);
    const RayCaster caster(made.scene, made.pose);
    Shown shown;
    std::size_t wrong = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const auto at = static_cast<std::size_t>(y * width + x);
            if (buffer.mirrors.empty() || !is_mirror(buffer, at)) continue;
            const std::uint32_t said = buffer.mirrored[at];
            shown.known += said != ItemBuffer::unknown;
            shown.unknown += said == ItemBuffer::unknown;
            shown.surfaces.insert(said);
            const RayCaster::Hit hit = caster.cast_reflected(x + .5, y + .5);
            bool right = said == hit.surface, border = false;
            for (int i = 0; i < 9 && !right; ++i) {
                const std::uint32_t near = caster
                                               .cast_reflected(x + .5 + edge_slack * (i % 3 - 1),
                                                               y + .5 + edge_slack * (i / 3 - 1))
                                               .surface;
                right = said == near;
                border = border || near != hit.surface;
            }
            if (said == ItemBuffer::unknown) right = right || border || hit.depth < touch;
            if (right || ++wrong > 5) continue;
            ADD_FAILURE() << "at " << x << ", " << y << ": said " << said << ", mirrors "
                          << hit.surface << " at " << hit.depth;
        }
    EXPECT_EQ(wrong, 0u);
    return shown;
}

void add_things(ItemScene& made) {
    made.face({{-9, -1, -9}, {9, -1, -9}, {9, -1, 9}, {-9, -1, 9}});
    made.box({-1.4, -1, -1.6}, {-.6, .3, -.9});
    made.sphere({.5, -.3, -1}, .6);
    made.torus({1.2, .9, -1.5}, {.2, 1, .5}, .5, .15);
    made.cylinder({-.5, 1, -2.5}, {.4, 1.4, -.5}, .2);
    made.sphere({0, .5, 1}, .8);               // behind the mirror
    made.box({1.6, -.5, -.5}, {2.4, .5, .5});  // through it
}

TEST(MirroredItems, AMirrorShowsWhatStandsBeforeIt) {
    ItemScene made = scene_seen(look_at({1, .7, -6}, {0, .3, 0}));
    add_mirror(made);
    add_things(made);
    const Shown shown = expect_mirrored_right(made);
    EXPECT_GT(shown.known, 2000u);
    EXPECT_LT(shown.unknown, 40u);
    EXPECT_GT(shown.surfaces.size(), 6u);
}

TEST(MirroredItems, FloorsMirrorWhatStandsOnThem) {
    for (const bool half_space : {false, true}) {
        ItemScene made = scene_seen(look_at({1, 2, -6}, {0, 0, 0}));
        made.material = 1;
        if (half_space)
            made.plane({0, 1, 0}, {0, -1, 0});
        else
            made.face({{-9e6, -1, -9e6}, {9e6, -1, -9e6}, {9e6, -1, 9e6}, {-9e6, -1, 9e6}});
        made.material = 0;
        made.box({-1.4, -1, -1.6}, {-.6, .3, -.9});
        made.sphere({.5, -.4, -1}, .6);
        made.cone({1.5, -1, .5}, .5, {1.5, 1, .5}, .1);
        made.sphere({-2, .5, 2}, .8);
        const Shown shown = expect_mirrored_right(made);
        EXPECT_GT(shown.known, 8000u);
        EXPECT_LT(shown.unknown, 60u);
        EXPECT_GT(shown.surfaces.size(), 5u);
    }
}

TEST(MirroredItems, OfParallelRays) {
    CameraPose pose = look_at({1, 2, -6}, {0, .3, 0});
    pose.right *= 5, pose.up *= 5;
    pose.orthographic = true;
    ItemScene made = scene_seen(pose);
    add_mirror(made);
    add_things(made);
    const Shown shown = expect_mirrored_right(made);
    EXPECT_GT(shown.known, 2000u);
    EXPECT_GT(shown.surfaces.size(), 5u);
}

TEST(MirroredItems, OfSeveralMirrorsEachHasItsOwn) {
    ItemScene made = scene_seen(look_at({0, 1, -7}, {0, .3, 0}));
    as_mirror(made, {{-3, -1, 1}, {0, -1, 2}, {0, 2, 2}, {-3, 2, 1}});
    as_mirror(made, {{0, -1, 2}, {3, -1, 1}, {3, 2, 1}, {0, 2, 2}});
    as_mirror(made, {{-1, -1, -2}, {-.2, -1, -2}, {-.2, -.2, -1.5}, {-1, -.2, -1.5}});
    as_mirror(made, {{-.2, -1, -2}, {.6, -1, -2}, {.6, -.2, -1.5}, {-.2, -.2, -1.5}});  // as before
    add_things(made);
    const Shown shown = expect_mirrored_right(made);
    EXPECT_EQ(painted(made.scene).mirrors.size(), 4u);
    EXPECT_GT(shown.known, 2000u);
    EXPECT_GT(shown.surfaces.size(), 7u);
}

TEST(MirroredItems, WhatTheEyeAloneSeesOrMirrorsAloneShow) {
    ItemScene made = scene_seen(look_at({1, .7, -6}, {0, .3, 0}));
    add_mirror(made);
    made.box({-1.4, -1, -1.6}, {-.6, .3, -.9});
    made.box({.6, -1, -1.6}, {1.4, .3, -.9});
    std::vector<Face>& faces = made.scene.polygons.faces;
    for (std::size_t i = 1; i < 7; ++i) faces[i].visible = false;
    for (std::size_t i = 7; i < 13; ++i) faces[i].reflected = false;
    const Shown shown = expect_mirrored_right(made);
    for (std::size_t i = 7; i < 13; ++i) EXPECT_FALSE(shown.surfaces.contains(faces[i].surface));
    std::size_t unseen = 0;
    for (std::size_t i = 1; i < 7; ++i) unseen += shown.surfaces.contains(faces[i].surface);
    EXPECT_GE(unseen, 2u);
}

TEST(MirroredItems, UnknownBoxes) {
    ItemScene made = scene_seen(look_at({1, .7, -6}, {0, .3, 0}));
    add_mirror(made);
    add_things(made);
    made.scene.unknown = {{{-1.5, .5, -.9}, {-1, 1, -.4}}, {{-1, -1, .5}, {1, 1, 1}}};
    made.scene.unknown_in_mirrors = {{{.2, 1.1, -.9}, {.8, 1.5, -.7}}};
    const Shown shown = expect_mirrored_right(made);
    EXPECT_GT(shown.known, 2000u);
    EXPECT_GT(shown.unknown, 60u);
    // Of a mirror of which nothing is known nothing is said.
    made.scene.unknown_in_mirrors = {everywhere};
    EXPECT_TRUE(painted(made.scene).mirrors.empty());
    EXPECT_TRUE(painted(made.scene).mirrored.empty());
}

TEST(MirroredItems, MirrorsAreFlatAndReflectEnough) {
    const auto mirrors_of = [](const std::function<void(ItemScene&)>& add) {
        ItemScene made = scene_seen(look_at({1, .7, -6}, {0, .3, 0}));
        add(made);
        made.material = 0;
        add_things(made);
        const ItemBuffer buffer = painted(made.scene);
        EXPECT_EQ(buffer.mirrored.empty(), buffer.mirrors.empty());
        return buffer.mirrors.size();
    };
    EXPECT_EQ(mirrors_of(add_mirror), 1u);
    EXPECT_EQ(mirrors_of([](ItemScene& made) {
                  add_mirror(made);
                  made.scene.polygons.faces[0].material = 2;
              }),
              0u);
    EXPECT_EQ(mirrors_of([](ItemScene& made) {
                  add_mirror(made);
                  made.scene.polygons.faces[0].smooth = 1;
              }),
              0u);
    EXPECT_EQ(mirrors_of([](ItemScene& made) {
                  made.material = 1;
                  made.sphere({0, 0, 0}, 1.5);
              }),
              0u);
}

// ---- looks

/// What mirrors show as `looks`: materials 3 an image, 4 a texture for tracing, 5 of no look.
ItemScene textured_scene() {
    ItemScene made = scene_seen(look_at({1, .7, -6}, {0, .3, 0}));
    made.scene.images = {{2, 2, {}}};
    for (const std::uint16_t half : {0x3800, 0x3a00, 0x3900, 0x3c00})
        made.scene.images[0].texels.push_back({half, 0x3c00, 0x3400, 0x3c00});
    Look image{Look::Kind::image, {}};
    image.image.interpolation = ImageLook::Interpolation::bilinear;
    image.image.to_map = {{.3, .1, 0}, {0, .4, 0}, {.2, 0, .3}, {.1, .3, 0}};
    made.scene.looks.push_back(image);
    made.scene.looks.push_back({Look::Kind::traced, {}});
    return made;
}

void add_textured_things(ItemScene& made) {
    made.face({{-9, -1, -9}, {9, -1, -9}, {9, -1, 9}, {-9, -1, 9}});
    made.material = 3;
    made.box({-1.4, -1, -1.6}, {-.6, .3, -.9});
    made.sphere({.5, -.3, -1}, .6);
    made.material = 4;
    made.cylinder({-.5, 1, -2.5}, {.4, 1.4, -.5}, .2);
    made.material = 5;
    made.torus({1.2, .9, -1.5}, {.2, 1, .5}, .5, .15);
    made.material = 0;
}

TEST(MirroredItems, AMirrorOfOneColourHasTheLookOfWhatItShows) {
    ItemScene made = textured_scene();
    add_mirror(made);
    add_textured_things(made);
    const ItemBuffer buffer = painted(made.scene);
    const RayCaster caster(made.scene, made.pose);
    std::map<Look::Kind, std::size_t> seen;
    for (std::size_t at = 0; at < buffer.surfaces.size(); ++at) {
        if (!is_mirror(buffer, at)) continue;
        ++seen[buffer.kinds[at]];
        if (buffer.mirrored[at] == ItemBuffer::unknown) {
            EXPECT_EQ(buffer.kinds[at], Look::Kind::mixed);
            continue;
        }
        const RayCaster::Hit hit =
            caster.cast_reflected(double(at % width) + .5, double(at / width) + .5);
        if (hit.surface != buffer.mirrored[at]) continue;  // as told above
        const bool sky = hit.surface == ItemBuffer::background;
        ASSERT_EQ(buffer.kinds[at], sky ? Look::Kind::plain : hit.kind) << at;
        if (hit.kind == Look::Kind::image) {
            EXPECT_LT(glm::distance(glm::dvec3(buffer.albedos[at]), hit.albedo), 1e-4) << at;
        }
    }
    EXPECT_GT(seen[Look::Kind::plain], 1000u);
    EXPECT_GT(seen[Look::Kind::image], 300u);
    EXPECT_GT(seen[Look::Kind::traced], 40u);
    EXPECT_GT(seen[Look::Kind::mixed], 40u);
}

TEST(MirroredItems, AMirrorWithATextureKeepsItsOwnLook) {
    ItemScene made = textured_scene();
    made.scene.looks[1].kind = Look::Kind::traced;
    add_mirror(made);
    add_textured_things(made);
    const ItemBuffer buffer = painted(made.scene);
    ASSERT_FALSE(buffer.mirrors.empty());
    for (std::size_t at = 0; at < buffer.surfaces.size(); ++at)
        if (is_mirror(buffer, at)) {
            ASSERT_EQ(buffer.kinds[at], Look::Kind::traced);
        }
}

TEST(MirroredItems, WhatCurvedMirrorsShowIsLeftToTracing) {
    ItemScene made = textured_scene();
    made.material = 1;
    made.sphere({0, 0, 0}, 1.5);
    const ItemBuffer buffer = painted(made.scene);
    EXPECT_EQ(buffer.kinds[width * (height / 2) + width / 2], Look::Kind::traced);
    made.scene.looks[1].mirror = .1f;
    EXPECT_EQ(painted(made.scene).kinds[width * (height / 2) + width / 2], Look::Kind::plain);
}

TEST(MirroredItems, ImagesMayComeLater) {
    ItemScene made = textured_scene();
    add_mirror(made);
    add_textured_things(made);
    const ItemBuffer expected = painted(made.scene);
    DrawableScene without = made.scene;
    without.images.clear();
    const PaintingPace pace;
    ItemPainting painting(without, pace);
    ItemBuffer first = painting.read(without);
    painting.paint_mirrors(without, first);
    EXPECT_EQ(first.mirrored, expected.mirrored);
    ItemBuffer then = painting.read(made.scene);
    then.mirrors = first.mirrors;
    then.mirrored = first.mirrored;
    painting.read_mirrored_looks(made.scene, then);
    EXPECT_EQ(then.kinds, expected.kinds);
    EXPECT_EQ(then.albedos, expected.albedos);
    for (std::size_t at = 0; at < first.kinds.size(); ++at)
        EXPECT_EQ(first.kinds[at], expected.kinds[at] == Look::Kind::image ? Look::Kind::traced
                                                                           : expected.kinds[at]);
}

TEST(MirroredItems, OfManyRandomScenes) {
    for (const unsigned seed : {1u, 2u, 3u, 4u, 5u, 6u}) {
        SCOPED_TRACE(seed);
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> unit(-1, 1);
        const auto point = [&](double size) {
            return size * glm::dvec3(unit(random), unit(random), unit(random));
        };
        ItemScene made = scene_seen(look_at(glm::dvec3(1, 1, -7) + point(2), point(.5)));
        for (int i = 0; i < 5; ++i) {
            const glm::dvec3 a = point(3), u = point(2), v = point(2);
            as_mirror(made, {a, a + u, a + u + v, a + v});
        }
        for (int i = 0; i < 12; ++i) made.sphere(point(3), .2 + .2 * unit(random) * unit(random));
        for (int i = 0; i < 12; ++i) {
            const glm::dvec3 low = point(3);
            made.box(low, low + glm::abs(point(1)));
        }
        expect_mirrored_right(made);
    }
}

}  // namespace
}  // namespace povpreview::test
