// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <mutex>

#include "backend/oracle/samples.h"

namespace povpreview::tracer {

/// The mean of all light that radiosity has gathered so far for what the eye sees: a guess where
/// nothing nearer is known. Any thread may add to it or read it.
class GatheredLight {
   public:
    void add(float red, float green, float blue) {
        const std::lock_guard lock(mutex_);
        sum_ = {sum_.r + red, sum_.g + green, sum_.b + blue};
        ++count_;
    }
    /// Black if there is none yet.
    Rgb mean() {
        const std::lock_guard lock(mutex_);
        const auto share = [this](float sum) {
            return count_ > 0 ? sum / static_cast<float>(count_) : 0;
        };
        return {share(sum_.r), share(sum_.g), share(sum_.b)};
    }

   private:
    std::mutex mutex_;
    Rgb sum_;
    std::size_t count_ = 0;
};

inline GatheredLight& gathered_light() {
    static GatheredLight light;
    return light;
}

}  // namespace povpreview::tracer
