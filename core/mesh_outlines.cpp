// SPDX-License-Identifier: AGPL-3.0-or-later
//
// The mesh previewer's dealings with outlines: when one is traced, what becomes of it in the mesh,
// and the one-sided samples beside it.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/chain_insertion.h"
#include "core/mesh_previewer.h"

namespace povpreview {

namespace {

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

void MeshPreviewer::insert(const Outline& outline) {
    ChainInsertion insertion = begin_insertion();
    std::vector<glm::dvec2> chain = outline.vertices;
    if (outline.closed && !chain.empty()) chain.push_back(chain.front());
    insertion.insert(chain, {EdgeKind::traced, 0});
    finish_insertion(insertion);
}

}  // namespace povpreview
