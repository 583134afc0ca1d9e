// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/detail/item_search.h"

#include <gtest/gtest.h>

#include <chrono>

namespace povpreview {
namespace {

using namespace std::chrono_literals;

/// A triangle that fills the view of an orthographic camera looking along z.
ItemSearch::Scene triangle(int width, int height) {
    auto scene = std::make_shared<DrawableScene>();
    PolygonScene& polygons = scene->polygons;
    polygons.width = width;
    polygons.height = height;
    polygons.camera.eye = {0, 0, -1, 0};
    polygons.camera.to_pixels[0] = {1, 0, 0};
    polygons.camera.to_pixels[1] = {0, 1, 0};
    polygons.camera.to_pixels[2] = {0, 0, 0};
    polygons.camera.to_pixels[3] = {0, 0, 1};
    polygons.camera.depth = {0, 0, 1, 0};
    const double far = 10. * (width + height);
    polygons.points = {{-far, -far, 1}, {far, -far, 1}, {0, far, 1}};
    polygons.corners = {0, 1, 2};
    Face face;
    face.count = 3;
    face.surface = 7;
    polygons.faces = {face};
    return scene;
}

/// Of 40 x 30, those that show a surface.
int pixels_of(std::uint32_t surface, const DrawnDetail& detail) {
    int count = 0;
    for (Pixel p = 0; p < 40 * 30; ++p)
        if (const std::uint32_t item = detail.map().item(p); item != DetailMap::unknown)
            count += detail.numbers().surface(item) == surface;
    return count;
}

TEST(ItemSearch, PaintsBesideWhoeverWaits) {
    ItemSearch search([] { return triangle(40, 30); }, false);
    while (!search.finished()) search.wait_for(10ms);
    ASSERT_NE(search.items(), nullptr);
    EXPECT_EQ(pixels_of(7, *search.items()), 40 * 30);
    EXPECT_GE(search.seconds(), 0);
}

TEST(ItemSearch, WithoutASceneThereAreNoItems) {
    ItemSearch search([] { return ItemSearch::Scene(); }, true);
    while (!search.finished()) search.wait_for(10ms);
    EXPECT_EQ(search.items(), nullptr);
}

/// A triangle under an image of one texel, or before that has come.
ItemSearch::Scene pictured(bool with_image) {
    auto scene = std::make_shared<DrawableScene>(*triangle(40, 30));
    scene->polygons.faces[0].material = 0;
    Look look;
    look.kind = Look::Kind::image;
    scene->looks = {look};
    constexpr std::uint16_t one = 0x3c00;  // as a half float
    if (with_image) scene->images = {{1, 1, {{one, 0, one, one}}}};
    return scene;
}

TEST(ItemSearch, SurfacesDoNotWaitForImages) {
    ItemSearch search([] { return pictured(false); }, true);
    while (!search.items()) search.wait_for(1ms);
    EXPECT_FALSE(search.finished());
    EXPECT_EQ(pixels_of(7, *search.items()), 40 * 30);
    EXPECT_EQ(search.items()->pixels(Look::Kind::traced), 40u * 30);
    search.add_images([] { return pictured(true); });
    while (!search.finished()) search.wait_for(10ms);
    EXPECT_EQ(pixels_of(7, *search.items()), 40 * 30);
    EXPECT_EQ(search.items()->pixels(Look::Kind::image), 40u * 30);
    EXPECT_EQ(search.items()->map().albedo(0), glm::vec3(1, 0, 1));
}

TEST(ItemSearch, EndsAtOnceWhereverItIs) {
    auto many = std::make_shared<DrawableScene>(*triangle(2000, 2000));
    many->polygons.faces.resize(20000, many->polygons.faces[0]);  // minutes of painting
    const auto begun = std::chrono::steady_clock::now();
    for (const auto pause : {0ms, 1ms, 30ms}) {
        ItemSearch search([&] { return ItemSearch::Scene(many); }, pause > 0ms);
        search.wait_for(pause);
    }
    EXPECT_LT(std::chrono::steady_clock::now() - begun, 20s);
}

}  // namespace
}  // namespace povpreview
