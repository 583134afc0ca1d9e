// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/sample_memory.h"

#include <bit>
#include <cassert>
#include <cmath>

#include "core/colour.h"

namespace povpreview {

std::size_t SampleMemory::KeyHash::operator()(const Key& key) const {
    // Positions on pixel centres differ in few bits; a multiplication spreads them.
    constexpr std::uint64_t odd = 0x9e3779b97f4a7c15;
    std::uint64_t hash = std::bit_cast<std::uint64_t>(key.x) * odd;
    hash = (hash ^ (hash >> 32) ^ std::bit_cast<std::uint64_t>(key.y)) * odd;
    hash = (hash ^ (hash >> 32) ^ static_cast<std::uint64_t>(key.kind)) * odd;
    return static_cast<std::size_t>(hash ^ (hash >> 32));
}

SampleMemory::SampleMemory(SampleOracle& oracle, int width, int height)
    : oracle_(oracle),
      width_(width),
      height_(height),
      pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

Sample with_parts(const Sample& sample, Parts parts) {
    if (sample.kind != RayKind::full) return sample;  // these have no choice
    Sample result = sample;
    result.parts = parts;
    if (!contains(parts, Parts::surface)) {
        result.surface = result.reflected_surface = 0;
        result.depth = 0;
        result.normal = {};
    }
    if (!contains(parts, Parts::shading))
        result.albedo = result.illumination = result.remainder = {};
    if (!contains(parts, Parts::signature)) result.signature = {};
    return result;
}

void SampleMemory::recall(const Sample& sample) {
    const Key key{sample.position.x, sample.position.y, sample.kind};
    const auto [known, is_new] = memory_.try_emplace(key, sample);
    if (!is_new && contains_all(sample.parts, known->second.parts)) known->second = sample;
}

const Sample* SampleMemory::find(const Request& request, Parts parts) const {
    if (request.kind == RayKind::full && request.rung != target_rung) return nullptr;
    const auto known = memory_.find({request.position.x, request.position.y, request.kind});
    if (known == memory_.end()) return nullptr;
    const bool enough = request.kind != RayKind::full || contains_all(known->second.parts, parts);
    return enough ? &known->second : nullptr;
}

/// Keeps what a pixel is made of.
void SampleMemory::see(const Sample& sample) {
    if (sample.kind != RayKind::full || sample.rung != target_rung) return;
    const double column = std::floor(sample.position.x), row = std::floor(sample.position.y);
    if (sample.position != glm::dvec2(column + .5, row + .5) || column < 0 || row < 0 ||
        column >= width_ || row >= height_)
        return;
    const bool usable = !sample.failed && finite(sample.colour);
    pixels_[static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) +
            static_cast<std::size_t>(column)] = {sample.colour, sample.transmittance, usable};
}

void SampleMemory::submit(std::span<const Request> requests, Parts parts) {
    asked_.clear();
    for (const Request& request : requests) {
        const Sample* known = find(request, parts);
        slots_.push_back({known ? with_parts(*known, parts) : Sample{}, known != nullptr});
        if (known) {
            ++recalled_;
        } else {
            asked_.push_back(request);
            ++waiting_;
        }
    }
    if (!asked_.empty()) oracle_.submit(asked_, parts);
}

void SampleMemory::collect(std::vector<Sample>& samples, std::chrono::nanoseconds patience) {
    if (waiting_ > 0) {
        const bool ready = slots_.front().answered;
        arrived_.clear();
        oracle_.collect(arrived_, ready ? std::chrono::nanoseconds::zero() : patience);
        for (const Sample& sample : arrived_) {
            while (slots_[first_waiting_].answered) ++first_waiting_;
            Slot& slot = slots_[first_waiting_];
            slot.sample = sample;
            slot.answered = true;
            --waiting_;
            if (listener_ && sample.rung == target_rung) listener_(sample);
        }
    }
    while (!slots_.empty() && slots_.front().answered) {
        see(slots_.front().sample);
        samples.push_back(slots_.front().sample);
        slots_.pop_front();
        if (first_waiting_ > 0) --first_waiting_;
    }
}

}  // namespace povpreview
