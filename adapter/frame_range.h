// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "adapter/povray_words.h"

namespace povpreview {

/// The frames of an animation, as POV-Ray's options say them (its AnimationProcessing). Which clock
/// a frame has is left to POV-Ray.
class FrameRange {
   public:
    /// Takes a setting that concerns frames; others are passed over. Throws Error(Exit::usage)
    /// where a number is none.
    void take(const PovrayWord& word);

    /// Whether POV-Ray makes an animation of this. It does not where both ends are 1, or neither
    /// was given or both are 0.
    bool animated() const;
    /// The numbers of the frames to be rendered, or nothing where this is no animation. Throws
    /// Error(Exit::usage) where the options leave no frame (POV-Ray renders one all the same, at
    /// a clock that is not a number), or more than a million.
    std::vector<int> frames() const;
    /// Digits that POV-Ray writes a frame's number with in file names.
    int digits() const;

   private:
    int last() const;

    std::optional<int> initial_, final_;
    std::optional<double> subset_start_, subset_end_;  ///< a number, or a share below 1
    int step_ = 1;
    bool cyclic_ = false;
};

}  // namespace povpreview
