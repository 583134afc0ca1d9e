// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/outline_insertion.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <set>

#include "core/polyline.h"

namespace povpreview {

namespace {

/// Puts the chain of one outline into a mesh.
class Insertion {
   public:
    Insertion(Mesh& mesh, glm::ivec2 size, const std::function<void(VertexId)>& removed)
        : mesh_(mesh), t_(mesh.triangulation()), size_(size), removed_(removed) {}

    std::vector<VertexId> run(const Outline& outline) {
        std::vector<VertexId> chain;
        for (glm::dvec2 p : outline.vertices) {
            const VertexId v = place(p);
            keep_.insert(v);
            if (chain.empty() || chain.back() != v) chain.push_back(v);
        }
        if (outline.closed && chain.size() > 2 && chain.front() != chain.back())
            chain.push_back(chain.front());
        for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
            VertexId from = chain[i];
            clear_segment(from, chain[i + 1]);
            for (VertexId v : beside_segment(from, chain[i + 1])) {
                mesh_.constrain(from, v);
                note_touched();
                from = v;
            }
        }
        std::vector<VertexId> live;
        for (VertexId v : touched_)
            if (t_.alive(v)) live.push_back(v);
        return live;
    }

   private:
    void note_touched() {
        touched_.insert(t_.touched().begin(), t_.touched().end());
        if (!t_.touched().empty()) near_ = t_.touched().back();
    }
    VertexId near() const { return t_.alive(near_) ? near_ : VertexId{0}; }

    static double snapped(double value, double high) {
        if (value < border_snap) return 0;
        return value > high - border_snap ? high : value;
    }

    /// The vertex that a point of the outline becomes: an old one, a new one on an old constraint,
    /// or a new one at the point itself.
    VertexId place(glm::dvec2 p) {
        p = {snapped(p.x, size_.x), snapped(p.y, size_.y)};
        const auto face = t_.locate(p, near());
        if (const VertexId v = fixed_vertex(face, p); v.valid()) return near_ = v;
        if (const auto [a, b] = constraint_near(face, p); a.valid()) {
            const glm::dvec2 q = t_.position(a), d = t_.position(b) - q;
            const VertexId v =
                mesh_.split(a, b, q + glm::dot(p - q, d) / glm::dot(d, d) * d).vertex;
            note_touched();
            return near_ = v;
        }
        clear_around(p, p);
        const VertexId v = mesh_.insert(p, near()).vertex;
        note_touched();
        return near_ = v;
    }

    /// The nearest vertex, among those around, that must stay where it is.
    VertexId fixed_vertex(const std::array<VertexId, 3>& face, glm::dvec2 p) {
        VertexId best;
        double least = outline_snap;
        const auto consider = [&](VertexId v) {
            if (!t_.on_constraint(v) && !t_.on_border(v) && !keep_.contains(v)) return;
            const double d = glm::distance(t_.position(v), p);
            if (d >= least) return;
            // A point inside must not be drawn to the border beside it.
            if (t_.on_border(v) && !t_.on_constraint(v) && p.x > 0 && p.y > 0 && p.x < size_.x &&
                p.y < size_.y)
                return;
            least = d;
            best = v;
        };
        for (VertexId v : face) {
            consider(v);
            t_.fan(v, fan_);
            for (const auto& spoke : fan_) consider(spoke.to);
        }
        return best;
    }

    /// The nearest constraint among the edges of the face and of the faces beside it.
    std::pair<VertexId, VertexId> constraint_near(const std::array<VertexId, 3>& face,
                                                  glm::dvec2 p) {
        std::pair<VertexId, VertexId> best;
        double least = outline_snap;
        const auto consider = [&](VertexId a, VertexId b) {
            Triangulation::Edge edge{};
            if (!t_.find_edge(a, b, edge) || !edge.constrained) return;
            const double d = distance_to_segment(p, t_.position(a), t_.position(b));
            if (d < least) least = d, best = {a, b};
        };
        for (std::size_t i = 0; i < 3; ++i) {
            const VertexId a = face[i], b = face[(i + 1) % 3];
            consider(a, b);
            Triangulation::Edge edge{};
            if (t_.find_edge(a, b, edge) && edge.right.valid()) {
                consider(a, edge.right);
                consider(b, edge.right);
            }
        }
        return best;
    }

