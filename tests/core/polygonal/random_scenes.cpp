// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/core/polygonal/random_scenes.h"

#include <ostream>

#include "tests/core/polygonal/scene_builder.h"

namespace povpreview {
namespace {

/// Everything stands within about 4 of the origin.
constexpr double reach = 4;

glm::dmat3 any_turn(Dice& dice) {
    return turn_about(dice.vector(-1, 1) + glm::dvec3(0, 1e-3, 0), dice.from_to(0, 6.28));
}

void add_triangles(SceneBuilder& builder, Dice& dice) {
    for (int i = dice.whole(2, 12); i > 0; --i) {
        const glm::dvec3 middle = dice.vector(-2, 2);
        const glm::dvec3 a = dice.vector(-2, 2), b = dice.vector(-2, 2);
        if (dice.chance(.5))
            builder.polygon({middle, middle + a, middle + b});
        else
            builder.polygon({middle + a, middle + b, middle - a, middle - b});
    }
}

void add_boxes(SceneBuilder& builder, Dice& dice, bool turned) {
    for (int i = dice.whole(1, 7); i > 0; --i) {
        builder.style.material = std::uint32_t(dice.whole(1, 3));
        const glm::dvec3 half = dice.vector(.2, 1.2);
        glm::dvec3 centre = dice.vector(-2.5, 2.5);
        if (turned)
            builder.box(centre, half, any_turn(dice));
        else
            builder.box({centre.x, half.y, centre.z}, half);
    }
}

/// Boxes in cells of a grid, so that neighbours have sides, edges and corners in common.
void add_blocks(SceneBuilder& builder, Dice& dice) {
    const double half = dice.from_to(.3, .5);
    for (int i = 0; i < 36; ++i) {
        if (!dice.chance(.35)) continue;
        builder.style.material = std::uint32_t(dice.whole(1, 2));
        builder.box(half * glm::dvec3(2 * (i % 4) - 3, 2 * (i / 16) + 1, 2 * (i / 4 % 4) - 3),
                    glm::dvec3(half));
    }
}

void add_balls(SceneBuilder& builder, Dice& dice, bool smooth) {
    for (int i = dice.whole(1, 3); i > 0; --i) {
        const glm::dvec3 centre = dice.vector(-1.5, 1.5) + glm::dvec3(0, 1.5, 0);
        const double radius = dice.from_to(.5, 1.4);
        const int slices = dice.whole(3, 9), stacks = dice.whole(3, 7);
        builder.ball(centre, radius, slices, stacks, smooth, dice.chance(.5));
    }
}

void add_mirrors(SceneBuilder& builder, Dice& dice) {
    const Face plain = builder.style;
    for (int i = dice.whole(1, 2); i > 0; --i) {
        builder.style.mirror = .8F;
        const glm::dmat3 turn = turn_about({0, 1, 0}, dice.from_to(-1.2, 1.2)) *
                                turn_about({1, 0, 0}, dice.from_to(-.3, .3));
        const double w = dice.from_to(1, 3), h = dice.from_to(.8, 2);
        const glm::dvec3 at{dice.from_to(-2, 2), dice.from_to(.5, 2.5), dice.from_to(2.2, 4)};
        builder.polygon({at + turn * glm::dvec3(-w, -h, 0), at + turn * glm::dvec3(w, -h, 0),
                         at + turn * glm::dvec3(w, h, 0), at + turn * glm::dvec3(-w, h, 0)});
    }
    builder.style = plain;
}

void add_hall(SceneBuilder& builder, Dice& dice) {
    const Face plain = builder.style;
    builder.style.mirror = .9F;
    for (const double side : {-1, 1}) {
        const double x = side * dice.from_to(2.5, 3.5), lean = dice.from_to(-.3, .3);
        builder.polygon({{x, 0, -3}, {x, 0, 3}, {x + lean, 3, 3}, {x + lean, 3, -3}});
    }
    builder.style = plain;
}

void add_mixed_styles(SceneBuilder& builder, Dice& dice) {
    for (int i = dice.whole(2, 6); i > 0; --i) {
        builder.style = {};
        builder.style.transparent = dice.chance(.3);
        builder.style.casts_shadow = !dice.chance(.3);
        builder.style.visible = !dice.chance(.2);
        builder.style.reflected = !dice.chance(.2);
        builder.style.lit_from_behind = dice.chance(.3);
        const glm::dvec3 half = dice.vector(.2, 1.1);
        builder.box(dice.vector(-2, 2), half, any_turn(dice));
    }
    builder.style = {};
}

void add_lights(SceneBuilder& builder, Dice& dice, bool inside) {
    for (int i = dice.whole(0, 3); i > 0; --i) {
        const float brightness = float(dice.from_to(.1, 1));
        if (inside)
            builder.light(dice.vector(-3.5, 3.5), brightness);
        else if (dice.chance(.3))
            builder.parallel_light(dice.vector(-1, 1) + glm::dvec3(0, 1.5, 0), brightness);
        else
            builder.light(dice.vector(-5, 5) + glm::dvec3(0, 6, 0), brightness);
    }
}

void add_camera(SceneBuilder& builder, Dice& dice, bool inside, bool parallel, int size) {
    const glm::dvec3 target = dice.vector(-1, 1);
    glm::dvec3 eye{dice.from_to(-4, 4), dice.from_to(.7, 5), dice.from_to(-8, -5)};
    if (inside) eye = {dice.from_to(-3, 3), dice.from_to(-1, 3), -3.7};
    const double angle = dice.from_to(.6, 1.4), extent = dice.from_to(4, 9);
    if (parallel)
        builder.look_parallel(3. * eye, target, extent, size, size);
    else
        builder.look(eye, target, angle, size, size);
}

}  // namespace

std::ostream& operator<<(std::ostream& out, Family family) {
    constexpr const char* names[] = {"triangles",   "boxes",        "turned_boxes", "blocks",
                                     "room",        "smooth_balls", "flat_balls",   "mirrors",
                                     "mirror_hall", "mixed_styles"};
    return out << names[int(family)];
}

PolygonScene random_scene(Family family, std::uint64_t seed, int size) {
    Dice dice(seed * 8 + std::uint64_t(family));
    SceneBuilder builder(dice.chance(.5));
    const bool inside = family == Family::room;
    const bool parallel = !inside && dice.chance(.25);
    if (family != Family::triangles && !inside && dice.chance(.8))
        builder.floor(0, dice.chance(.5) || parallel ? reach : 1e4);
    switch (family) {
        case Family::triangles:
            add_triangles(builder, dice);
            break;
        case Family::boxes:
            add_boxes(builder, dice, false);
            break;
        case Family::turned_boxes:
            add_boxes(builder, dice, true);
            break;
        case Family::blocks:
            add_blocks(builder, dice);
            break;
        case Family::room:
            builder.box({0, 0, 0}, glm::dvec3(reach));
            add_boxes(builder, dice, true);
            break;
        case Family::smooth_balls:
            add_balls(builder, dice, true);
            break;
        case Family::flat_balls:
            add_balls(builder, dice, false);
            break;
        case Family::mirrors:
            add_mirrors(builder, dice);
            add_boxes(builder, dice, dice.chance(.5));
            break;
        case Family::mirror_hall:
            add_hall(builder, dice);
            add_boxes(builder, dice, dice.chance(.5));
            break;
        case Family::mixed_styles:
            if (dice.chance(.6)) add_mirrors(builder, dice);
            add_mixed_styles(builder, dice);
            break;
    }
    add_lights(builder, dice, inside);
    add_camera(builder, dice, inside, parallel, size);
    return builder.scene;
}

}  // namespace povpreview
