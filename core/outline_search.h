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
    /// Outlines are traced in rounds of so many. Each tracer has one probe under way, which waits
    /// for the one before; together they keep a ray tracer busy.
    static constexpr std::size_t round = 8;
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

    /// Considers an edge whose ends lie on different surfaces for the next round; takes it if there
    /// is room and no other edge between these surfaces is in it.
    void consider(const Sample& a, const Sample& b);
    /// Edges taken for the next round.
    std::size_t waiting() const { return waiting_.size(); }
    /// Begins the next round. REQUIRES: no round is under way.
    void start() { order_.swap(waiting_); }

    struct Probe {
        std::uint32_t tracer;
        glm::dvec2 position;
    };
    /// The next probe wanted; tracers take turns.
    std::optional<Probe> next();
    /// The answer to a probe, in the order of the requests.
    void accept(std::uint32_t tracer, const Sample& sample);

    /// Outlines being traced now.
    std::size_t active() const { return order_.size(); }

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
    std::deque<std::uint32_t> order_;    // at work: whose turn it is
    std::deque<std::uint32_t> waiting_;  // for the next round
    std::uint32_t launched_ = 0;
    std::map<SurfacePair, bool> at_work_;
    std::map<SurfacePair, int> tries_;
    std::deque<Outline> finished_;
};

}  // namespace povpreview
