// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/fuzz/scene_input.h"

#include <glm/geometric.hpp>

namespace povpreview::fuzz {
namespace {

constexpr std::size_t most_points = 40, most_faces = 24, most_lights = 3;

/// A pinhole at `eye`, looking along z, its image plane one unit before it and `width` pixels wide.
StraightCamera pinhole(const glm::dvec3& eye, double width, double height) {
    StraightCamera camera;
    camera.eye = {eye, 1};
    const double cx = width / 2, cy = height / 2;
    camera.to_pixels[0] = {width, 0, 0};
    camera.to_pixels[1] = {0, -width, 0};
    camera.to_pixels[2] = {cx, cy, 1};
    camera.to_pixels[3] = {-width * eye.x - cx * eye.z, width * eye.y - cy * eye.z, -eye.z};
    camera.depth = {0, 0, 1, -eye.z};
    return camera;
}

Face face(Input& input, std::uint32_t number) {
    const std::uint8_t style = input.byte();
    Face face;
    face.surface = style % 4 == 3 ? 1 : number + 1;
    face.material = number % 2;
    face.smooth = style & 4;
    face.transparent = style & 8;
    face.casts_shadow = !(style & 16);
    face.visible = !(style & 32);
    face.lit_from_behind = style & 64;
    face.mirror = style & 128 ? .5F : 0;
    return face;
}

}  // namespace

PolygonScene polygon_scene(Input& input) {
    PolygonScene scene;
    scene.width = 1 + static_cast<int>(input.whole(40));
    scene.height = 1 + static_cast<int>(input.whole(40));
    const glm::dvec3 eye = input.whole(4) ? glm::dvec3(0, 0, -5) : input.point();
    scene.camera = pinhole(eye, scene.width, scene.height);
    if (input.whole(16) == 15) scene.camera.to_pixels[input.whole(4)] = input.point();
    for (std::size_t i = input.whole(most_lights + 1); i > 0; --i)
        scene.lights.push_back({glm::dvec4(input.point(), input.whole(4) ? 1 : 0), 1,
                                static_cast<std::uint32_t>(scene.lights.size())});
    for (std::size_t i = 3 + input.whole(most_points - 3); i > 0; --i)
        scene.points.push_back(input.point());
    for (std::size_t i = input.whole(most_faces + 1); i > 0; --i) {
        Face next = face(input, static_cast<std::uint32_t>(i));
        next.first = static_cast<std::uint32_t>(scene.corners.size());
        next.count = static_cast<std::uint32_t>(input.whole(6));
        for (std::uint32_t c = 0; c < next.count; ++c)
            scene.corners.push_back(static_cast<std::uint32_t>(input.whole(scene.points.size())));
        scene.faces.push_back(next);
    }
    return scene;
}

}  // namespace povpreview::fuzz
