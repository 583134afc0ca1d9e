// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace povpreview {

/// How much work of our own a scene's samples deserve, by what they cost to trace.
struct CostPlan {
    /// What a sample costs the tracer, in nanoseconds of one thread; 0: not known.
    double sample_ns;
    /// No triangulation at all: samples are so cheap that the work on it tells (AdaptiveLattice).
    bool lattice;
    /// Trace outlines and keep them as constraints. Each probe waits for the one before it, so a
    /// scene that is complete in a moment is complete before its outlines are known.
    bool outlines;
    /// Have edges found that can be known without tracing, and keep them as constraints, though the
    /// borders of all items are known: what is left are shadows and reflections.
    bool edges;
    /// Vertices at most, as a share of the pixels; then the rest is filled.
    double vertex_budget;

    /// What all pixels cost.
    double all_ns(std::size_t pixels) const { return sample_ns * static_cast<double>(pixels); }
};

/// `sample_ns`: what a sample costs the tracer on average, in nanoseconds of one of its `threads`;
/// 0 where it is not known. The answer changes in few steps, so that two runs seldom differ.
CostPlan plan_by_cost(double sample_ns, std::size_t pixels, int threads);

/// What an albedo ray costs, the tracer and us, against a full sample; 1 where either is not known
/// (0).
double albedo_price(double albedo_ns, double full_ns, int threads);

/// The mean of costs in nanoseconds, without those few during which the tracer's thread was put
/// aside for another program; 0 of none.
double usual_cost(std::vector<std::uint32_t> costs);

}  // namespace povpreview
