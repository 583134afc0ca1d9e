// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "adapter/povray_oracle.h"
#include "tests/adapter/fake_world.h"

namespace povpreview {

using namespace std::chrono_literals;

/// A PovrayOracle over the fake tracer with these arguments (see fake_tracer.cpp).
inline PovrayOracle::Settings fake_tracer(std::vector<std::string> arguments,
                                          std::chrono::milliseconds stall_timeout = 60s) {
    return {
        .program = FAKE_TRACER, .arguments = std::move(arguments), .stall_timeout = stall_timeout};
}

/// Every pixel centre of the fake scene.
inline std::vector<Request> all_pixels(RayKind kind = RayKind::full) {
    std::vector<Request> requests;
    for (int y = 0; y < fake::height; ++y)
        for (int x = 0; x < fake::width; ++x) requests.push_back({{x + .5, y + .5}, kind});
    return requests;
}

/// Submits all and collects until all have come; fails after `limit`.
inline std::vector<Sample> trace(PovrayOracle& oracle, const std::vector<Request>& requests,
                                 Parts parts, std::chrono::seconds limit = 20s) {
    const auto deadline = std::chrono::steady_clock::now() + limit;
    oracle.submit(requests, parts);
    std::vector<Sample> samples;
    while (samples.size() < requests.size()) {
        oracle.collect(samples, 20ms);
        if (std::chrono::steady_clock::now() > deadline) {
            ADD_FAILURE() << "only " << samples.size() << " of " << requests.size() << " came";
            break;
        }
    }
    return samples;
}

inline void expect_equal(const Sample& a, const Sample& b) {
    EXPECT_EQ(a.position, b.position);
    EXPECT_EQ(a.kind, b.kind);
    EXPECT_EQ(a.failed, b.failed);
    EXPECT_EQ(a.colour, b.colour);
    EXPECT_EQ(a.transmittance, b.transmittance);
    EXPECT_EQ(a.surface, b.surface);
    EXPECT_EQ(a.depth, b.depth);
    EXPECT_EQ(a.normal, b.normal);
    EXPECT_EQ(a.albedo, b.albedo);
    EXPECT_EQ(a.illumination, b.illumination);
    EXPECT_EQ(a.remainder, b.remainder);
    EXPECT_EQ(a.signature, b.signature);
    EXPECT_EQ(a.cost_ns, b.cost_ns);
}

/// All as the fake world has them, in the order of the requests, except that those in `failed` (as
/// many as it says, by predicate) must be failed ones.
inline void expect_right(const std::vector<Sample>& samples, const std::vector<Request>& requests,
                         Parts parts, const std::function<bool(const Sample&)>& failed = nullptr) {
    ASSERT_EQ(samples.size(), requests.size());
    for (std::size_t i = 0; i < samples.size(); ++i) {
        SCOPED_TRACE(testing::Message() << "sample " << i);
        Sample expected = fake::sample_at(requests[i].position, requests[i].kind, parts);
        if (failed && failed(expected)) {
            expected = {.position = requests[i].position, .kind = requests[i].kind, .failed = true};
            expected.cost_ns = samples[i].cost_ns;
        }
        expect_equal(samples[i], expected);
        if (testing::Test::HasFailure()) return;
    }
}

inline std::size_t open_descriptors() {
    const std::filesystem::directory_iterator all("/proc/self/fd");
    return static_cast<std::size_t>(std::distance(begin(all), end(all)));
}

/// Every test must leave no descriptor, no child and no zombie behind, and be quick.
class OracleTest : public testing::Test {
   protected:
    void SetUp() override {
        descriptors_ = open_descriptors();
        start_ = std::chrono::steady_clock::now();
    }
    void TearDown() override;

    /// Waits for the scene, then traces all pixels; returns the message of the Error that this
    /// must throw, after a check that it exits with `exit`, and that the oracle stays broken.
    static std::string error_of(const PovrayOracle::Settings& settings, Exit exit);
    /// A path to a file that does not exist, for the fake tracer's `once`; gone after the test.
    static std::string fresh_file();

   private:
    std::size_t descriptors_ = 0;
    std::chrono::steady_clock::time_point start_;
};

}  // namespace povpreview
