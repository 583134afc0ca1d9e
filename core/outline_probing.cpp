// SPDX-License-Identifier: AGPL-3.0-or-later
// The three ways to find an outline by probes: across a guess, along a strip, all around.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/outline_walk.h"

namespace povpreview {

/// Finds the outline on the line through `at` along `normal` (which points left): brackets it by
/// `width`, gallops on to whichever side it is on up to `limit`, and bisects.
Routine<Crossing> OutlineTracer::Walk::cross(const OutlineRun& run, glm::dvec2 at,
                                             glm::dvec2 normal, double width, double limit) {
    double high = width, low = -width;  // where the left, the right surface is seen
    std::int64_t id = co_await ask(at + high * normal);
    if (id == run.left) {
        id = co_await ask(at + low * normal);
        while (id == run.left && 2 * low - width >= -limit) {
            high = low;
            low = 2 * low - width;
            id = co_await ask(at + low * normal);
        }
        if (id != run.right) co_return Crossing{std::nullopt, Side::right};
    } else {
        while (id == run.right && 2 * high + width <= limit) {
            low = high;
            high = 2 * high + width;
            id = co_await ask(at + high * normal);
        }
        if (id != run.left) co_return Crossing{std::nullopt, Side::left};
    }
    while (high - low > 2 * options_.position_error * 1.0001) {
        const double mid = (low + high) / 2;
        id = co_await ask(at + mid * normal);
        if (id != run.left && id != run.right) co_return Crossing{std::nullopt, Side::left};
        (id == run.left ? high : low) = mid;
    }
    co_return Crossing{at + (low + high) / 2 * normal, Side::left};
}

/// A guess `far` pixels straight on failed on one side. Finds where the strip along the tangent
/// `along` stops having the left surface on its left side and the right one on its right side.
///
///     - - - - - - - - - - - -.- - - -     left surface on this side up to here, then the
///     ●─────────────────────/─────────    right one (crossing) or a third (junction)
///     - - - - - - - - - - -/- - - - -     right surface on this side
///
/// Both sides are asked wherever the strip is taken to go on, since the outline may have left one
/// long ago where the other looks right again.
Routine<Departure> OutlineTracer::Walk::leave(const OutlineRun& run, glm::dvec2 along, double far,
                                              Side side) {
    const glm::dvec2 from = run.last(), left = left_of(along);
    // Wide enough for the last vertex to be in it for sure, narrow enough to count as straight.
    const double offset = std::max(2 * options_.position_error, .8 * options_.flatness);
    const auto place = [&](double t, Side s) {
        return from + t * along + (s == Side::left ? offset : -offset) * left;
    };
    const auto wanted = [&](Side s) { return s == Side::left ? run.left : run.right; };
    const auto opposite = [](Side s) { return s == Side::left ? Side::right : Side::left; };
    double good = 0, bad = far;
    std::int64_t shown = wanted(side);
    while (bad - good > options_.junction_error) {
        const double t = (good + bad) / 2;
        std::int64_t id = co_await ask(place(t, side));
        if (id == wanted(side)) {
            const std::int64_t beyond = co_await ask(place(t, opposite(side)));
            if (beyond == wanted(opposite(side))) {
                good = t;
                continue;
            }
            side = opposite(side);
            id = beyond;
        }
        bad = t;
        shown = id;
    }
    const double t = (good + bad) / 2;
    if (shown == wanted(side)) co_return Departure{Departure::Kind::none, from + good * along};
    if (shown == wanted(opposite(side))) {
        co_return Departure{Departure::Kind::crossing, place(t, side)};
    }
    const std::int64_t id = co_await ask(from + good * along);
    const double lateral = id == run.left ? -offset / 2 : id == run.right ? offset / 2 : 0.;
    co_return Departure{Departure::Kind::junction, from + t * along + lateral * left};
}

/// Finds the outline on the circle around the last vertex, within `half_angle` degrees of straight
/// on; on a smaller circle where that shows a third surface or not the two expected.
Routine<Turn> OutlineTracer::Walk::turn(const OutlineRun& run, double half_angle, double radius) {
    const glm::dvec2 centre = run.last(), ahead = run.direction(), left = left_of(ahead);
    const double widest = half_angle * std::numbers::pi / 180;
    bool third = false;
    for (; radius >= options_.smallest_feature; radius /= 2) {
        const auto place = [&](double angle) {
            return centre + radius * (std::cos(angle) * ahead + std::sin(angle) * left);
        };
        double high = widest, low = -widest;
        std::int64_t id = co_await ask(place(high));
        bool clear = id == run.left;
        third = third || (id != run.left && id != run.right);
        if (clear) {
            id = co_await ask(place(low));
            clear = id == run.right;
            third = third || (id != run.left && id != run.right);
        }
        while (clear && (high - low) * radius > 2 * options_.position_error) {
            const double mid = (low + high) / 2;
            id = co_await ask(place(mid));
            clear = id == run.left || id == run.right;
            third = third || !clear;
            (id == run.left ? high : low) = mid;
        }
        const glm::dvec2 found = place((low + high) / 2);
        if (clear && radius > 2 * options_.flatness) {
            // Nearer, on the way there, may be a corner that the circle jumped over.
            const glm::dvec2 mid = (centre + found) / 2.;
            const glm::dvec2 aside = options_.flatness * left_of((found - centre) / radius);
            id = co_await ask(mid + aside);
            clear = id == run.left;
            id = co_await ask(mid - aside);
            clear = clear && id == run.right;
        }
        if (clear) co_return Turn{found, third};
    }
    co_return Turn{std::nullopt, third};
}

}  // namespace povpreview
