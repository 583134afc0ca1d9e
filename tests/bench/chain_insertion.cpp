// SPDX-License-Identifier: AGPL-3.0-or-later
//
// What do known edges cost us, apart from finding them? The pieces of cards thrown on a table, from
// some hundred to some ten thousand: chaining them, and a preview's first samples (one per cent of
// 640x480) with them and without; the oracle costs next to nothing.
#include <benchmark/benchmark.h>

#include "core/edge_chains.h"
#include "core/mesh_previewer.h"
#include "core/session.h"
#include "tests/core/painted_cards.h"

namespace povpreview {
namespace {

constexpr glm::ivec2 size{640, 480};
constexpr std::size_t samples = 3072;

std::vector<ImageEdge> pieces_of(std::int64_t cards) {
    return PaintedCards(size, static_cast<int>(cards), 2).fragments(3);
}

void chain(benchmark::State& state) {
    const std::vector<ImageEdge> pieces = pieces_of(state.range(0));
    std::size_t chains = 0;
    for (auto _ : state) chains = chain_edges(pieces, size).size();
    state.counters["pieces"] = static_cast<double>(pieces.size());
    state.counters["chains"] = static_cast<double>(chains);
    state.counters["per piece"] = benchmark::Counter(
        static_cast<double>(pieces.size()),
        benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(chain)->Arg(50)->Arg(500)->Arg(5000)->Unit(benchmark::kMillisecond);

/// The first per cent of the samples, with edges that come before the first of them or not at all.
void preview(benchmark::State& state) {
    const bool known = state.range(1) != 0;
    const auto chains = chain_edges(pieces_of(state.range(0)), size);
    std::size_t constraints = 0;
    for (auto _ : state) {
        MeshPreviewer previewer(size.x, size.y);
        FunctionOracle oracle(images::constant(glm::vec3(.5f)));
        if (known) previewer.accept_edges(std::vector(chains));
        Session session(previewer, oracle);
        session.limit_full(samples);
        while (session.advance(std::chrono::milliseconds(1))) {
        }
        constraints = previewer.statistics().constraints;
    }
    state.counters["chains"] = known ? static_cast<double>(chains.size()) : 0;
    state.counters["constraints"] = static_cast<double>(constraints);
}
BENCHMARK(preview)
    ->ArgsProduct({{50, 500, 5000}, {0, 1}})
    ->ArgNames({"cards", "known"})
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace povpreview

BENCHMARK_MAIN();
