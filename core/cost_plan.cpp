// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/cost_plan.h"

#include <algorithm>
#include <numeric>

namespace povpreview {
namespace {

/// The constants below hold where so many of the tracer's threads work beside one of ours. More of
/// them make samples that cost the same come sooner, and our own work tell more.
constexpr double measured_threads = 2;

/// A picture that takes the tracer less than this altogether is there in a moment.
constexpr double moment_ns = 6e9;

/// Below this, edges come later than the samples that do as well (office, town, chair: until an
/// error of .01 at least).
constexpr double edges_ns = 1.5e9;

/// What a vertex costs us: finding its place, the triangles around it, weights, the heap.
constexpr double vertex_ns = 5e3;

/// What an albedo ray costs us: choosing its pixel, what is known of it, the wire.
constexpr double albedo_own_ns = 2e3;

/// Samples cheaper than this go into a lattice: it needs as many to the same error as a
/// triangulation, and next to no time of our own, but has no use for edges known beforehand, nor
/// for albedo rays. At 1920x1080 it is ahead by 1.5 to 4 times in time where they cost 26 and 31 us
/// (drums, fractalzoom), behind by 2 where they cost 60 (abyss). The first samples, which tell,
/// cost up to twice what later ones do.
constexpr double lattice_ns = 40e3;

/// Past a vertex to every sixth pixel, it costs more time than it saves over tracing the pixels
/// around it, whatever they cost; less than one to every 24 leaves too coarse a mesh.
constexpr double most_vertices = 1. / 6, least_vertices = 1. / 24;

/// Vertices may take this share of the time that all samples take.
constexpr double own_share = .05;

}  // namespace

CostPlan plan_by_cost(double sample_ns, std::size_t pixels, int threads) {
    if (sample_ns <= 0) return {0, false, true, true, most_vertices};
    const double as_measured_ns = sample_ns * measured_threads / threads;
    CostPlan plan{sample_ns, as_measured_ns < lattice_ns, false, false, most_vertices};
    plan.outlines = as_measured_ns * double(pixels) > moment_ns;
    plan.edges = as_measured_ns * double(pixels) > edges_ns;
    const double affordable = own_share * as_measured_ns / vertex_ns;
    while (plan.vertex_budget > affordable && plan.vertex_budget > least_vertices)
        plan.vertex_budget /= 2;
    return plan;
}

double albedo_price(double albedo_ns, double full_ns, int threads) {
    if (albedo_ns <= 0 || full_ns <= 0) return 1;
    return (albedo_ns + albedo_own_ns * threads / measured_threads) / full_ns;
}

double usual_cost(std::vector<std::uint32_t> costs) {
    constexpr double left_out = .02;
    if (costs.empty()) return 0;
    // Rounded down: of few, one is left out as well.
    const std::size_t kept =
        std::max<std::size_t>(1, static_cast<std::size_t>((1 - left_out) * double(costs.size())));
    std::nth_element(costs.begin(), costs.begin() + std::ptrdiff_t(kept) - 1, costs.end());
    costs.resize(kept);
    return std::accumulate(costs.begin(), costs.end(), 0.) / double(costs.size());
}

}  // namespace povpreview