    /// Removes the plain vertices of the face at `p` that come too near to the segment.
    void clear_around(glm::dvec2 p, glm::dvec2 a) { clear_around(p, a, a); }
    void clear_around(glm::dvec2 p, glm::dvec2 a, glm::dvec2 b) {
        for (bool again = true; again;) {
            again = false;
            for (VertexId v : t_.locate(p, near())) {
                if (t_.on_constraint(v) || t_.on_border(v) || keep_.contains(v)) continue;
                if (distance_to_segment(t_.position(v), a, b) >= constraint_clearance) continue;
                removed_(v);
                mesh_.remove(v);
                note_touched();
                again = true;
                break;
            }
        }
    }
    void clear_segment(VertexId from, VertexId to) {
        const glm::dvec2 a = t_.position(from), b = t_.position(to);
        near_ = from;
        const int steps = static_cast<int>(std::ceil(glm::distance(a, b)));
        for (int i = 0; i <= steps; ++i) clear_around(a + (b - a) * (double(i) / steps), a, b);
    }

    /// The end of a segment, and before it the constrained vertices so close to the segment that it
    /// must run through them: else it would leave a sliver.
    ///
    ///     a ========== v ========== b       a-v-b is there; a-b comes a second time, a hair beside
    std::vector<VertexId> beside_segment(VertexId from, VertexId to) {
        const glm::dvec2 a = t_.position(from), b = t_.position(to), d = b - a;
        std::set<std::pair<double, VertexId>> found;  // by place along the segment
        near_ = from;
        const int steps = static_cast<int>(std::ceil(glm::length(d)));
        for (int i = 0; i <= steps; ++i)
            for (VertexId v : t_.locate(a + d * (double(i) / steps), near())) {
                near_ = v;
                if (v == from || v == to || !(t_.on_constraint(v) || keep_.contains(v))) continue;
                const glm::dvec2 p = t_.position(v);
                const double along = glm::dot(p - a, d) / glm::dot(d, d);
                if (along > 0 && along < 1 && distance_to_segment(p, a, b) < outline_snap)
                    found.emplace(along, v);
            }
        std::vector<VertexId> path;
        for (const auto& [along, v] : found) path.push_back(v);
        path.push_back(to);
        return path;
    }

    Mesh& mesh_;
    const Triangulation& t_;
    glm::ivec2 size_;
    const std::function<void(VertexId)>& removed_;
    std::set<VertexId> keep_;  // the chain itself, whose constraints may not be there yet
    std::set<VertexId> touched_;
    VertexId near_{0};
    std::vector<Triangulation::Spoke> fan_;
};

}  // namespace

std::vector<VertexId> insert_outline(Mesh& mesh, glm::ivec2 image_size, const Outline& outline,
                                     const std::function<void(VertexId)>& removed) {
    if (outline.vertices.size() < 2) return {};
    return Insertion(mesh, image_size, removed).run(outline);
}

bool too_near_constraint(const Triangulation& t, glm::dvec2 position, VertexId near) {
    if (t.constraints() == 0) return false;
    const auto face = t.locate(position, near);
    for (std::size_t i = 0; i < 3; ++i) {
        Triangulation::Edge edge{};
        const VertexId a = face[i], b = face[(i + 1) % 3];
        if (t.find_edge(a, b, edge) && edge.constrained &&
            distance_to_segment(position, t.position(a), t.position(b)) < constraint_clearance)
            return true;
    }
    return false;
}

}  // namespace povpreview
