// SPDX-License-Identifier: AGPL-3.0-or-later
//
// A camera's matrix against the rays that POV-Ray shoots: every point of a pixel's ray is projected
// to that pixel.
#include "adapter/straight_camera.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <random>

namespace povpreview {
namespace {

glm::dvec3 random_vector(std::mt19937& random) {
    std::uniform_real_distribution<> unit(-1, 1);
    return {unit(random), unit(random), unit(random)};
}

/// Sheared and mirrored ones too.
CameraDescription random_camera(std::mt19937& random, CameraKind kind) {
    CameraDescription camera;
    camera.kind = kind;
    camera.location = 10. * random_vector(random);
    camera.direction = random_vector(random);
    camera.right = 1.33 * random_vector(random);
    camera.up = random_vector(random);
    return camera;
}

TEST(StraightCamera, PointsOfAPixelsRayAreProjectedToThatPixel) {
    constexpr unsigned seed = 3;
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    const int width = 640, height = 480;
    for (const CameraKind kind : {CameraKind::perspective, CameraKind::orthographic})
        for (int i = 0; i < 500; ++i) {
            const CameraDescription camera = random_camera(random, kind);
            if (!why_not_straight(camera).empty()) continue;
            const StraightCamera straight = straight_camera(camera, width, height);
            const double px = std::uniform_real_distribution<>(0, width)(random),
                         py = std::uniform_real_distribution<>(0, height)(random),
                         t = std::uniform_real_distribution<>(.1, 100)(random);
            const glm::dvec3 aside =
                (px / width - .5) * camera.right + (.5 - py / height) * camera.up;
            const glm::dvec3 p = kind == CameraKind::perspective
                                     ? camera.location + t * (camera.direction + aside)
                                     : camera.location + aside + t * camera.direction;
            const glm::dvec3 image = straight.to_pixels * glm::dvec4(p, 1);
            EXPECT_NEAR(image.x / image.z, px, 1e-6);
            EXPECT_NEAR(image.y / image.z, py, 1e-6);
            const glm::dvec3 view = glm::normalize(glm::cross(camera.right, camera.up));
            EXPECT_NEAR(glm::dot(straight.depth, glm::dvec4(p, 1)),
                        t * std::fabs(glm::dot(camera.direction, view)), 1e-9 * t + 1e-9);
        }
}

TEST(StraightCamera, TheEyeIsAPointOrTheDirectionAgainstTheView) {
    CameraDescription camera;
    camera.location = {1, 2, 3};
    camera.direction = {0, 0, 2};
    camera.right = {1, 0, 0};
    camera.up = {0, 1, 0};
    EXPECT_EQ(straight_camera(camera, 4, 3).eye, glm::dvec4(1, 2, 3, 1));
    camera.kind = CameraKind::orthographic;
    EXPECT_EQ(straight_camera(camera, 4, 3).eye, glm::dvec4(0, 0, -2, 0));
}

TEST(StraightCamera, OthersSayWhyTheyAreNot) {
    std::mt19937 random(4);
    CameraDescription camera = random_camera(random, CameraKind::fisheye);
    EXPECT_NE(why_not_straight(camera).find("fisheye"), std::string::npos);
    camera.kind = CameraKind::perspective;
    EXPECT_EQ(why_not_straight(camera), "");
    camera.blur_samples = 10;
    EXPECT_NE(why_not_straight(camera).find("blur"), std::string::npos);
    camera.blur_samples = 0;
    camera.perturbed = true;
    EXPECT_NE(why_not_straight(camera).find("normal"), std::string::npos);
    camera.perturbed = false;
    camera.up = camera.right;
    EXPECT_NE(why_not_straight(camera), "");
    camera.up = {0, 0, 0};
    EXPECT_NE(why_not_straight(camera), "");
}

}  // namespace
}  // namespace povpreview
