// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cmath>
#include <optional>

namespace povpreview {

/// Moments that lie ever farther apart, so that a picture which improves ever more slowly is looked
/// at about equally often for each step it makes. Seconds since the parse.
class GeometricSchedule {
   public:
    /// The number of the latest moment that has come since the last call, if one has.
    std::optional<int> due(double time_s) {
        std::optional<int> moment;
        while (next_ <= time_s) {
            next_ *= step;
            moment = count_++;
        }
        return moment;
    }
    /// When a moment is, in seconds.
    static double time(int moment) { return first * std::pow(step, moment); }

   private:
    static constexpr double first = .004, step = 1.5;
    double next_ = first;
    int count_ = 0;
};

}  // namespace povpreview
