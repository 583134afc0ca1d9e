// SPDX-License-Identifier: AGPL-3.0-or-later
//
// What does the item buffer cost: a whole paint_items(), in time ("CPU": of all processors
// together), of triangles, spheres, closed cylinders, letters, blobs, superellipsoids, solid
// geometry of few and many pieces, a floor with an image?
#include <benchmark/benchmark.h>

#include <glm/gtc/packing.hpp>
#include <random>

#include "core/detail/item_painter.h"
#include "tests/core/detail/item_scene.h"

namespace povpreview {
namespace {

using test::ItemScene, test::frame_along;

ItemScene empty_scene(const benchmark::State& state) {
    const int width = static_cast<int>(state.range(0));
    return ItemScene(test::look_at({3, 2, -5}, {0, 0, 0}), width, width == 1920 ? 1080 : 480);
}

/// Things spread over the view, each of a size that they cover it about twice together.
class Spread {
   public:
    explicit Spread(std::int64_t things)
        : size(2.2 / std::sqrt(static_cast<double>(things))), random_(1) {}
    glm::dvec3 point() { return {3 * place_(random_), 2 * place_(random_), 2 * place_(random_)}; }
    glm::dvec3 near(const glm::dvec3& p) { return p + size * glm::normalize(point()); }
    const double size;

