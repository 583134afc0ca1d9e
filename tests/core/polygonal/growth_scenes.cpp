// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/core/polygonal/growth_scenes.h"

#include <algorithm>
#include <cmath>

#include "tests/core/polygonal/random_scenes.h"
#include "tests/core/polygonal/scene_builder.h"

namespace povpreview {
namespace {

constexpr double place = 2.4;  ///< metres between desks
constexpr int width = 640, height = 480;

/// Furniture around a place on the floor, turned by an angle.
class Furniture {
   public:
    Furniture(SceneBuilder& builder, Dice& dice, glm::dvec3 at, double angle)
        : builder_(builder), dice_(dice), at_(at), turn_(turn_about({0, 1, 0}, angle)) {}

    void desk() {
        box({0, .72, 0}, {.8, .02, .4});
        for (const double x : {-.75, .75})
            for (const double z : {-.35, .35}) box({x, .35, z}, {.03, .35, .03});
    }
    void chair() {
        const glm::dvec3 seat{dice_.from_to(-.3, .3), .45, -.75};
        box(seat, {.22, .03, .22});
        box(seat + glm::dvec3(0, .4, -.2), {.22, .25, .02});
        for (const double x : {-.19, .19})
            for (const double z : {-.19, .19}) box(seat + glm::dvec3(x, -.24, z), {.02, .21, .02});
    }
    void screen() {
        box({-.2, .8, .1}, {.04, .06, .04});
        box({-.2, 1.05, .1}, {.3, .19, .015});
    }
    void books(int count) {
        double x = .15;
        for (; count > 0; --count) {
            const double thick = dice_.from_to(.01, .03), tall = dice_.from_to(.08, .14);
            box({x + thick, .74 + tall, .2}, {thick, tall, .1});
            x += 2 * thick + .003;
        }
    }

   private:
    void box(glm::dvec3 centre, glm::dvec3 half) {
        builder_.style.material = std::uint32_t(dice_.whole(1, 9));
        builder_.box(at_ + turn_ * centre, half, turn_);
    }

    SceneBuilder& builder_;
    Dice& dice_;
    glm::dvec3 at_;
    glm::dmat3 turn_;
};

}  // namespace

PolygonScene office_of(std::size_t polygons) {
    constexpr int per_place = 6 * (5 + 6 + 2 + 10);
    SceneBuilder builder;
    Dice dice(polygons);
    const int places = std::max(1, int(std::lround(double(polygons) / per_place)));
    const int row = int(std::ceil(std::sqrt(places)));
    const double half = row * place / 2 + 1, top = 2 + .5 * half;
    builder.box({0, top / 2, 0}, {half, top / 2, half});
    for (int i = 0; i < places && builder.scene.faces.size() < polygons; ++i) {
        const glm::dvec3 at{(i % row - (row - 1) / 2.) * place, 0,
                            (i / row - (row - 1) / 2.) * place};
        Furniture furniture(builder, dice, at, dice.from_to(-.4, .4));
        furniture.desk();
        furniture.chair();
        furniture.screen();
        furniture.books(int((polygons - builder.scene.faces.size()) / 6 >= 10 ? 10 : 1));
    }
    builder.style = {};
    builder.style.mirror = .9F;
    const double far = half - .01;
    builder.polygon({{-.6 * half, .8, far},
                     {.6 * half, .8, far},
                     {.6 * half, .9 * top, far},
                     {-.6 * half, .9 * top, far}});
    builder.light({.3 * half, .9 * top, .2 * half}, 1);
    builder.light({-.8 * half, .7 * top, -.5 * half}, .6F);
    builder.look({.2 * half, .85 * top, -.97 * half}, {0, .2 * top, .1 * half}, 1.3, width, height);
    return builder.scene;
}

PolygonScene hills_of(std::size_t polygons, bool smooth) {
    SceneBuilder builder;
    builder.terrain(10, std::max(2, int(std::lround(std::sqrt(double(polygons) / 2)))), 1, smooth);
    builder.parallel_light({1, .6, .4});
    builder.look({2, 6, -12}, {0, 0, 0}, 1, width, height);
    return builder.scene;
}

PolygonScene ball_of(std::size_t polygons) {
    SceneBuilder builder;
    const int stacks = std::max(3, int(std::lround(std::sqrt(double(polygons) / 2))));
    builder.ball({0, 1, 0}, 1, 2 * stacks, stacks, true, false);
    builder.floor(0, 5);
    builder.light({2, 4, -3});
    builder.look({0, 2.5, -4}, {0, .7, 0}, .9, width, height);
    return builder.scene;
}

}  // namespace povpreview
