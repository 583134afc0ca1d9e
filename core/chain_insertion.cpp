// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/chain_insertion.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "core/polyline.h"

namespace povpreview {

ChainInsertion::ChainInsertion(Mesh& mesh, glm::ivec2 image_size,
                               std::function<void(VertexId)> removed)
    : mesh_(mesh), t_(mesh.triangulation()), size_(image_size), removed_(std::move(removed)) {
    mesh_.hold_sides();
}

std::vector<VertexId> ChainInsertion::finish() {
    std::erase_if(touched_, [&](VertexId v) { return !t_.alive(v); });
    std::sort(touched_.begin(), touched_.end());
    mesh_.release_sides(touched_);
    is_touched_.clear();
    return std::move(touched_);
}

void ChainInsertion::insert(std::span<const glm::dvec2> chain, ConstraintLabel label) {
    if (chain.size() < 2) return;
    tolerances_ = tolerances(label.kind);
    previous_ = {};
    const std::size_t before = t_.vertex_ids();
    const VertexId first = place(chain.front());
    previous_ = first;
    for (glm::dvec2 p : chain.subspan(1)) {
        const VertexId v = place(p);
        if (v != previous_) connect(previous_, v, label);
        previous_ = v;
    }
    // A chain smaller than the snap distance leaves nothing behind.
    const bool fresh = first.value >= before;
    previous_ = {};
    if (fresh && plain(first)) drop(first);
}

void ChainInsertion::note_touched() {
    is_touched_.resize(t_.vertex_ids());
    for (VertexId v : t_.touched()) {
        if (!is_touched_[v.value]) touched_.push_back(v);
        is_touched_[v.value] = true;
    }
}

/// Whether a vertex may be removed.
bool ChainInsertion::plain(VertexId v) const {
    return v != previous_ && !t_.on_constraint(v) && !t_.on_border(v);
}

VertexId ChainInsertion::near() const { return t_.alive(near_) ? near_ : VertexId{0}; }

/// The vertex that a point of the chain becomes: an old one, a new one on an old constraint, or a
/// new one at the point itself.
VertexId ChainInsertion::place(glm::dvec2 p) {
    for (int k = 0; k < 2; ++k) {
        if (p[k] < tolerances_.border) p[k] = 0;
        if (p[k] > size_[k] - tolerances_.border) p[k] = size_[k];
    }
    const auto nearby = around(p);
    near_ = nearby[0];
    if (const VertexId v = fixed_vertex(nearby, p); v.valid()) return near_ = v;
    if (const auto [a, b] = constraint_near(nearby, p); a.valid()) {
        const glm::dvec2 q = t_.position(a), d = t_.position(b) - q;
        const double along = std::clamp(glm::dot(p - q, d) / glm::dot(d, d), 0., 1.);
        near_ = mesh_.split(a, b, q + along * d).vertex;
        note_touched();
        return near_;
    }
    clear_around(p);
    near_ = mesh_.insert(p, near()).vertex;
    note_touched();
    clear_fan(near_, p, p);
    return near_;
}

/// The corners of the face at p, and those of its neighbours that lie across an edge of it.
///
///     3 ---- 0 ---- 5
///      \    /p\    /
///       \  /   \  /
///        1 ---- 2
///         \    /
///           4
std::array<VertexId, 6> ChainInsertion::around(glm::dvec2 p) const {
    const auto face = t_.locate(p, near());
    std::array<VertexId, 6> result{face[0], face[1], face[2]};
    for (std::size_t i = 0; i < 3; ++i) {
        Triangulation::Edge edge{};
        if (t_.find_edge(face[i], face[(i + 1) % 3], edge)) result[3 + i] = edge.right;
    }
    return result;
}

/// The nearest of the vertices around that must stay where it is.
VertexId ChainInsertion::fixed_vertex(const std::array<VertexId, 6>& around, glm::dvec2 p) const {
    VertexId best;
    double least = tolerances_.snap;
    const bool inside = p.x > 0 && p.y > 0 && p.x < size_.x && p.y < size_.y;
    for (VertexId v : around) {
        if (!v.valid() || plain(v)) continue;
        // A point inside must not be drawn to the border beside it.
        if (inside && t_.on_border(v) && !t_.on_constraint(v)) continue;
        const double d = glm::distance(t_.position(v), p);
        if (d < least) least = d, best = v;
    }
    return best;
}

/// The nearest constraint among the edges of the face and of the faces beside it.
std::pair<VertexId, VertexId> ChainInsertion::constraint_near(const std::array<VertexId, 6>& around,
                                                              glm::dvec2 p) const {
    std::pair<VertexId, VertexId> best;
    double least = tolerances_.snap;
    const auto consider = [&](VertexId a, VertexId b) {
        if (!a.valid() || !b.valid() || !t_.on_constraint(a) || !t_.on_constraint(b)) return;
        const double d = distance_to_segment(p, t_.position(a), t_.position(b));
        if (d < least && t_.labels().find(a, b)) least = d, best = {a, b};
    };
    for (std::size_t i = 0; i < 3; ++i) {
        const VertexId a = around[i], b = around[(i + 1) % 3];
        consider(a, b);
        consider(a, around[3 + i]);
        consider(b, around[3 + i]);
    }
    return best;
}

void ChainInsertion::drop(VertexId v) {
    removed_(v);
    mesh_.remove(v);
    note_touched();
}

/// Removes the plain vertices of the face at p that are too near to a vertex there.
void ChainInsertion::clear_around(glm::dvec2 p) {
    for (bool again = true; again;) {
        again = false;
        for (VertexId v : t_.locate(p, near())) {
            if (!plain(v) || glm::distance(t_.position(v), p) >= tolerances_.clearance) continue;
            near_ = {0};
            drop(v);
            near_ = t_.touched().front();
            again = true;
            break;
        }
    }
}

/// Removes the plain neighbours of a vertex that are too near to a segment.
void ChainInsertion::clear_fan(VertexId v, glm::dvec2 a, glm::dvec2 b) {
    for (bool again = true; again;) {
        again = false;
        t_.fan(v, fan_);
        for (const auto& spoke : fan_) {
            if (!plain(spoke.to) ||
                distance_to_segment(t_.position(spoke.to), a, b) >= tolerances_.clearance)
                continue;
            drop(spoke.to);
            again = true;
            break;
        }
    }
}

void ChainInsertion::connect(VertexId from, VertexId to, ConstraintLabel label) {
    mesh_.constrain(from, to, label);
    note_touched();
    const auto path = t_.path();
    for (std::size_t i = path.size() - 1; i > 0; --i) fresh_.emplace_back(path[i - 1], path[i]);
    clear_sides();
}

/// Ends, for each constraint that is taken back gives way to shorter ones between old vertices.
void ChainInsertion::clear_sides() {
    while (!fresh_.empty()) {
        const auto [u, v] = fresh_.back();
        fresh_.pop_back();
        if (!t_.labels().find(u, v) || !clear_side(u, v, true) || !clear_side(u, v, false))
            continue;
        for (VertexId end : {u, v}) clear_fan(end, t_.position(u), t_.position(v));
    }
}

/// Returns false where the constraint now runs through another vertex.
bool ChainInsertion::clear_side(VertexId u, VertexId v, bool left) {
    const glm::dvec2 a = t_.position(u), b = t_.position(v);
    for (;;) {
        Triangulation::Edge edge{};
        if (!t_.find_edge(u, v, edge)) return false;
        const VertexId w = left ? edge.left : edge.right;
        if (!w.valid()) return true;
        const glm::dvec2 p = t_.position(w);
        const double d = distance_to_segment(p, a, b);
        if (plain(w)) {
            if (d >= tolerances_.clearance) return true;
            drop(w);
            continue;
        }
        // Nearer to an end the detour would not be shorter than the constraint, and might come
        // back.
        const double length = glm::distance(a, b), along = glm::dot(p - a, b - a) / length;
        if (d >= tolerances_.snap || !t_.on_constraint(w) || along <= tolerances_.snap ||
            along >= length - tolerances_.snap)
            return true;
        mesh_.split(u, v, p);
        note_touched();
        fresh_.emplace_back(w, v);
        fresh_.emplace_back(u, w);
        return false;
    }
}

bool too_near_constraint(const Triangulation& t, glm::dvec2 position, VertexId near) {
    if (t.constraints() == 0) return false;
    const auto face = t.locate(position, near);
    for (std::size_t i = 0; i < 3; ++i) {
        const VertexId a = face[i], b = face[(i + 1) % 3];
        if (!t.on_constraint(a) || !t.on_constraint(b)) continue;
        const auto label = t.labels().find(a, b);
        if (label && distance_to_segment(position, t.position(a), t.position(b)) <
                         tolerances(label->kind).clearance)
            return true;
    }
    return false;
}

}  // namespace povpreview
