// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "core/ladder.h"
#include "core/oracle.h"

namespace povpreview {

/// How one rung of the ladder has done, for the log.
struct RungStanding {
    std::string name;
    std::size_t samples = 0;  ///< traced at it
    double cost_ns = 0;       ///< of one of them, usually; 0 where it is not known
    /// Mean difference of displayed colour to the next rung that was traced at the same positions;
    /// below 0 where there were none.
    double error = -1;
    bool dropped = false;  ///< left before the picture stood on it, since it gains nothing
};

/// Where on the ladder of accuracy a previewer stands: it starts on the lowest rung and goes to the
/// highest one that is ready, as soon as its picture stands on the lower one or that has taken a
/// small part of what is to come, or at once where the lower one gains nothing. A few positions are
/// traced at both to learn what they cost.
class RungClimb {
   public:
    /// `first_samples`: those that any picture begins with.
    RungClimb(const Ladder& ladder, std::size_t pixels, std::size_t first_samples);

    bool has_rungs() const { return steps_.size() > 1; }
    /// What new samples are asked for.
    Rung current() const { return rung(current_); }
    bool at_target() const { return current_ + 1 == steps_.size(); }
    /// The rungs' places on the ladder, from 0.
    std::size_t place(Rung rung) const;
    Rung rung(std::size_t place) const;

    /// The tracer has prepared a rung.
    void ready(Rung rung) { steps_[place(rung)].ready = true; }
    /// A full sample has come.
    void learn(const Sample& sample);
    /// A position was traced at two rungs, to these colours, linear.
    void compare(Rung lower, const glm::vec3& low, const glm::vec3& high);

    /// A rung higher than the current one is ready, but what it costs is not known: some positions
    /// should be traced at it. Each call with the answer true counts as one of them. `early`: the
    /// first picture is not there yet, and shall not wait for dear ones.
    bool take_trial(bool early);
    /// As far as that is known by the first of those positions.
    bool seems_dear() const;
    /// A higher rung is ready, and too little is known of what it costs.
    bool undecided() const;
    /// The highest rung that is ready and above the current one; that where there is none.
    Rung next() const { return rung(next_place()); }
    /// Goes to the next rung if it is time to; `at_rest`: there is nothing else to do. Returns
    /// whether it went.
    bool climb(bool at_rest = false);

    /// What a sample of a rung usually costs, in nanoseconds; 0 where it is not known.
    double cost_ns(Rung rung) const;
    std::vector<RungStanding> standings() const;

   private:
    struct Step {
        std::string name;
        std::size_t samples = 0, trials = 0, compared = 0;
        double difference = 0;             ///< summed over what was compared
        std::vector<std::uint32_t> costs;  ///< of the first, in nanoseconds
        double usual_cost = 0;
        bool ready = true, dropped = false;
    };
    std::size_t next_place() const;
    bool gains(const Step& step, const Step& next) const;

    std::vector<Step> steps_;
    std::size_t current_ = 0;
    std::size_t standing_samples_;
};

}  // namespace povpreview
