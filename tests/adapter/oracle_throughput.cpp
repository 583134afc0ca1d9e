// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Questions: how many samples per second can the previewer's thread take from a tracer that costs
// nothing (time of this thread alone: the fake tracer has a core of its own), and how long does one
// sample take there and back? 1024 samples per slice is the real tracer's most.
#include <benchmark/benchmark.h>

#include "tests/adapter/oracle_fixture.h"

namespace povpreview {
namespace {

void throughput(benchmark::State& state) {
    const auto parts = static_cast<Parts>(state.range(0));
    PovrayOracle oracle({.program = FAKE_TRACER,
                         .arguments = {"slice=1024"},
                         .stall_timeout = std::chrono::seconds(60)});
    oracle.wait_for_scene(nullptr, nullptr);
    std::vector<Request> requests(16384);
    for (std::size_t i = 0; i < requests.size(); ++i) requests[i].position = {double(i % 64), 1};
    std::vector<Sample> samples;
    oracle.submit(requests, parts);
    for (auto _ : state) {
        oracle.submit(requests, parts);  // one batch ahead
        samples.clear();
        while (samples.size() < requests.size()) oracle.collect(samples, 1s);
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(requests.size()));
}
BENCHMARK(throughput)->ArgName("parts")->Arg(0)->Arg(7);

void latency(benchmark::State& state) {
    PovrayOracle oracle(
        {.program = FAKE_TRACER, .arguments = {}, .stall_timeout = std::chrono::seconds(60)});
    oracle.wait_for_scene(nullptr, nullptr);
    const Request one{.position = {3, 4}};
    std::vector<Sample> samples;
    for (auto _ : state) {
        samples.clear();
        oracle.submit({&one, 1}, Parts::colour);
        while (samples.empty()) oracle.collect(samples, 1s);
    }
}
BENCHMARK(latency)->UseRealTime();

}  // namespace
}  // namespace povpreview

BENCHMARK_MAIN();
