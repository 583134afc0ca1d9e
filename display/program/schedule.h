// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

namespace povpreview {

/// Moments that lie ever farther apart, so that a picture which improves ever more slowly is looked
/// at about equally often for each step it makes. Seconds since the parse.
class GeometricSchedule {
   public:
    /// Whether a moment has come since the last one that was noticed.
    bool due(double time_s) {
        if (time_s < next_) return false;
        while (next_ <= time_s) next_ *= step;
        return true;
    }

   private:
    static constexpr double first = .02, step = 1.5;
    double next_ = first;
};

}  // namespace povpreview
