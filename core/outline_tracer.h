// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "core/oracle.h"

namespace povpreview {

/// Tolerances of outline tracing; lengths in pixels.
struct OutlineOptions {
    /// Greatest distance of a located point from the outline. A vertex of the triangulation takes
    /// one-sided samples a few tenths of a pixel off the outline; they must be on their own side.
    double position_error = .1;
    /// Greatest distance between the simplified polyline and the located points; at most .5. Half a
    /// pixel is what the eye sees in a picture of whole pixels.
    double flatness = .25;
    /// Where a third surface meets the outline, its end is located along the outline this well.
    double junction_error = .25;
    /// Distance of the first point sought beside the seed: long enough to give a direction, short
    /// enough to stay on a small surface.
    double first_step = 2;
    /// Steps grow up to this. The outline is checked at both ends and in the middle of a step, so a
    /// detour from a straight run that is narrower than half of it may be missed. At 128, a
    /// straight edge of 300 pixels takes 46 probes; at 64 it takes 56, and gaps of 60 pixels
    /// between two outlines on one line are no longer jumped.
    double longest_step = 64;
    /// Points on an outline that turns faster than this radius are not promised: the least radius
    /// of the circle searched around a corner.
    double smallest_feature = .25;
    /// Bounds the work; tracing ends where it stands.
    int most_probes = 2000;
    /// What tells the two sides apart; the first surface unless said otherwise.
    std::uint32_t (*identity)(const Sample&) = [](const Sample& s) { return s.surface; };
};

/// Why an outline ends where it does.
enum class OutlineEnd {
    closed,    ///< it came back to its beginning (both ends say so)
    border,    ///< it leaves the image; clipped exactly to the border
    junction,  ///< a third surface meets it there (or a probe failed there)
    lost       ///< it could not be followed: too thin, too rough, or the budget was spent
};

/// The visible border between two surfaces, as a polyline in pixel coordinates.
///
///          left
///     v0 ───────── v1          Left and right are as seen on the screen by one who walks from
///          right     \         the first vertex to the last (y points down).
///                     v2
struct Outline {
    std::vector<glm::dvec2> vertices;  ///< none, or at least two; closed: the first is not repeated
    std::uint32_t left = 0, right = 0;  ///< identities of the two surfaces
    bool closed = false;
    OutlineEnd begin = OutlineEnd::lost, end = OutlineEnd::lost;
    int probes = 0;  ///< requests made for it
};

/// Follows the outline between two surfaces by probes: bisects the seed, then walks along the
/// outline both ways by predictor and corrector, guessing a straight run or a circular arc, and
/// bracketing the outline across the guess at the end and the middle of every step. Steps grow
/// while the guesses hold and shrink where one fails, down to the outline's true end.
///
/// A resumable state machine: ask `next()` for a probe, give the answer to `accept()`. It has one
/// probe outstanding at most; run many tracers side by side to fill a batch. Always ends, whatever
/// the answers are (after `most_probes` at the latest).
///
/// No point of the polyline is farther than position_error + flatness from an outline that is
/// smooth between corners and keeps clear of itself by a pixel or so.
class OutlineTracer {
   public:
    /// The outline lies between two samples with different identities. Where a third surface lies
    /// between them, the outline followed is the one between the first sample's surface and its
    /// neighbour. A seed that is no bracket (equal identities, failed samples, positions that are
    /// not finite) gives an empty outline and asks for nothing.
    OutlineTracer(const Sample& a, const Sample& b, glm::ivec2 image_size,
                  const OutlineOptions& options = {});
    ~OutlineTracer();
    OutlineTracer(OutlineTracer&&) noexcept;
    OutlineTracer& operator=(OutlineTracer&&) noexcept;

    /// Position of the next probe wanted; nothing while an answer is outstanding or when done. It
    /// may lie a little outside the image.
    std::optional<glm::dvec2> next();
    /// The answer to the probe asked for last. REQUIRES: one is outstanding.
    void accept(const Sample& probe);
    bool done() const;

    /// The outline. REQUIRES: done().
    const Outline& outline() const;

   private:
    class Walk;
    std::unique_ptr<Walk> walk_;
};

}  // namespace povpreview
