// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <vector>

#include "core/oracle.h"
#include "core/outline_tracer.h"

namespace povpreview {

/// Two surfaces, the smaller identity first.
using SurfacePair = std::pair<std::uint32_t, std::uint32_t>;
inline SurfacePair surface_pair(std::uint32_t a, std::uint32_t b) {
    return a < b ? SurfacePair{a, b} : SurfacePair{b, a};
}

/// Runs outline tracers side by side, one for each pair of surfaces at a time: what one of them
/// finds may answer the question of the others.
class OutlineSearch {
   public:
    /// Tracers at work at a time. Each has one probe under way, so they fill a batch together.
    static constexpr std::size_t most_active = 32;
    /// Outlines traced for one pair of surfaces. What is left then is refined without constraints,
    /// as are pairs whose outline got lost: there is no end to the pieces of hair or leaves.
    static constexpr int most_per_pair = 6;

    /// Probes for one outline. A straight edge or a large circle takes fewer; what takes more is
    /// rough, and its samples are better spent on refinement.
    static constexpr int most_probes = 200;
    /// Outlines shorter than this, in pixels, are the pieces of finely faceted surfaces: none more
    /// is traced for their pair.
    static constexpr double short_outline = 12;

    explicit OutlineSearch(glm::ivec2 image_size) : image_size_(image_size) {
        options_.most_probes = most_probes;
    }

    /// Considers an edge whose ends lie on different surfaces; launches a tracer if it is worth
    /// one, one is free and none is at work on this pair.
    void consider(const Sample& a, const Sample& b);

    struct Probe {
        std::uint32_t tracer;
        glm::dvec2 position;
    };
    /// The next probe wanted; tracers take turns.
    std::optional<Probe> next();
    /// The answer to a probe, in the order of the requests.
    void accept(std::uint32_t tracer, const Sample& sample);

    bool active() const { return !order_.empty(); }
    std::size_t outstanding() const { return outstanding_; }

    /// The next outline that is complete, in the order of completion.
    std::optional<Outline> take_finished();

   private:
    struct Job {
        SurfacePair pair;
        OutlineTracer tracer;
    };
    void retire(std::uint32_t number);

    glm::ivec2 image_size_;
    OutlineOptions options_;
    std::map<std::uint32_t, Job> jobs_;  // by number
    std::deque<std::uint32_t> order_;    // whose turn it is
    std::uint32_t launched_ = 0;
    std::size_t outstanding_ = 0;
    std::map<SurfacePair, bool> at_work_;
    std::map<SurfacePair, int> tries_;
    std::deque<Outline> finished_;
};

}  // namespace povpreview
