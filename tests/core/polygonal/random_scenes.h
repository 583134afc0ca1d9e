// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <iosfwd>
#include <random>

#include "core/polygonal/polygon_scene.h"

namespace povpreview {

/// Kinds of small random scenes that edge finding is tested on.
enum class Family {
    triangles,     ///< free triangles and quadrilaterals, crossing each other
    boxes,         ///< boxes along the axes on a floor, many of them through one another
    turned_boxes,  ///< boxes turned any way, crossing each other and the floor
    blocks,        ///< boxes of a grid, side to side: edges and planes in common
    room,          ///< seen from inside a closed room, lights inside
    smooth_balls,
    flat_balls,
    mirrors,      ///< boxes before one or two flat mirrors
    mirror_hall,  ///< boxes between two mirrors that face each other
    mixed_styles  ///< transparent faces, and such as cast no shadow or stand in mirrors alone
};
std::ostream& operator<<(std::ostream& out, Family family);

/// Uniform numbers from a seed.
class Dice {
   public:
    explicit Dice(std::uint64_t seed) : engine_(seed) {}
    double from_to(double low, double high) {
        return low + (high - low) * std::uniform_real_distribution<double>(0, 1)(engine_);
    }
    /// An integer in [low, high].
    int whole(int low, int high) { return std::uniform_int_distribution<int>(low, high)(engine_); }
    bool chance(double share) { return from_to(0, 1) < share; }
    glm::dvec3 vector(double low, double high) {
        const double x = from_to(low, high), y = from_to(low, high);
        return {x, y, from_to(low, high)};
    }

   private:
    std::mt19937_64 engine_;
};

/// The scene of a family that belongs to a seed: 0 to 3 lights, point or parallel, a perspective
/// or (one in four) an orthographic camera, an image of size x size pixels.
PolygonScene random_scene(Family family, std::uint64_t seed, int size);

}  // namespace povpreview
