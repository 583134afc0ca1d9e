// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "core/outline_run.h"
#include "core/outline_tracer.h"
#include "core/probe_routine.h"

namespace povpreview {

/// What a failed probe shows; no surface has this number.
inline constexpr std::int64_t nothing_known = -1;
enum class Side { left, right };

/// Result of looking for the outline along a line across it.
struct Crossing {
    std::optional<glm::dvec2> at;  ///< within position_error
    Side unexpected = Side::left;  ///< else: the side that did not show its surface
};

/// Result of following a straight strip along the outline to where it goes wrong.
struct Departure {
    enum class Kind { crossing, junction, none } kind;
    glm::dvec2 at;  ///< none: the outline stays in the strip up to here
};

/// Result of looking all around.
struct Turn {
    std::optional<glm::dvec2> at;
    bool third = false;  ///< a third surface was met
};

/// The coroutines of outline tracing: the strategy (outline_tracer.cpp) over three ways to find the
/// outline by probes (outline_probing.cpp).
class OutlineTracer::Walk {
   public:
    Walk(const Sample& a, const Sample& b, glm::ivec2 image_size, const OutlineOptions& options);
    std::optional<glm::dvec2> next();
    void accept(const Sample& probe);
    bool done() const { return finished_; }
    const Outline& outline() const { return outline_; }

   private:
    std::int64_t identity(const Sample& s) const {
        return s.failed ? nothing_known : std::int64_t{options_.identity(s)};
    }
    auto ask(glm::dvec2 p) { return channel_.ask(p); }
    bool inside(glm::dvec2 p) const {
        return p.x >= 0 && p.y >= 0 && p.x <= size_.x && p.y <= size_.y;
    }

    void settle();
    Routine<bool> trace(Sample a, Sample b);
    Routine<bool> follow(OutlineRun& run, double step);
    Routine<bool> refine(OutlineRun& run, std::optional<Circle> arc, glm::dvec2 b, double limit);
    Routine<double> resume(OutlineRun& run, double covered);
    Routine<bool> around_corner(OutlineRun& run, double radius);
    Routine<Crossing> cross(const OutlineRun& run, glm::dvec2 at, glm::dvec2 normal, double width,
                            double limit);
    Routine<Departure> leave(const OutlineRun& run, glm::dvec2 along, double far, Side side);
    Routine<Turn> turn(const OutlineRun& run, double half_angle, double radius);

    OutlineOptions options_;
    glm::dvec2 size_;
    std::optional<OutlineRun> ahead_, behind_;
    Channel<glm::dvec2, std::int64_t> channel_;
    bool outstanding_ = false, finished_ = false;
    Outline outline_;
    Routine<bool> trace_;  // last: its frames refer to the members above
};

}  // namespace povpreview
