// SPDX-License-Identifier: AGPL-3.0-or-later
//
// The mesh previewer's dealings with the sides of constraints: the one-sided samples beside their
// vertices, and where constraints are split.
#include <glm/geometric.hpp>

#include "core/mesh_previewer.h"
#include "core/predicates.h"

namespace povpreview {

namespace {

/// How much farther off a one-sided sample is tried again that met another surface than its side's.
constexpr double second_try = 2.5;

/// Length of the edge that weighs as much as a missing side, for a square pixel of its faces: best
/// of .6 to 1.3 on images of cards.
constexpr double side_length = .8;
/// The same, where neighbours on this side are known: blank areas are better searched by vertices.
constexpr double explored_side_length = .4;

}  // namespace

/// The heaviest of a vertex's sides that have no sample. A side without one borrows from its
/// neighbours, so it weighs what an edge does in the midst of as much area; somewhat less, since no
/// pixel is done with its sample.
std::optional<MeshPreviewer::WeighedSide> MeshPreviewer::heaviest_side(VertexId vertex) const {
    thread_local std::vector<Mesh::MissingSide> missing;
    mesh_.missing_sides(vertex, missing);
    std::optional<WeighedSide> heaviest;
    for (const Mesh::MissingSide& side : missing) {
        const double length = (side.spread ? explored_side_length : side_length) *
                              std::sqrt(side.area) / std::max(width_, height_);
        const float distance = std::min(side.spread.value_or(Mesh::unknown_distance), 1.f);
        const float w = edge_weight(options_.weight, static_cast<float>(length), distance);
        if (!heaviest || w > heaviest->weight) heaviest = {side.side, w};
    }
    return heaviest;
}

/// Asks for a side's sample, unless the side is too thin for one.
std::optional<Request> MeshPreviewer::ask_side(VertexId vertex, std::size_t side,
                                               std::uint32_t surface) {
    const auto sample = mesh_.promise_side(vertex, side);
    if (!sample) return std::nullopt;
    Pending pending{Pending::Use::side};
    pending.vertex = vertex;
    pending.sample = *sample;
    pending.surface = surface;
    return request(pending);
}

/// The surface on one side of a constraint, where the samples at both of its ends agree.
std::uint32_t MeshPreviewer::surface_beside(VertexId a, VertexId b, bool left) const {
    const SampleId p = mesh_.corner(a, b, left), q = mesh_.corner(b, a, !left);
    if (!p.valid() || !q.valid()) return Pending::any;
    const VertexSample &s = mesh_.sample(p), &t = mesh_.sample(q);
    const bool known = s.state == VertexSample::State::known && t.state == s.state;
    return known && s.surface == t.surface ? s.surface : Pending::any;
}

/// Splits a constraint in its middle and asks for the sample on the new vertex's heavier side; the
/// other one waits until it is heavy itself.
std::optional<Request> MeshPreviewer::split_constraint(VertexId a, VertexId b) {
    const Triangulation& t = mesh_.triangulation();
    const std::uint32_t left = surface_beside(a, b, true), right = surface_beside(a, b, false);
    const std::size_t vertices_before = t.vertex_ids();
    const auto split = mesh_.split(a, b, (t.position(a) + t.position(b)) / 2.);
    const std::vector<VertexId> touched(t.touched().begin(), t.touched().end());
    std::optional<Request> wanted;
    const auto side = split.fresh ? heaviest_side(split.vertex) : std::nullopt;
    if (side) {
        const bool on_left = mesh_.side_at(split.vertex, b, true) == side->side;
        wanted = ask_side(split.vertex, side->side, on_left ? left : right);
    }
    if (split.fresh)
        queue_changed(touched, vertices_before);
    else  // an old vertex stood in the way: a-b may be as it was, and would be split for ever
        for (VertexId v : touched) queue_edges(v, v == a ? b : v == b ? a : VertexId{});
    return wanted;
}

/// A one-sided sample that met another surface than its side's is tried once more farther off, and
/// then not believed: its corners take their colour from this side's neighbours.
void MeshPreviewer::accept_side(Pending side, const Sample& sample, bool usable) {
    --vertices_pending_;
    // Where no outlines are traced, surfaces are not asked for any more.
    const bool told = contains(parts(), Parts::surface);
    const bool strange = told && side.surface != Pending::any && sample.surface != side.surface;
    if (usable && strange && !side.retried) {
        const glm::dvec2 v = mesh_.triangulation().position(side.vertex);
        const glm::dvec2 farther = v + second_try * (mesh_.sample(side.sample).position - v);
        if (farther.x >= 0 && farther.y >= 0 && farther.x <= width_ && farther.y <= height_) {
            mesh_.move(side.sample, farther);
            side.retried = true;
            retries_.push_back(side);
            return;
        }
    }
    if (usable && !strange) {
        mesh_.answer(side.sample, sample, item_seen(sample), shaded(sample));
        if (LowSample* low = keep_low(sample, usable, std::nullopt))
            low->show_at(side.sample, side.vertex);
    } else {
        mesh_.fail(side.sample);
    }
    queue_around(side.vertex);
}

}  // namespace povpreview
