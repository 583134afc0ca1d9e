// SPDX-License-Identifier: AGPL-3.0-or-later
#include <gtest/gtest.h>

#include "display/offscreen.h"
#include "tests/display/pictures.h"

namespace povpreview::test {
namespace {

/// A grey ground, an ordinary edge at y = 10, a constrained one at y = 20, a sample at (30, 30).
Picture overlaid() {
    Picture picture = jittered_grid(60, 40, 1, 1, 1, [](glm::vec2) { return glm::vec3(.5f); });
    picture.lines = {{{5, 10}, {55, 10}, false}, {{5, 20}, {55, 20}, true}};
    picture.samples = {{30, 30}};
    return picture;
}

class OverlayTest : public testing::Test {
   protected:
    /// Whether the overlay changed the target pixel that holds the picture's point (x, y).
    bool changed(Overlay overlay, float x, float y, int times = 4) {
        const Picture picture = overlaid();
        const Image image = offscreen.render(picture, 60 * times, 40 * times, 4, overlay);
        const glm::vec3 colour = image.at(static_cast<int>(x * static_cast<float>(times)),
                                          static_cast<int>(y * static_cast<float>(times)));
        return glm::length(colour - glm::vec3(.5f)) > .05f;
    }

    Offscreen offscreen{open_offscreen()};
};

TEST_F(OverlayTest, NoneDrawsNothing) {
    EXPECT_FALSE(changed(Overlay::none, 30, 10));
    EXPECT_FALSE(changed(Overlay::none, 30, 20));
    EXPECT_FALSE(changed(Overlay::none, 30, 30));
}

TEST_F(OverlayTest, MeshDrawsAllEdges) {
    EXPECT_TRUE(changed(Overlay::mesh, 30, 10));
    EXPECT_TRUE(changed(Overlay::mesh, 30, 20));
    EXPECT_FALSE(changed(Overlay::mesh, 30, 30));
}

TEST_F(OverlayTest, EdgesDrawsConstraintsAlone) {
    EXPECT_FALSE(changed(Overlay::edges, 30, 10));
    EXPECT_TRUE(changed(Overlay::edges, 30, 20));
    EXPECT_FALSE(changed(Overlay::edges, 30, 30));
}

TEST_F(OverlayTest, SamplesDrawsDotsAlone) {
    EXPECT_FALSE(changed(Overlay::samples, 30, 10));
    EXPECT_FALSE(changed(Overlay::samples, 30, 20));
    EXPECT_TRUE(changed(Overlay::samples, 30, 30));
}

TEST_F(OverlayTest, LinesAreThinAtAnySizeAndEndWhereTheyEnd) {
    for (const int times : {2, 8, 20}) {
        const Image image = offscreen.render(overlaid(), 60 * times, 40 * times, 4, Overlay::edges);
        int rows = 0;
        for (int y = 0; y < image.height; ++y)
            rows += glm::length(image.at(30 * times, y) - glm::vec3(.5f)) > .01f;
        EXPECT_GE(rows, 1);
        EXPECT_LE(rows, 3);
    }
    EXPECT_TRUE(changed(Overlay::edges, 6, 20));
    EXPECT_FALSE(changed(Overlay::edges, 4, 20));
    EXPECT_TRUE(changed(Overlay::edges, 54.5f, 20));
    EXPECT_FALSE(changed(Overlay::edges, 56, 20));
}

TEST_F(OverlayTest, LinesAreSmooth) {
    Picture picture = overlaid();
    picture.lines = {{{5, 5}, {55, 33}, true}};
    const Image image = offscreen.render(picture, 240, 160, 1, Overlay::edges);
    int faint = 0;  // between the ground's .5 and the line's own red
    for (const glm::vec3& colour : image.pixels) faint += colour.x > .55f && colour.x < .9f;
    EXPECT_GT(faint, 100);
}

TEST_F(OverlayTest, ALineOfNoLengthIsNoHarm) {
    Picture picture = overlaid();
    picture.lines = {{{30, 20}, {30, 20}, true}};
    const Image image = offscreen.render(picture, 60, 40, 4, Overlay::edges);
    for (const glm::vec3& colour : image.pixels) ASSERT_TRUE(colour.x >= 0 && colour.x <= 1.01f);
    EXPECT_EQ(image.at(0, 0), glm::vec3(.5f));
}

}  // namespace
}  // namespace povpreview::test