   private:
    std::mt19937 random_;
    std::uniform_real_distribution<double> place_{-1, 1};
};

void paint(benchmark::State& state, const ItemScene& made) {
    std::size_t seen = 0;
    ItemBuffer buffer;
    for (auto _ : state) buffer = paint_items(made.scene);
    for (const std::uint32_t surface : buffer.surfaces) seen += surface != ItemBuffer::background;
    state.counters["covered %"] =
        100. * static_cast<double>(seen) / static_cast<double>(buffer.surfaces.size());
}

void nothing(benchmark::State& state) { paint(state, empty_scene(state)); }

void triangles(benchmark::State& state) {
    ItemScene made = empty_scene(state);
    Spread spread(state.range(1));
    for (std::int64_t i = 0; i < state.range(1); ++i) {
        const glm::dvec3 p = spread.point();
        made.face({spread.near(p), spread.near(p), spread.near(p)});
    }
    paint(state, made);
}

void spheres(benchmark::State& state) {
    ItemScene made = empty_scene(state);
    Spread spread(state.range(1));
    for (std::int64_t i = 0; i < state.range(1); ++i) made.sphere(spread.point(), spread.size);
    paint(state, made);
}

void cylinders(benchmark::State& state) {
    ItemScene made = empty_scene(state);
    Spread spread(state.range(1));
    for (std::int64_t i = 0; i < state.range(1); ++i) {
        const glm::dvec3 p = spread.point();
        made.cylinder(p, spread.near(p) + .5 * spread.size, .4 * spread.size);
    }
    paint(state, made);
}

void tori(benchmark::State& state) {
    ItemScene made = empty_scene(state);
    Spread spread(state.range(1));
    for (std::int64_t i = 0; i < state.range(1); ++i)
        made.torus(spread.point(), spread.point(), .8 * spread.size, .2 * spread.size);
    paint(state, made);
}

/// Letters of so many cubic segments, extruded; a row of them fills the view.
void letters(benchmark::State& state) {
    ItemScene made = empty_scene(state);
    constexpr int in_row = 12, segments = 30;
    for (std::int64_t letter = 0; letter < state.range(1); ++letter) {
        const glm::dvec3 at(.45 * double(letter % in_row) - 2.5, 1. - .6 * double(letter / in_row),
                            0);
        std::vector<double> outline;
        for (int i = 0; i < segments; ++i)
            for (int k = 0; k < 4; ++k) {
                const double angle = (3 * i + k) % (3 * segments) * (6.283185307 / 3 / segments);
                const double radius = .2 + .03 * std::cos(5 * angle);
                outline.insert(outline.end(), {radius * std::cos(angle), radius * std::sin(angle)});
            }
        const glm::dmat4x3 frame({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, at);
        const std::uint32_t walls = made.listed_solid(Solid::Kind::prism, frame, outline);
        const auto front = static_cast<int>(made.half_space({0, 0, -1}, at)),
                   back = static_cast<int>(made.half_space({0, 0, 1}, at + glm::dvec3(0, 0, .2)));
        made.piece(walls, {front, back, condition_and});
        made.piece(static_cast<std::uint32_t>(front), {static_cast<int>(walls)});
        made.piece(static_cast<std::uint32_t>(back), {static_cast<int>(walls)});
        made.object({at - glm::dvec3(.25, .25, 0), at + glm::dvec3(.25, .25, .2)});
    }
    paint(state, made);
}

/// A blob of so many components that fills much of the view.
void blob(benchmark::State& state) {
    ItemScene made = empty_scene(state);
    Spread spread(state.range(1));
    std::vector<double> numbers{.5};
    for (std::int64_t i = 0; i < state.range(1); ++i) {
        const glm::dvec3 p = .5 * spread.point() / spread.size;
        numbers.insert(numbers.end(), {1 / spread.size, 0, 0, 0, 1 / spread.size, 0, 0, 0,
                                       1 / spread.size, -p.x, -p.y, -p.z, 1, 0});
    }
    made.piece(made.listed_solid(Solid::Kind::blob, glm::dmat4x3(1), numbers));
    made.object({{-1.5 - spread.size, -1 - spread.size, -1 - spread.size},
                 {1.5 + spread.size, 1 + spread.size, 1 + spread.size}});
    paint(state, made);
}

void superellipsoids(benchmark::State& state) {
    ItemScene made = empty_scene(state);
    Spread spread(state.range(1));
    for (std::int64_t i = 0; i < state.range(1); ++i) {
        const glm::dvec3 p = spread.point();
        made.piece(made.solid(Solid::Kind::superellipsoid,
                              frame_along(spread.point(), p, .5 * spread.size, .5 * spread.size),
                              {8, 5}));
        made.object({p - spread.size, p + spread.size});
    }
    paint(state, made);
}

/// A ball with holes: as many solids as pieces, of one object that fills much of the view.
void differences(benchmark::State& state) {
    ItemScene made = empty_scene(state);
    Spread spread(8);
    std::vector<int> holes;
    const auto ball = static_cast<int>(made.sphere_solid({0, 0, 0}, 1.8));
    std::vector<ConditionStep> outside;
    for (std::int64_t i = 1; i < state.range(1); ++i) {
        const glm::dvec3 end = 1.8 * glm::normalize(spread.point());
        const auto hole = static_cast<int>(made.cylinder_solid({0, 0, 0}, end, .15));
        holes.push_back(hole);
        outside.insert(outside.end(), {hole, condition_not});
        if (i > 1) outside.push_back(condition_and);
    }
    made.piece(static_cast<std::uint32_t>(ball), outside);
    for (const int hole : holes) {
        std::vector<ConditionStep> condition{ball};
        for (const int other : holes)
            if (other != hole)
                condition.insert(condition.end(), {other, condition_not, condition_and});
        made.piece(static_cast<std::uint32_t>(hole), condition);
    }
    made.object({glm::dvec3(-1.8), glm::dvec3(1.8)});
    paint(state, made);
}

/// A hundred primitives on a floor with an image.
void typical(benchmark::State& state) {
    ItemScene made = empty_scene(state);
    Look look{Look::Kind::image, {}};
    look.image.interpolation = ImageLook::Interpolation::bilinear;
    made.scene.looks.push_back(look);
    const std::uint16_t grey = glm::packHalf1x16(.5f), one = glm::packHalf1x16(1.f);
    made.scene.images.push_back({512, 512, {512 * 512, {grey, grey, grey, one}}});
    if (state.range(1)) made.material = 1;
    made.face({{-1e7, -2, -1e7}, {1e7, -2, -1e7}, {1e7, -2, 1e7}, {-1e7, -2, 1e7}});
    made.material = 0;
    Spread spread(100);
    for (int i = 0; i < 30; ++i) made.sphere(spread.point(), spread.size);
    for (int i = 0; i < 30; ++i) {
        const glm::dvec3 p = spread.point();
        made.box(p, p + spread.size);
    }
    for (int i = 0; i < 40; ++i) {
        const glm::dvec3 p = spread.point();
        made.cylinder(p, spread.near(p), .3 * spread.size);
    }
    paint(state, made);
}

/// Painting takes all processors.
void side_by_side(benchmark::internal::Benchmark* bench) {
    bench->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
}
constexpr auto in_sizes = [](std::vector<std::int64_t> counts) {
    return std::vector<std::vector<std::int64_t>>{{640, 1920}, std::move(counts)};
};
BENCHMARK(nothing)->Arg(640)->Arg(1920)->Apply(side_by_side);
BENCHMARK(triangles)->ArgsProduct(in_sizes({1000, 100000}))->Apply(side_by_side);
BENCHMARK(spheres)->ArgsProduct(in_sizes({1, 100, 10000}))->Apply(side_by_side);
BENCHMARK(cylinders)->ArgsProduct(in_sizes({1, 100, 10000}))->Apply(side_by_side);
BENCHMARK(tori)->ArgsProduct(in_sizes({1, 100}))->Apply(side_by_side);
BENCHMARK(differences)->ArgsProduct(in_sizes({2, 8, 32}))->Apply(side_by_side);
BENCHMARK(letters)->ArgsProduct(in_sizes({1, 12, 60}))->Apply(side_by_side);
BENCHMARK(blob)->ArgsProduct(in_sizes({3, 30}))->Apply(side_by_side);
BENCHMARK(superellipsoids)->ArgsProduct(in_sizes({1, 30}))->Apply(side_by_side);
BENCHMARK(typical)->ArgsProduct(in_sizes({0, 1}))->ArgNames({"", "image"})->Apply(side_by_side);

}  // namespace
}  // namespace povpreview

BENCHMARK_MAIN();
