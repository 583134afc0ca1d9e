// SPDX-License-Identifier: AGPL-3.0-or-later
#include "backend/oracle/gathered_light.h"

#include <cmath>
#include <mutex>

namespace povpreview::tracer {

namespace {

/// Sides of the cells, against the distance of what light comes from: from 8 times that to 1/8.
constexpr double coarsest = 8;
constexpr int levels = 7;

/// So much light in the cells around a place is believed as much as what is known from farther.
constexpr float half_belief = .5f;

Rgb mix(const Rgb& a, const Rgb& b, float t) {
    return {a.r + t * (b.r - a.r), a.g + t * (b.g - a.g), a.b + t * (b.b - a.b)};
}

std::uint64_t key_of(int direction, int level, const std::array<std::int64_t, 3>& cell) {
    std::uint64_t key = static_cast<std::uint64_t>(8 * direction + level);
    for (const std::int64_t i : cell) key = key << 19 | (static_cast<std::uint64_t>(i) & 0x7ffff);
    return key;
}

}  // namespace

void GatheredLight::Cell::add(const Cell& other, float share) {
    sum = {sum.r + share * other.sum.r, sum.g + share * other.sum.g, sum.b + share * other.sum.b};
    weight += share * other.weight;
}

/// Calls `visit(key, weight)` for the eight cells whose middles surround a place, for each of the
/// up to three directions that a normal lies between.
template <class Visit>
void GatheredLight::for_cells_around(const Point& place, const Point& normal, int level,
                                     const Visit& visit) const {
    const double scale = std::ldexp(1 / extent_, level);
    std::array<double, 3> part{place.x * scale - .5, place.y * scale - .5, place.z * scale - .5};
    std::array<std::int64_t, 3> low;
    for (int axis = 0; axis < 3; ++axis) {
        // What is beyond all bounds shares its cells.
        const double below = std::floor(std::fmax(-1e9, std::fmin(part[axis], 1e9)));
        low[axis] = static_cast<std::int64_t>(below);
        part[axis] = std::fmax(0., std::fmin(part[axis] - below, 1.));
    }
    const std::array<double, 3> along{normal.x, normal.y, normal.z};
    for (int axis = 0; axis < 3; ++axis) {
        const double facing = along[axis] * along[axis];
        if (!(facing > .01)) continue;
        const int direction = 2 * axis + (along[axis] > 0);
        for (int corner = 0; corner < 8; ++corner) {
            std::array<std::int64_t, 3> cell = low;
            double weight = facing;
            for (int i = 0; i < 3; ++i) {
                const bool upper = corner >> i & 1;
                cell[i] += upper;
                weight *= upper ? part[i] : 1 - part[i];
            }
            if (weight > 0) visit(key_of(direction, level, cell), static_cast<float>(weight));
        }
    }
}

void GatheredLight::add(const Point& place, const Point& normal, double distance,
                        const Rgb& light) {
    const Cell gathered{light, 1};
    const std::lock_guard lock(mutex_);
    if (extent_ == 0) extent_ = std::fmax(coarsest * distance, 1e-9);
    all_.add(gathered, 1);
    for (int level = 0; level < levels; ++level)
        for_cells_around(place, normal, level, [&](std::uint64_t key, float weight) {
            cells_[key].add(gathered, weight);
        });
}

Rgb GatheredLight::guess(const Point& place, const Point& normal) const {
    const std::shared_lock lock(mutex_);
    if (all_.weight == 0) return {};
    Rgb guess = mix({}, all_.sum, 1 / all_.weight);
    for (int level = 0; level < levels; ++level) {
        Cell around;
        for_cells_around(place, normal, level, [&](std::uint64_t key, float weight) {
            const auto found = cells_.find(key);
            if (found != cells_.end()) around.add(found->second, weight);
        });
        if (around.weight > 0)
            guess = mix(guess, mix({}, around.sum, 1 / around.weight),
                        around.weight / (around.weight + half_belief));
    }
    return guess;
}

}  // namespace povpreview::tracer
