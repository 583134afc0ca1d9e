// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <unordered_map>
#include <vector>

#include "core/oracle.h"
#include "core/pixel_light.h"

namespace povpreview {

/// An oracle that remembers: in front of a tracer, it answers what an earlier run has traced, tells
/// of what this run traces, and knows what all pixels are made of.
///
/// Since a sample depends on its position and kind alone, a previewer whose earlier samples are
/// recalled does what it did then, and goes on from there. Full samples below the target rung are
/// neither kept nor told of: they are for the first look alone.
class SampleMemory : public SampleOracle {
   public:
    /// Of a picture of `width` x `height` pixels. The oracle must outlive it.
    SampleMemory(SampleOracle& oracle, int width, int height);

    /// Remembers a sample of an earlier run.
    void recall(const Sample& sample);
    /// Has every sample that the oracle answers told.
    void tell(std::function<void(const Sample&)> listener) { listener_ = std::move(listener); }

    /// The full samples that have come at pixel centres, row by row.
    const std::vector<PixelLight>& pixels() const { return pixels_; }
    /// Requests answered without the oracle.
    std::size_t recalled() const { return recalled_; }

    void submit(std::span<const Request> requests, Parts parts) override;
    void collect(std::vector<Sample>& samples, std::chrono::nanoseconds patience) override;

   private:
    struct Key {
        double x, y;
        RayKind kind;
        bool operator==(const Key&) const = default;
    };
    struct KeyHash {
        std::size_t operator()(const Key& key) const;
    };
    /// A request on its way.
    struct Slot {
        Sample sample;
        bool answered;
    };

    const Sample* find(const Request& request, Parts parts) const;
    void see(const Sample& sample);

    SampleOracle& oracle_;
    int width_, height_;
    std::unordered_map<Key, Sample, KeyHash> memory_;
    std::vector<PixelLight> pixels_;
    std::function<void(const Sample&)> listener_;
    std::deque<Slot> slots_;         // oldest first
    std::size_t waiting_ = 0;        // of them, for the oracle
    std::size_t first_waiting_ = 0;  // no slot before it waits
    std::size_t recalled_ = 0;
    std::vector<Request> asked_;
    std::vector<Sample> arrived_;
};

/// A sample with only the parts that a request for `parts` brings.
Sample with_parts(const Sample& sample, Parts parts);

}  // namespace povpreview
