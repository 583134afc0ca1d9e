// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/rung_climb.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>

#include "core/colour.h"
#include "core/cost_plan.h"

namespace povpreview {

namespace {

/// A picture stands when this share of the pixels is sampled.
constexpr double standing_share = 1. / 128;

/// Positions traced at two rungs to learn what the higher one costs. Few: where that is very dear,
/// all else waits for them.
constexpr std::size_t trials = 8;

/// The first of them, which tell whether the others would be in the first picture's way. With all
/// of them at once chess2 at 1920x1080, whose target is dear, came to an error of .05 after .14 s
/// instead of .04 s.
constexpr std::size_t early_trials = 2;

/// Where each of those cost less, in nanoseconds, no others are needed: to wait for them would take
/// as long as they do.
constexpr std::uint32_t cheap_ns = 20'000;

/// A lower rung gains nothing where the higher one is not dearer by this factor, or where a picture
/// stands on the higher one within so many nanoseconds of one thread. At 1920x1080 orient, whose
/// target needs a quarter of that, comes to an error of .02 after .05 s at once and .7 s by its
/// sketch; abyss, 17 us and 56 us a sample, after .03 s or .2 s.
constexpr double least_gain = 4;
constexpr double moment_ns = 1e9;

/// A lower rung may take this share of what it takes until the picture stands on the higher one: as
/// much as that is late if the lower one's picture soon errs by its own light alone. abyss at
/// 1920x1080, 18 us and 64 us a sample, had an error of .02 after .04 s or .4 s, as costs happened
/// to be measured.
constexpr double most_share = .05;

/// Costs kept of a rung.
constexpr std::size_t most_costs = 512;

}  // namespace

RungClimb::RungClimb(const Ladder& ladder, std::size_t pixels, std::size_t first_samples)
    : standing_samples_(std::max(
          first_samples, static_cast<std::size_t>(standing_share * static_cast<double>(pixels)))) {
    for (const Ladder::Step& step : ladder.rungs) {
        steps_.emplace_back();
        steps_.back().name = step.name;
        steps_.back().ready = step.ready;
    }
}

std::size_t RungClimb::place(Rung rung) const {
    return std::min<std::size_t>(rung, steps_.size() - 1);
}

Rung RungClimb::rung(std::size_t place) const {
    return place + 1 == steps_.size() ? target_rung : static_cast<Rung>(place);
}

void RungClimb::learn(const Sample& sample) {
    Step& step = steps_[place(sample.rung)];
    ++step.samples;
    if (!has_rungs() || step.costs.size() == most_costs) return;
    step.costs.push_back(sample.cost_ns);
    // Many are not looked through for each that comes.
    if (step.costs.size() <= 2 * trials || std::has_single_bit(step.costs.size()))
        step.usual_cost = usual_cost(step.costs);
}

void RungClimb::compare(Rung lower, const glm::vec3& low, const glm::vec3& high) {
    Step& step = steps_[place(lower)];
    const glm::vec3 d = display_encoded(low) - display_encoded(high);
    step.difference += (std::abs(d.x) + std::abs(d.y) + std::abs(d.z)) / 3;
    ++step.compared;
}

std::size_t RungClimb::next_place() const {
    std::size_t next = steps_.size() - 1;
    while (next > current_ && !steps_[next].ready) --next;
    return next;
}

bool RungClimb::take_trial(bool early) {
    Step& next = steps_[next_place()];
    const bool few = early && (next.costs.size() < early_trials || seems_dear());
    if (next_place() == current_ || next.trials >= (few ? early_trials : trials)) return false;
    ++next.trials;
    return true;
}

bool RungClimb::seems_dear() const {
    const Step& next = steps_[next_place()];
    return next.costs.size() >= early_trials && gains(steps_[current_], next);
}

bool RungClimb::undecided() const {
    const Step& next = steps_[next_place()];
    if (next_place() == current_ || next.costs.size() >= trials) return false;
    return next.costs.size() < early_trials || seems_dear() ||
           std::ranges::max(next.costs) >= cheap_ns;
}

bool RungClimb::gains(const Step& step, const Step& next) const {
    return next.usual_cost >= least_gain * step.usual_cost &&
           next.usual_cost * static_cast<double>(standing_samples_) > moment_ns;
}

bool RungClimb::climb(bool at_rest) {
    const std::size_t next = next_place();
    Step& step = steps_[current_];
    if (next == current_ || (undecided() && !at_rest)) return false;
    const bool gained = undecided() || gains(step, steps_[next]);
    const double spent = static_cast<double>(step.samples) * step.usual_cost,
                 coming = static_cast<double>(standing_samples_) * steps_[next].usual_cost;
    const bool stands = step.samples >= standing_samples_ || spent > most_share * coming;
    if (gained && !stands && !at_rest) return false;
    step.dropped = !gained && step.samples < standing_samples_;
    current_ = next;
    return true;
}

double RungClimb::cost_ns(Rung rung) const { return steps_[place(rung)].usual_cost; }

std::vector<RungStanding> RungClimb::standings() const {
    std::vector<RungStanding> standings;
    for (const Step& step : steps_)
        standings.push_back({step.name, step.samples, step.usual_cost,
                             step.compared > 0 ? step.difference / double(step.compared) : -1,
                             step.dropped});
    return standings;
}

}  // namespace povpreview
