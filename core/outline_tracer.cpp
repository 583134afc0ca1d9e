// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/outline_tracer.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/outline_walk.h"
#include "core/polyline.h"

namespace povpreview {
namespace {

/// Steps up to this many pixels are not checked in the middle, and corners that stop a step not
/// longer than this are searched around the last vertex.
constexpr double short_step = 8;
/// Steps shorter than this give way to a search all around, pixels.
constexpr double shortest_step = 1;
/// How much a step grows after one that held. A located point costs the bisections that its guess
/// leaves open, growing with the logarithm of this, and saves the same logarithm of steps.
constexpr double growth = 4;
/// At a corner the outline may turn this far off straight on, either way, degrees; the rest is the
/// way it came.
constexpr double widest_turn = 160;

/// Two lost ends nearer to each other than this many pixels are the two sides of one tip, too sharp
/// to be walked around.
constexpr double sharp_tip = 2;

bool finite(glm::dvec2 p) { return std::isfinite(p.x) && std::isfinite(p.y); }

}  // namespace

OutlineTracer::Walk::Walk(const Sample& a, const Sample& b, glm::ivec2 image_size,
                          const OutlineOptions& options)
    : options_(options), size_(image_size), trace_(trace(a, b)) {
    options_.flatness = std::min(options_.flatness, .5);
    const bool bracket = identity(a) != identity(b) && identity(a) != nothing_known &&
                         identity(b) != nothing_known && finite(a.position) && finite(b.position);
    if (bracket) {
        trace_.start();
    } else {
        finished_ = true;
    }
    settle();
}

std::optional<glm::dvec2> OutlineTracer::Walk::next() {
    const auto wanted = channel_.take();
    outstanding_ = outstanding_ || wanted.has_value();
    return wanted;
}

void OutlineTracer::Walk::accept(const Sample& probe) {
    assert(outstanding_);
    outstanding_ = false;
    ++outline_.probes;
    channel_.answer(identity(probe));
    if (!trace_.finished() && outline_.probes >= options_.most_probes) {
        finished_ = true;
        channel_.take();
    }
    settle();
}

/// Bisects the seed, then walks ahead, and, unless that came back to the start, behind.
Routine<bool> OutlineTracer::Walk::trace(Sample a, Sample b) {
    const std::int64_t left = identity(a);
    std::int64_t right = identity(b);
    glm::dvec2 p = a.position, q = b.position;
    // The bracket may be no longer than the error allowed even before its first bisection.
    const glm::dvec2 apart = p - q;
    if (!(glm::length(apart) > 0)) co_return false;
    while (glm::distance(p, q) > 2 * options_.position_error) {
        const glm::dvec2 mid = (p + q) / 2.;
        const std::int64_t id = co_await ask(mid);
        if (id == left) {
            p = mid;
        } else {
            q = mid;
            right = id;
        }
    }
    const glm::dvec2 start = (p + q) / 2.;
    if (right == nothing_known || !inside(start)) co_return false;

    const glm::dvec2 normal = glm::normalize(apart);
    ahead_.emplace(start, glm::dvec2(-normal.y, normal.x), left, right, size_, options_);
    const double first = options_.first_step;
    Turn second = co_await turn(*ahead_, 90, first);
    if (!second.at) {
        ahead_->finish(second.third ? OutlineEnd::junction : OutlineEnd::lost);
    } else {
        ahead_->append(*second.at);
    }
    bool go_on = co_await follow(*ahead_, growth * first);
    if (ahead_->end() == OutlineEnd::closed) co_return true;
    behind_.emplace(ahead_->reversed());
    const double step = std::max(first, growth * behind_->smooth_length());
    go_on = co_await follow(*behind_, std::min(step, options_.longest_step));
    co_return go_on;
}

/// Walks until the run ends.
Routine<bool> OutlineTracer::Walk::follow(OutlineRun& run, double step) {
    while (!run.end()) {
        step = std::min({step, options_.longest_step, run.distance_to_border() + .5});
        const OutlineRun::Guess guess = run.guess(step);
        step = guess.reach;
        const double width = std::max(guess.uncertainty, options_.position_error);
        const double limit =
            std::max(std::min(guess.bend, step <= 2 * short_step ? step / 2 : step / 4), 2 * width);
        const Crossing found = co_await cross(run, guess.at, guess.left, width, limit);
        if (found.at) {
            const double length = glm::distance(run.last(), *found.at);
            const std::optional<Circle> arc = run.arc_to(*found.at);
            const double bend = arc ? angle_between(*arc, run.last(), *found.at) : 0;
            const bool as_guessed = glm::distance(*found.at, guess.at) <= width;
            if (length <= short_step / 2 || (step <= short_step && as_guessed)) {
                if (arc) {
                    run.append_arc(turned(*arc, run.last(), bend / 2), *found.at);
                } else {
                    run.append(*found.at);
                }
                step *= growth;
                continue;
            }
            const bool straight = co_await refine(run, arc, *found.at, length / 16);
            step = straight ? step * growth : step / 2;
        } else if (step > short_step) {
            const Departure departure = co_await leave(run, guess.tangent, step, found.unexpected);
            if (departure.kind == Departure::Kind::none) {
                step /= growth;
                continue;
            }
            const double covered = glm::distance(run.last(), departure.at);
            run.append(departure.at);
            if (departure.kind == Departure::Kind::junction) {
                run.finish(OutlineEnd::junction);
            } else if (!run.end()) {
                step = co_await resume(run, covered);
            }
        } else if (step > shortest_step) {
            step /= 2;
        } else {
            const bool turned = co_await around_corner(run, shortest_step);
            step = turned ? growth * shortest_step : step;
        }
    }
    co_return true;
}

/// Goes on after the outline left a straight strip `covered` pixels long: along the bend, if it is
/// one, else from the corner. Returns the next step, pixels.
Routine<double> OutlineTracer::Walk::resume(OutlineRun& run, double covered) {
    if (covered > 2 * shortest_step) {
        const OutlineRun::Guess bend = run.guess(std::min(covered, short_step));
        const double width = std::max(bend.uncertainty, 2 * options_.position_error);
        const Crossing found = co_await cross(run, bend.at, bend.left, width, width);
        if (found.at) {
            run.append(*found.at);
            co_return 2 * covered;
        }
    }
    const bool turned = co_await around_corner(run, options_.first_step);
    co_return turned ? growth* glm::distance(run.last(), run.before_last()) : shortest_step;
}

/// Appends the curve from the run's last vertex to the located point `b`, checked in the middle
/// against `arc` (or the chord) within `limit` pixels, in halves where that shows a bend. False: it
/// ran into something on the way, or bends more than the steps so far knew.
///
///            mid
///         .───●───.        ● located
///       /           \      the chord's middle would be below
///      ● last        ● b
Routine<bool> OutlineTracer::Walk::refine(OutlineRun& run, std::optional<Circle> arc, glm::dvec2 b,
                                          double limit) {
    const glm::dvec2 a = run.last();
    const double length = glm::distance(a, b);
    if (length <= short_step / 2) {
        run.append(b);
        co_return true;
    }
    glm::dvec2 expected = (a + b) / 2.;
    if (arc) expected = turned(*arc, a, angle_between(*arc, a, b) / 2);
    const glm::dvec2 normal = left_of((b - a) / length);
    const double width = options_.position_error;
    limit = std::max(limit, 2 * options_.flatness);
    const Crossing mid = co_await cross(run, expected, normal, width, limit);
    if (!mid.at) co_return false;

    const double off = glm::distance(*mid.at, expected);
    if (off <= std::max(options_.flatness, 2 * width)) {
        run.append_arc(*mid.at, b);
        co_return true;
    }
    // Over half the length, a smooth curve bends off a quarter as far. What bends off more is a
    // corner, or another piece of outline beyond a gap.
    const std::optional<Circle> through = circle_through(a, *mid.at, b);
    co_await refine(run, through, *mid.at, off / 2);
    if (run.last() == *mid.at && !run.end()) {
        co_await refine(run, through, b, off / 2);
    }
    co_return false;
}

/// Looks all around the last vertex for the way on; ends the run where there is none.
Routine<bool> OutlineTracer::Walk::around_corner(OutlineRun& run, double radius) {
    const Turn next = co_await turn(run, widest_turn, radius);
    if (!next.at) {
        run.finish(next.third ? OutlineEnd::junction : OutlineEnd::lost);
        co_return false;
    }
    run.corner(glm::normalize(*next.at - run.last()));
    run.append(*next.at);
    co_return true;
}

/// Once the walk is over, makes the outline of what it found.
void OutlineTracer::Walk::settle() {
    if (!finished_ && trace_.finished()) {
        trace_.result();
        finished_ = true;
    }
    if (!finished_ || !ahead_) return;
    Polyline line;
    const bool closed_behind = behind_ && behind_->end() == OutlineEnd::closed;
    if (closed_behind) ahead_.emplace(*behind_), behind_.reset();
    if (behind_) line.assign(behind_->vertices().rbegin(), behind_->vertices().rend() - 1);
    line.insert(line.end(), ahead_->vertices().begin(), ahead_->vertices().end());
    outline_.end = ahead_->end().value_or(OutlineEnd::lost);
    outline_.begin = behind_ ? behind_->end().value_or(OutlineEnd::lost) : outline_.end;
    const bool tip = outline_.begin == OutlineEnd::lost && outline_.end == OutlineEnd::lost &&
                     line.size() > 3 && glm::distance(line.front(), line.back()) < sharp_tip;
    if (tip) outline_.begin = outline_.end = OutlineEnd::closed;
    outline_.closed = outline_.end == OutlineEnd::closed;
    outline_.left = static_cast<std::uint32_t>(ahead_->left);
    outline_.right = static_cast<std::uint32_t>(ahead_->right);
    // The vertices' own error, half of position_error as a rule, uses up some of what is allowed.
    const double tolerance = std::max(options_.flatness - options_.position_error / 2, 0.);
    outline_.vertices = simplify(line, tolerance, outline_.closed);
    if (outline_.vertices.size() < 2) outline_.vertices.clear();
}

OutlineTracer::OutlineTracer(const Sample& a, const Sample& b, glm::ivec2 image_size,
                             const OutlineOptions& options)
    : walk_(std::make_unique<Walk>(a, b, image_size, options)) {}
OutlineTracer::~OutlineTracer() = default;
OutlineTracer::OutlineTracer(OutlineTracer&&) noexcept = default;
OutlineTracer& OutlineTracer::operator=(OutlineTracer&&) noexcept = default;

std::optional<glm::dvec2> OutlineTracer::next() { return walk_->next(); }
void OutlineTracer::accept(const Sample& probe) { walk_->accept(probe); }
bool OutlineTracer::done() const { return walk_->done(); }
const Outline& OutlineTracer::outline() const { return walk_->outline(); }

}  // namespace povpreview
