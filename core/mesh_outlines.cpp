// SPDX-License-Identifier: AGPL-3.0-or-later
//
// The mesh previewer's dealings with outlines: when one is traced, what becomes of it in the mesh,
// and the one-sided samples beside it.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/chain_insertion.h"
#include "core/mesh_previewer.h"
#include "core/predicates.h"

namespace povpreview {

namespace {

/// How much farther off a one-sided sample is tried again that met another surface than its side's.
constexpr double second_try = 2.5;

Sample as_seed(const VertexSample& vertex) {
    Sample sample;
    sample.position = vertex.position;
    sample.surface = vertex.surface;
    return sample;
}

}  // namespace

/// Has the outline traced that a heavy edge crosses, if that is worth it. The edge is refined all
/// the same: an outline is long in coming, since each of its probes waits for the one before.
void MeshPreviewer::consider_outline(VertexId a, VertexId b) {
    if (!options_.constraints || !plan_.outlines || outlines_overdrawn()) return;
    if (double(squares_.requested()) > options_.outline_until * double(squares_.pixels())) return;
    const SampleId s = mesh_.corner(a, b, true), t = mesh_.corner(b, a, false);
    if (!s.valid() || !t.valid()) return;
    const VertexSample &p = mesh_.sample(s), &q = mesh_.sample(t);
    if (p.state != VertexSample::State::known || q.state != VertexSample::State::known ||
        p.surface == q.surface)
        return;
    const float jump = std::sqrt(colour_distance(p.encoded, q.encoded));
    if (jump < options_.outline_jump ||
        jump * glm::distance(p.position, q.position) < options_.outline_weight)
        return;
    search_.consider(as_seed(p), as_seed(q));
}

/// Whether outlines have used up the rays they are allowed.
bool MeshPreviewer::outlines_overdrawn() const {
    const double pixels = static_cast<double>(squares_.pixels());
    const double full = static_cast<double>(squares_.requested());
    return static_cast<double>(outline_rays_) >=
           options_.outline_floor * pixels + options_.outline_share * full;
}

/// Begins a round of outlines when there are enough, or the first one has waited for long enough.
void MeshPreviewer::start_outlines() {
    constexpr std::size_t patience = 64;  // full samples
    if (search_.active() > 0 || search_.waiting() == 0 || outlines_overdrawn()) {
        if (search_.waiting() == 0) waiting_since_ = squares_.requested();
        return;
    }
    if (search_.waiting() == OutlineSearch::round ||
        squares_.requested() >= waiting_since_ + patience)
        search_.start();
}

std::optional<Request> MeshPreviewer::next_probe() {
    const auto probe = search_.next();
    if (!probe) return std::nullopt;
    ++outline_rays_;
    Pending pending{Pending::Use::probe};
    pending.surface = probe->tracer;
    pending_.push_back(pending);
    return Request{probe->position, RayKind::probe};
}

void MeshPreviewer::take_outlines() {
    while (auto outline = search_.take_finished()) insert(*outline);
}

/// Inserts a traced outline and asks for the samples beside it.
void MeshPreviewer::insert(const Outline& outline) {
    ChainInsertion insertion = begin_insertion();
    std::vector<glm::dvec2> chain = outline.vertices;
    if (outline.closed && !chain.empty()) chain.push_back(chain.front());
    insertion.insert(chain, {EdgeKind::traced, 0});
    const std::size_t before = sides_.size();
    finish_insertion(insertion);
    outline_rays_ += sides_.size() - before;
}

/// Asks for a sample in each sector around a vertex that has none.
void MeshPreviewer::promise_sides(VertexId vertex) {
    std::vector<glm::dvec2> positions;
    mesh_.missing_positions(vertex, positions);
    for (glm::dvec2 p : positions) {
        Pending side{Pending::Use::side};
        side.vertex = vertex;
        side.sample = mesh_.promise(vertex, p);
        sides_.push_back(side);
    }
}

/// The surface on one side of a constraint, where the samples at both of its ends agree.
std::uint32_t MeshPreviewer::surface_beside(VertexId a, VertexId b, bool left) const {
    const SampleId p = mesh_.corner(a, b, left), q = mesh_.corner(b, a, !left);
    if (!p.valid() || !q.valid()) return Pending::any;
    const VertexSample &s = mesh_.sample(p), &t = mesh_.sample(q);
    const bool known = s.state == VertexSample::State::known && t.state == s.state;
    return known && s.surface == t.surface ? s.surface : Pending::any;
}

/// Splits at once and asks for the samples beside the new vertex; until they come its corners
/// stand in between their neighbours'.
std::optional<Request> MeshPreviewer::split_constraint(VertexId a, VertexId b) {
    const Triangulation& t = mesh_.triangulation();
    const std::uint32_t left = surface_beside(a, b, true), right = surface_beside(a, b, false);
    const auto split = mesh_.split(a, b, (t.position(a) + t.position(b)) / 2.);
    const std::vector<VertexId> touched(t.touched().begin(), t.touched().end());
    const std::size_t before = sides_.size();
    if (split.fresh) promise_sides(split.vertex);
    for (std::size_t i = before; i < sides_.size(); ++i) {
        const glm::dvec2 p = mesh_.sample(sides_[i].sample).position;
        sides_[i].surface = orientation(t.position(a), t.position(b), p) > 0 ? left : right;
    }
    // Where an old vertex stood in the way, a-b may be as it was: to queue it again would never
    // end.
    for (VertexId v : touched) queue_edges(v, v == a ? b : v == b ? a : VertexId{});
    if (sides_.empty()) return std::nullopt;
    const Pending side = sides_.front();
    sides_.pop_front();
    return request(side);
}

/// A one-sided sample that met another surface than its side's is tried once more farther off, and
/// then not believed: its corners take their colour from this side's neighbours.
void MeshPreviewer::accept_side(Pending side, const Sample& sample, bool usable) {
    --vertices_pending_;
    const bool strange = side.surface != Pending::any && sample.surface != side.surface;
    if (usable && strange && !side.retried) {
        const glm::dvec2 v = mesh_.triangulation().position(side.vertex);
        const glm::dvec2 farther = v + second_try * (mesh_.sample(side.sample).position - v);
        if (farther.x >= 0 && farther.y >= 0 && farther.x <= width_ && farther.y <= height_) {
            mesh_.move(side.sample, farther);
            side.retried = true;
            sides_.push_back(side);
            return;
        }
    }
    if (usable && !strange)
        mesh_.answer(side.sample, sample.colour, sample.surface);
    else
        mesh_.fail(side.sample);
    queue_edges(side.vertex);
}

}  // namespace povpreview
