// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "core/outline_tracer.h"
#include "core/polyline.h"

namespace povpreview {

/// To the left, as seen on the screen (y down), of one who walks along `d`.
inline glm::dvec2 left_of(glm::dvec2 d) { return {d.y, -d.x}; }

/// One walk along an outline away from its seed: the vertices so far and the guess of what comes
/// next. Knows no probes.
class OutlineRun {
   public:
    /// Where the outline should be `step` pixels on.
    struct Guess {
        glm::dvec2 at;
        glm::dvec2 left;     ///< unit normal of the outline there
        glm::dvec2 tangent;  ///< unit tangent at the last vertex
        double uncertainty;  ///< typical error of `at` across the outline, pixels
        double bend;         ///< pixels by which a bend too slight to have been seen may lead off
        double reach;        ///< `step`, less where the guess would be worth nothing, pixels
    };

    /// Identities to the left and right of its direction.
    std::int64_t left, right;

    OutlineRun(glm::dvec2 start, glm::dvec2 direction, std::int64_t left_id, std::int64_t right_id,
               glm::dvec2 size, const OutlineOptions& options);

    /// The walk from the same start the other way; what was learnt of the curve before its first
    /// corner serves as its past.
    OutlineRun reversed() const;

    glm::dvec2 last() const { return vertices_.back(); }
    /// REQUIRES: two vertices.
    glm::dvec2 before_last() const { return vertices_[vertices_.size() - 2]; }
    /// Unit tangent at the last vertex, as far as is known.
    glm::dvec2 direction() const { return direction_; }
    /// Pixels from the last vertex straight on to the image's border.
    double distance_to_border() const;
    Guess guess(double step) const;
    /// The circle along which the outline seems to run from the last vertex to `b`, if it bends.
    std::optional<Circle> arc_to(glm::dvec2 b) const;
    /// Length over which the curve is known to be smooth up to the last vertex.
    double smooth_length() const;

    /// Appends a located point; clips and ends the run where it lies outside the image, ends it
    /// where it comes back to its start.
    void append(glm::dvec2 located);
    /// Appends the arc over `mid` to `b`, both located, with a vertex wherever it bends.
    void append_arc(glm::dvec2 mid, glm::dvec2 b);
    /// The past tells nothing of what follows the last vertex, except its direction.
    void corner(glm::dvec2 direction);
    void finish(OutlineEnd end) {
        if (!end_) end_ = end;
    }

    std::optional<OutlineEnd> end() const { return end_; }
    const Polyline& vertices() const { return vertices_; }

   private:
    void append_vertex(glm::dvec2 p);
    /// Two located points behind the last one, the farther at most `span` away, for extrapolation.
    std::optional<std::pair<glm::dvec2, glm::dvec2>> past(double span) const;

    glm::dvec2 size_;
    OutlineOptions options_;
    Polyline vertices_;           ///< the polyline so far
    Polyline smooth_;             ///< located points since the last corner, oldest first
    Polyline first_smooth_;       ///< located points up to the first corner
    bool turned_ = false;         ///< a corner was met
    glm::dvec2 direction_;        ///< unit
    glm::dvec2 first_direction_;  ///< unit, at the start
    double travelled_ = 0;        ///< pixels
    std::optional<OutlineEnd> end_;
};

}  // namespace povpreview
