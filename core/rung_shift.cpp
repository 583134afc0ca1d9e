// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/rung_shift.h"

#include <cmath>
#include <glm/common.hpp>

namespace povpreview {

namespace {

/// Stands for all surfaces together; no surface has this number by any likelihood.
constexpr std::uint32_t all_surfaces = 0xffffffff;

/// So many samples in the cells around a position are believed as much as the coarser level.
constexpr float half_belief = .5f;

/// A share of the light too small to be looked up elsewhere.
constexpr float no_doubt = 1.f / 512;

std::uint64_t key_of(std::uint32_t surface, int level, int x, int y) {
    return std::uint64_t{surface} << 32 | std::uint64_t(level) << 28 |
           (std::uint64_t(y) & 0x3fff) << 14 | (std::uint64_t(x) & 0x3fff);
}

}  // namespace

/// Calls `visit(key, weight)` for the four cells whose centres surround the position; the weights
/// are bilinear:
///
///     +-----+-----+
///     |  c  |  c  |
///     +----*+-----+
///     |  c  |  c  |
///     +-----+-----+
template <class Visit>
void RungShift::for_cells_around(glm::dvec2 position, std::uint32_t surface, int level,
                                 const Visit& visit) const {
    const glm::dvec2 p = position / extent_ * double(1 << level) - .5;
    const glm::dvec2 low = glm::floor(p), part = p - low;
    const int x = static_cast<int>(low.x), y = static_cast<int>(low.y);
    for (int j = 0; j < 2; ++j)
        for (int i = 0; i < 2; ++i)
            visit(key_of(surface, level, x + i, y + j),
                  static_cast<float>((i ? part.x : 1 - part.x) * (j ? part.y : 1 - part.y)));
}

void RungShift::learn(glm::dvec2 position, std::uint32_t surface, const RungLight& lower,
                      const RungLight& higher) {
    Cell difference;
    difference.weight = 1;
    difference.colour = higher.colour - lower.colour;
    if (lower.shaded && higher.shaded) {
        difference.light_weight = 1;
        difference.illumination = higher.illumination - lower.illumination;
        difference.remainder = higher.remainder - lower.remainder;
    }
    add(position, surface, difference);
    add(position, all_surfaces, difference);
    ++size_;
}

void RungShift::Cell::add(const Cell& other, float share) {
    weight += share * other.weight;
    colour += share * other.colour;
    light_weight += share * other.light_weight;
    illumination += share * other.illumination;
    remainder += share * other.remainder;
}

void RungShift::add(glm::dvec2 position, std::uint32_t surface, const Cell& difference) {
    for (int level = 0; level < levels; ++level)
        for_cells_around(position, surface, level, [&](std::uint64_t key, float w) {
            if (w > 0) cells_[key].add(difference, w);
        });
}

/// The estimate from a surface's own cells.
RungShift::Estimate RungShift::estimate_on(std::uint32_t surface, glm::dvec2 position) const {
    Estimate estimate;
    for (int level = 0; level < levels; ++level) {
        Cell around;
        for_cells_around(position, surface, level, [&](std::uint64_t key, float w) {
            if (const auto cell = cells_.find(key); cell != cells_.end())
                around.add(cell->second, w);
        });
        if (around.weight <= 0) break;  // finer cells are empty as well
        const auto mix = [](glm::vec3& part, const glm::vec3& sum, float weight) {
            if (weight <= 0) return;
            part = glm::mix(part, sum / weight, weight / (weight + half_belief));
        };
        mix(estimate.colour, around.colour, around.weight);
        mix(estimate.illumination, around.illumination, around.light_weight);
        mix(estimate.remainder, around.remainder, around.light_weight);
        estimate.doubt *= half_belief / (around.light_weight + half_belief);
    }
    return estimate;
}

RungLight RungShift::apply(glm::dvec2 position, std::uint32_t surface,
                           const RungLight& lower) const {
    Estimate estimate = estimate_on(surface, position);
    if (lower.shaded && estimate.doubt > no_doubt)
        estimate.illumination += estimate.doubt * estimate_on(all_surfaces, position).illumination;
    RungLight shifted = lower;
    if (lower.shaded) {
        shifted.illumination = glm::max(lower.illumination + estimate.illumination, glm::vec3(0));
        shifted.remainder += estimate.remainder;
        shifted.colour = lower.albedo * shifted.illumination + shifted.remainder;
    } else {
        shifted.colour += estimate.colour;
    }
    shifted.colour = glm::max(shifted.colour, glm::vec3(0));
    return shifted;
}

}  // namespace povpreview
