// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/outline_run.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

namespace povpreview {
namespace {

/// How near to its start a walk must pass to have come back to it, pixels: more than the errors of
/// the start and of the polyline together.
constexpr double homecoming = .75;
/// How far a walk must have gone before it can come back, pixels: the smallest loop told from
/// noise.
constexpr double smallest_loop = 2;
/// Arcs are extrapolated and drawn over at most this angle, radians.
constexpr double widest_arc = 1;

/// Distance of `b` from the line through `a` and `c`.
double sagitta(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
    const glm::dvec2 d = c - a;
    const double length = glm::length(d);
    return length > 0 ? std::abs(glm::dot(b - a, left_of(d))) / length : glm::distance(a, b);
}

glm::dvec2 unit(glm::dvec2 v, glm::dvec2 otherwise) {
    const double length = glm::length(v);
    return length > 0 ? v / length : otherwise;
}

}  // namespace

OutlineRun::OutlineRun(glm::dvec2 start, glm::dvec2 direction, std::int64_t left_id,
                       std::int64_t right_id, glm::dvec2 size, const OutlineOptions& options)
    : left(left_id),
      right(right_id),
      size_(size),
      options_(options),
      vertices_{start},
      smooth_{start},
      first_smooth_{start},
      direction_(direction),
      first_direction_(direction) {}

OutlineRun OutlineRun::reversed() const {
    glm::dvec2 back = -first_direction_;
    if (first_smooth_.size() > 1) back = unit(first_smooth_[0] - first_smooth_[1], back);
    OutlineRun run(vertices_.front(), back, right, left, size_, options_);
    run.smooth_.assign(first_smooth_.rbegin(), first_smooth_.rend());
    return run;
}

double OutlineRun::distance_to_border() const {
    double distance = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 2; ++k) {
        if (direction_[k] == 0) continue;
        const double side = direction_[k] > 0 ? size_[k] : 0;
        distance = std::min(distance, (side - last()[k]) / direction_[k]);
    }
    return std::max(distance, 0.);
}

std::optional<std::pair<glm::dvec2, glm::dvec2>> OutlineRun::past(double span) const {
    if (smooth_.size() < 2) return std::nullopt;
    std::size_t far = smooth_.size() - 2;
    // Stops where the curve has turned so far that going back along it comes nearer again.
    while (far > 0) {
        const double farther = glm::distance(smooth_[far - 1], last());
        if (farther > span || farther < glm::distance(smooth_[far], last())) break;
        --far;
    }
    const double half = glm::distance(smooth_[far], last()) / 2;
    std::size_t near = far;
    for (std::size_t i = far; i + 1 < smooth_.size(); ++i) {
        const auto off = [&](std::size_t j) {
            return std::abs(glm::distance(smooth_[j], last()) - half);
        };
        if (off(i) < off(near)) near = i;
    }
    return std::pair{smooth_[far], smooth_[near]};
}

OutlineRun::Guess OutlineRun::guess(double step) const {
    const double e = options_.position_error;
    const auto known = past(2 * step);
    if (!known) {
        return {last() + step * direction_,
                left_of(direction_),
                direction_,
                .25 * step + e,
                step,
                step};
    }
    const auto [far, near] = *known;
    const double baseline = glm::distance(far, last());
    // A bend no larger than the errors of its three points is taken for a straight line.
    const double unseen = 1.5 * e;
    std::optional<Circle> circle;
    if (far != near && sagitta(far, near, last()) > unseen) {
        circle = circle_through(far, near, last());
    }
    if (!circle) {
        const glm::dvec2 d = unit(last() - far, direction_);
        // An arc with this sagitta over the baseline, seen from the line through its ends.
        const double ratio = step / baseline;
        const double bend = 4 * unseen * ratio * (ratio + 1);
        return {last() + step * d, left_of(d), d, e * (.5 + ratio), bend, step};
    }
    // Half the baseline is the spacing of the three points; beyond twice that, the error of the
    // extrapolated arc grows with the square and outruns what is saved.
    step = std::min({step, baseline, widest_arc * circle->radius});
    const bool clockwise = angle_between(*circle, near, last()) > 0;
    const double angle = (clockwise ? 1 : -1) * step / circle->radius;
    const glm::dvec2 at = turned(*circle, last(), angle);
    const glm::dvec2 radial = unit(at - circle->centre, {1, 0});
    const glm::dvec2 here = left_of(unit(last() - circle->centre, {1, 0}));
    const double m = 2 * step / baseline;
    return {at,
            clockwise ? radial : -radial,
            clockwise ? -here : here,
            e * (.5 + .5 * m * (m + 2)),
            step / 2,
            step};
}

std::optional<Circle> OutlineRun::arc_to(glm::dvec2 b) const {
    const auto known = past(glm::distance(last(), b));
    if (!known) return std::nullopt;
    const auto circle = circle_through(known->first, last(), b);
    if (!circle || std::abs(angle_between(*circle, last(), b)) > 2 * widest_arc) {
        return std::nullopt;
    }
    return circle;
}

double OutlineRun::smooth_length() const { return glm::distance(smooth_.front(), last()); }

void OutlineRun::append_vertex(glm::dvec2 p) {
    if (end_ || p == last()) return;
    const glm::dvec2 d = unit(p - last(), direction_);
    if (vertices_.size() == 1) first_direction_ = d;
    if (travelled_ > smallest_loop && glm::dot(d, first_direction_) > 0 &&
        distance_to_segment(vertices_.front(), last(), p) < homecoming) {
        end_ = OutlineEnd::closed;
        return;
    }
    const bool outside = p.x < 0 || p.y < 0 || p.x > size_.x || p.y > size_.y;
    if (outside) {
        p = clip_to_border(last(), p, size_);
        end_ = OutlineEnd::border;
    }
    travelled_ += glm::distance(last(), p);
    vertices_.push_back(p);
    direction_ = d;
}

void OutlineRun::append(glm::dvec2 located) {
    append_vertex(located);
    if (end_) return;
    smooth_.push_back(located);
    if (!turned_) first_smooth_.push_back(located);
}

void OutlineRun::append_arc(glm::dvec2 mid, glm::dvec2 b) {
    const glm::dvec2 a = last();
    const auto circle = circle_through(a, mid, b);
    const bool bends = circle && sagitta(a, mid, b) > options_.position_error &&
                       std::abs(angle_between(*circle, a, b)) < 2 * widest_arc;
    for (const glm::dvec2 to : {mid, b}) {
        if (bends) {
            // Pieces so short that the chord is within a quarter of the flatness of the arc.
            const double angle = angle_between(*circle, last(), to);
            const double piece = std::sqrt(2 * options_.flatness / circle->radius);
            const int pieces = static_cast<int>(std::min(std::ceil(std::abs(angle) / piece), 64.));
            const glm::dvec2 from = last();
            for (int i = 1; i < pieces; ++i)
                append_vertex(turned(*circle, from, angle * i / pieces));
        }
        append(to);
    }
    if (bends && !end_) {
        const glm::dvec2 radial = unit(b - circle->centre, direction_);
        const bool clockwise = angle_between(*circle, mid, b) > 0;
        direction_ = clockwise ? glm::dvec2(-radial.y, radial.x) : left_of(radial);
    }
}

void OutlineRun::corner(glm::dvec2 direction) {
    turned_ = true;
    smooth_ = {last()};
    direction_ = direction;
}

}  // namespace povpreview
