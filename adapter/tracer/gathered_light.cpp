// SPDX-License-Identifier: AGPL-3.0-or-later
#include "backend/oracle/gathered_light.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <mutex>

namespace povpreview::tracer {

namespace {

/// Sides of the cells, against the distance of what light comes from: 8 times that, 2, 1/2, 1/8.
constexpr double coarsest = 8;
constexpr int levels = 4, halvings = 2;

/// So much light in the cells around a place is believed as much as what is known from farther.
constexpr float half_belief = .5f;

/// A share of the guess too small to be looked up.
constexpr float no_doubt = 1.f / 64;

using Index = std::array<std::int64_t, 3>;

std::uint64_t key_of(int direction, int level, const Index& cell) {
    std::uint64_t key = static_cast<std::uint64_t>(8 * direction + level);
    for (const std::int64_t i : cell) key = key << 19 | (static_cast<std::uint64_t>(i) & 0x7ffff);
    return key;
}

/// Calls `visit(direction, share)` for the one to three directions along the axes that a normal
/// lies between.
template <class Visit>
void for_directions(const Point& normal, const Visit& visit) {
    constexpr double least = .05;
    const double along[] = {normal.x, normal.y, normal.z};
    for (int axis = 0; axis < 3; ++axis)
        if (const double share = along[axis] * along[axis]; share > least)
            visit(2 * axis + (along[axis] > 0), share);
}

/// Where a place lies in the cells of a level: which cell, and how far in it, 0 to 1.
struct Location {
    Index cell;
    std::array<double, 3> part;
};

Location locate(const std::array<double, 3>& in_cells) {
    constexpr double farthest = 1e9;  // what is beyond shares its cells
    Location location;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double at = std::fmax(-farthest, std::fmin(in_cells[axis], farthest));
        const double low = std::floor(at);
        location.cell[axis] = static_cast<std::int64_t>(low);
        location.part[axis] = at - low;
    }
    return location;
}

}  // namespace

void GatheredLight::Cell::add(const Cell& other, float share) {
    sum = {sum.r + share * other.sum.r, sum.g + share * other.sum.g, sum.b + share * other.sum.b};
    weight += share * other.weight;
}

double GatheredLight::cells_per_unit(int level) const {
    return std::ldexp(1 / extent_, halvings * level);
}

void GatheredLight::add(const Point& place, const Point& normal, double distance,
                        const Rgb& light) {
    const Cell gathered{light, 1};
    const std::lock_guard lock(mutex_);
    if (extent_ == 0) extent_ = std::fmax(coarsest * distance, 1e-9);
    all_.add(gathered, 1);
    for (int level = 0; level < levels; ++level) {
        const Point p = cells_per_unit(level) * place;
        const Index cell = locate({p.x, p.y, p.z}).cell;
        for_directions(normal, [&](int direction, double share) {
            cells_[key_of(direction, level, cell)].add(gathered, static_cast<float>(share));
        });
    }
}

/// The light in the eight cells whose middles surround a place, of what faces the same way.
GatheredLight::Cell GatheredLight::around(const Point& place, const Point& normal,
                                          int level) const {
    Cell around;
    const Point p = cells_per_unit(level) * place;
    const Location location = locate({p.x - .5, p.y - .5, p.z - .5});
    for_directions(normal, [&](int direction, double share) {
        for (unsigned corner = 0; corner < 8; ++corner) {
            Index cell = location.cell;
            double weight = share;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const bool upper = corner >> axis & 1;
                cell[axis] += upper;
                weight *= upper ? location.part[axis] : 1 - location.part[axis];
            }
            const auto found = cells_.find(key_of(direction, level, cell));
            if (found != cells_.end()) around.add(found->second, static_cast<float>(weight));
        }
    });
    return around;
}

Rgb GatheredLight::guess(const Point& place, const Point& normal) const {
    const std::shared_lock lock(mutex_);
    if (all_.weight == 0) return {};
    Cell guess;
    float doubt = 1;
    for (int level = levels - 1; level >= 0 && doubt > no_doubt; --level) {
        const Cell near = around(place, normal, level);
        if (!(near.weight > 0)) continue;
        const float belief = doubt * near.weight / (near.weight + half_belief);
        guess.add(near, belief / near.weight);
        doubt -= belief;
    }
    guess.add(all_, doubt / all_.weight);
    return guess.sum;
}

}  // namespace povpreview::tracer
