// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <unordered_map>

#include "core/oracle.h"

namespace povpreview {

/// The light of a sample as one rung of the ladder sees it.
struct RungLight {
    glm::vec3 colour{};
    /// colour = albedo * illumination + remainder, if that was recorded.
    bool shaded = false;
    glm::vec3 albedo{}, illumination{}, remainder{};
};

/// As a sample has it; `shaded`: its shading is to be reckoned with.
inline RungLight light_of(const Sample& sample, bool shaded) {
    if (!shaded) return {.colour = sample.colour};
    return {sample.colour, true, sample.albedo, sample.illumination, sample.remainder};
}

/// What a higher rung adds to the light of samples of a lower one, learnt from positions that were
/// traced at both and estimated everywhere else.
///
/// The estimate is smooth along a surface, and follows what has been learnt from coarse to fine:
///
///     estimate = mean of all surfaces, where light is concerned
///     for each level, from one cell across the image to one of 1/64 of it:
///         mix(estimate, mean of the level's four cells around the position, by how much is in
///         them)
///     and the same once more with this surface's own cells
///
/// Between surfaces nothing but light is shared, which the albedo turns into colour: what a white
/// wall gains says nothing about the colour of a black box on it.
class RungShift {
   public:
    /// `extent`: the larger side of the image, pixels.
    explicit RungShift(double extent) : extent_(extent) {}

    void learn(glm::dvec2 position, std::uint32_t surface, const RungLight& lower,
               const RungLight& higher);
    /// The light of a sample of the lower rung as the higher one may see it; no channel of the
    /// colour is below 0.
    RungLight apply(glm::dvec2 position, std::uint32_t surface, const RungLight& lower) const;
    /// Positions learnt from.
    std::size_t size() const { return size_; }

   private:
    /// Weighted sums of differences, and the sums of the weights.
    struct Cell {
        float weight = 0, light_weight = 0;
        glm::vec3 colour{}, illumination{}, remainder{};

        void add(const Cell& other, float share);
    };
    struct Estimate {
        glm::vec3 colour{}, illumination{}, remainder{};
        float doubt = 1;  ///< how much of the illumination is left to what was learnt elsewhere
    };
    static constexpr int levels = 7;

    template <class Visit>
    void for_cells_around(glm::dvec2 position, std::uint32_t surface, int level,
                          const Visit& visit) const;
    void add(glm::dvec2 position, std::uint32_t surface, const Cell& difference);
    Estimate estimate_on(std::uint32_t surface, glm::dvec2 position) const;

    double extent_;
    std::size_t size_ = 0;
    std::unordered_map<std::uint64_t, Cell> cells_;
};

}  // namespace povpreview
