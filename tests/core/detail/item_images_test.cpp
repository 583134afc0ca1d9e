// SPDX-License-Identifier: AGPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <glm/gtc/packing.hpp>
#include <random>

#include "core/detail/item_painter.h"
#include "tests/core/detail/item_agreement.h"

namespace povpreview::test {
namespace {

constexpr int width = 160, height = 120;

/// Waves, each colour in its own; no edge is so sharp that a texel's width matters much.
ImageTexels waves(std::uint32_t columns, std::uint32_t rows) {
    ImageTexels image{columns, rows, {}};
    for (std::uint32_t j = 0; j < rows; ++j)
        for (std::uint32_t i = 0; i < columns; ++i) {
            const double u = (i + .5) / columns, v = (j + .5) / rows, turn = 6.283185307;
            image.texels.push_back(
                {glm::packHalf1x16(static_cast<float>(.5 + .4 * std::sin(turn * u * 3))),
                 glm::packHalf1x16(static_cast<float>(.5 + .4 * std::sin(turn * v * 2))),
                 glm::packHalf1x16(static_cast<float>(.5 + .4 * std::sin(turn * (u + 2 * v)))),
                 glm::packHalf1x16(1.f)});
        }
    return image;
}

constexpr const char* mapping_names[] = {"planar", "spherical", "cylindrical", "toroidal", "uv"};

/// Things of all shapes around the origin, with the scene's image laid on them by `mapping`.
ItemScene textured(const CameraPose& pose, ImageLook::Mapping mapping) {
    ItemScene made(pose, width, height);
    made.scene.images = {waves(200, 101), waves(16, 16)};
    Look look{Look::Kind::image, {}};
    look.image.mapping = mapping;
    look.image.to_map = {{.8, .1, 0}, {-.1, .7, .2}, {0, -.2, .9}, {.3, .2, .1}};
    look.image.interpolation = ImageLook::Interpolation::bilinear;
    made.scene.looks.push_back(look);
    made.material = 1;
    if (mapping == ImageLook::Mapping::uv) {
        made.face({{-2, -1, 0}, {2, -1, 0}, {2, 1.5, 1}}, {{-.2f, 0.f}, {1.f, .1f}, {1.3f, 1.f}});
        made.face({{-2, -1, 0}, {2, 1.5, 1}, {-2, 1.5, 1}}, {{-.2f, 0.f}, {1.3f, 1.f}, {.1f, .9f}});
        made.face({{-90, -1.2, -90}, {90, -1.2, -90}, {0, -1.2, 90}}, {{0, 0}, {30, 0}, {0, 30}});
        return made;
    }
    made.sphere({0, 0, 0}, 1);
    made.cylinder({-2, -1, 0}, {-1.5, 1.2, .3}, .5);
    made.torus({1.7, .3, 0}, {.2, 1, -.6}, .7, .25);
    made.face({{-9, -1.2, -9}, {9, -1.2, -9}, {9, -1.2, 9}, {-9, -1.2, 9}});
    made.material = 0;
    made.box({-.3, -.3, -2}, {.3, .3, -1.8});
    return made;
}

TEST(ItemImages, ImagesOfEveryMapping) {
    for (int mapping = 0; mapping < 5; ++mapping) {
        for (const bool orthographic : {false, true}) {
            CameraPose pose = look_at({1, 2, -5}, {0, 0, 0}, orthographic ? 6 : 4. / 3);
            pose.orthographic = orthographic;
            const ItemScene made = textured(pose, static_cast<ImageLook::Mapping>(mapping));
            SCOPED_TRACE(orthographic);
            expect_right(made, 9000);
        }
    }
}

TEST(ItemImages, ImagesOfEveryInterpolation) {
    for (int kind = 0; kind < 4; ++kind) {
        for (const bool once : {false, true}) {
            ItemScene made = textured(look_at({1, 2, -5}, {0, 0, 0}), ImageLook::Mapping::planar);
            ImageLook& look = made.scene.looks[1].image;
            look.image = 1;
            look.interpolation = static_cast<ImageLook::Interpolation>(kind);
            look.once = once;
            made.scene.working_gamma = once ? 2.2f : 1.f;
            SCOPED_TRACE(kind);
            expect_right(made, 9000);
        }
    }
}

TEST(ItemImages, OnceLeavesTheRestToTracing) {
    for (int mapping = 0; mapping < 5; ++mapping) {
        ItemScene made =
            textured(look_at({1, 2, -5}, {0, 0, 0}), static_cast<ImageLook::Mapping>(mapping));
        made.scene.looks[1].image.once = true;
        SCOPED_TRACE(mapping_names[mapping]);
        expect_right(made, 9000);
    }
}

TEST(ItemImages, SeveralImagesAndMaterials) {
    ItemScene made = textured(look_at({1, 2, -5}, {0, 0, 0}), ImageLook::Mapping::planar);
    Look other = made.scene.looks[1];
    other.image.image = 1;
    other.image.mapping = ImageLook::Mapping::spherical;
    made.scene.looks.push_back(other);
    other.image.image = 0;
    made.scene.looks.push_back(other);
    made.scene.looks.push_back({Look::Kind::traced, {}});
    std::mt19937 random(3);
    std::uniform_real_distribution<double> place(-2, 2);
    for (int i = 0; i < 30; ++i) {
        made.material = random() % 7;  // some beyond the last look
        made.sphere({place(random), place(random), place(random)}, .3);
    }
    expect_right(made, 9000);
}

TEST(ItemImages, ImagesThatCannotBeDrawnAreTraced) {
    const auto kind_with = [&](const std::function<void(DrawableScene&)>& damage) {
        ItemScene made = textured(look_at({0, 0, -5}, {0, 0, 0}), ImageLook::Mapping::planar);
        made.scene.polygons.faces.clear();
        damage(made.scene);
        const ItemBuffer buffer = painted(made.scene);
        EXPECT_EQ(buffer.surfaces[width * height / 2 + width / 2], 1u);
        return buffer.kinds[width * height / 2 + width / 2];
    };
    using Kind = Look::Kind;
    EXPECT_EQ(kind_with([](DrawableScene&) {}), Kind::image);
    EXPECT_EQ(kind_with([](DrawableScene& scene) { scene.looks[1].image.image = 2; }),
              Kind::traced);
    EXPECT_EQ(kind_with([](DrawableScene& scene) { scene.images[0].texels.pop_back(); }),
              Kind::traced);
    EXPECT_EQ(kind_with([](DrawableScene& scene) { scene.images[0] = {}; }), Kind::traced);
    EXPECT_EQ(kind_with([](DrawableScene& scene) {
                  scene.looks[1].image.mapping = ImageLook::Mapping::uv;
              }),
              Kind::traced)
        << "no texture coordinates";
    EXPECT_EQ(kind_with([](DrawableScene& scene) {
                  for (auto& texel : scene.images[0].texels) texel[3] = glm::packHalf1x16(.5f);
              }),
              Kind::traced);
    EXPECT_EQ(kind_with([](DrawableScene& scene) { scene.looks.clear(); }), Kind::mixed);
}

TEST(ItemImages, EqualScenesGiveEqualBuffers) {
    const ItemScene made = textured(look_at({1, 2, -5}, {0, 0, 0}), ImageLook::Mapping::planar);
    const ItemBuffer first = painted(made.scene);
    ItemScene other(look_at({0, 0, -5}, {0, 0, 0}), 77, 31);
    other.sphere({0, 0, 0}, 1);
    const ItemBuffer between = painted(other.scene);
    EXPECT_TRUE(between.albedos.empty());
    EXPECT_EQ(between.surfaces.size(), 77u * 31u);
    const ItemBuffer again = painted(made.scene);
    EXPECT_EQ(first.surfaces, again.surfaces);
    EXPECT_EQ(first.kinds, again.kinds);
    EXPECT_EQ(first.albedos, again.albedos);
    ItemScene empty(look_at({0, 0, -5}, {0, 0, 0}), 5, 3);
    EXPECT_EQ(painted(empty.scene).surfaces,
              std::vector<std::uint32_t>(15, ItemBuffer::background));
}

}  // namespace
}  // namespace povpreview::test
