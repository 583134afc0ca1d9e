// SPDX-License-Identifier: AGPL-3.0-or-later
//
// The item buffer of any drawable scene.
#include <algorithm>
#include <cmath>
#include <set>

#include "core/detail/item_painter.h"
#include "tests/fuzz/scene_input.h"
#include "tests/fuzz/targets.h"

namespace povpreview::fuzz {
namespace {

glm::dmat4x3 frame(Input& input) {
    glm::dmat4x3 frame(1);
    for (std::size_t i = input.whole(4); i > 0; --i) frame[input.whole(4)] = input.point();
    return frame;
}

Look look(Input& input) {
    Look look;
    look.kind = static_cast<Look::Kind>(input.whole(5));
    look.image.mapping = static_cast<ImageLook::Mapping>(input.whole(5));
    look.image.interpolation = static_cast<ImageLook::Interpolation>(input.whole(4));
    look.image.once = input.whole(2);
    look.image.to_map = frame(input);
    look.pattern.kind = static_cast<PatternLook::Kind>(input.whole(3));
    look.pattern.brick_size = input.point();
    look.pattern.mortar = input.number();
    look.pattern.to_pattern = frame(input);
    return look;
}

/// A condition as the wire lets it through: a program that leaves one value.
void add_condition(Input& input, DrawableScene& scene, CurvedPiece& piece) {
    piece.first_condition = static_cast<std::uint32_t>(scene.conditions.size());
    for (std::size_t i = 0, steps = input.whole(4); i < steps; ++i) {
        scene.conditions.push_back(static_cast<ConditionStep>(input.whole(scene.solids.size())));
        if (input.whole(2)) scene.conditions.push_back(condition_not);
        if (i > 0) scene.conditions.push_back(input.whole(2) ? condition_and : condition_or);
    }
    piece.conditions = static_cast<std::uint32_t>(scene.conditions.size()) - piece.first_condition;
}

Bounds bounds(Input& input) {
    if (input.whole(4)) return {glm::dvec3(-INFINITY), glm::dvec3(INFINITY)};
    return {input.point(), input.point()};
}

DrawableScene drawable_scene(Input& input) {
    DrawableScene scene;
    scene.polygons = polygon_scene(input);
    scene.corner_uvs.resize(scene.polygons.corners.size(), glm::vec2(input.number(), .5));
    for (std::size_t i = 1 + input.whole(4); i > 0; --i) {
        Solid solid{static_cast<Solid::Kind>(input.whole(6)), frame(input), {}};
        for (double& c : solid.coefficients) c = input.number();
        scene.solids.push_back(solid);
    }
    for (std::size_t i = input.whole(4); i > 0; --i) {
        CurvedObject object{bounds(input), static_cast<std::uint32_t>(scene.pieces.size()), 0};
        for (; object.pieces < 1 + input.whole(2); ++object.pieces) {
            CurvedPiece piece;
            piece.solid = static_cast<std::uint32_t>(input.whole(scene.solids.size()));
            piece.surface = 100 + static_cast<std::uint32_t>(scene.pieces.size());
            piece.material = static_cast<std::uint32_t>(input.whole(3));
            add_condition(input, scene, piece);
            scene.pieces.push_back(piece);
        }
        scene.objects.push_back(object);
    }
    if (!input.whole(4)) scene.unknown.push_back(bounds(input));
    scene.looks = {look(input), look(input)};
    scene.looks[1].mirror = 1;
    const auto texel = [&](int i) {
        const auto half = static_cast<std::uint16_t>(input.whole(65536));
        return std::array<std::uint16_t, 4>{half, static_cast<std::uint16_t>(i), 0x3c00, 0x3c00};
    };
    scene.images.push_back({2, 1, {texel(0), texel(1)}});
    scene.working_gamma = static_cast<float>(input.number());
    if (input.whole(2)) scene.unknown_in_mirrors.push_back(bounds(input));
    return scene;
}

}  // namespace

void items(std::span<const std::byte> bytes) {
    Input input(bytes);
    const DrawableScene scene = drawable_scene(input);
    const ItemBuffer buffer = paint_items(scene);
    const std::size_t pixels =
        std::size_t(scene.polygons.width) * std::size_t(scene.polygons.height);
    promise(buffer.width == scene.polygons.width && buffer.height == scene.polygons.height &&
                buffer.surfaces.size() == pixels && buffer.kinds.size() == pixels &&
                (buffer.albedos.empty() || buffer.albedos.size() == pixels) &&
                buffer.mirrored.size() == (buffer.mirrors.empty() ? 0 : pixels),
            "a buffer of another size");
    std::set<std::uint32_t> surfaces{ItemBuffer::background, ItemBuffer::unknown};
    for (const Face& face : scene.polygons.faces) surfaces.insert(face.surface);
    for (const CurvedPiece& piece : scene.pieces) surfaces.insert(piece.surface);
    for (std::size_t i = 0; i < pixels; ++i) {
        promise(surfaces.contains(buffer.surfaces[i]), "a surface that is not there");
        promise(buffer.surfaces[i] != ItemBuffer::unknown || buffer.kinds[i] == Look::Kind::mixed,
                "an unknown surface has a look");
        promise(buffer.mirrored.empty() || surfaces.contains(buffer.mirrored[i]),
                "a mirror shows a surface that is not there");
    }
}

}  // namespace povpreview::fuzz
