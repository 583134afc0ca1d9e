// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <set>

#include "core/mesh.h"
#include "core/predicates.h"

namespace povpreview {

namespace {

using Spoke = Triangulation::Spoke;

std::string named(const char* what, VertexId a) { return what + std::to_string(a.value); }
std::string named(const char* what, VertexId a, VertexId b) {
    return named(what, a) + "-" + std::to_string(b.value);
}

std::string validate_faces(const Triangulation& t, double area) {
    std::string fault;
    double sum = 0;
    t.for_each_face([&](VertexId a, VertexId b, VertexId c) {
        const glm::dvec2 p = t.position(a), q = t.position(b), r = t.position(c);
        if (fault.empty() && orientation(p, q, r) <= 0)
            fault = named("a face is flat or turned over at vertex ", a);
        sum += ((q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x)) / 2;
    });
    if (fault.empty() && std::abs(sum - area) > 1e-9 * area)
        fault =
            "the faces cover " + std::to_string(sum) + " square pixels of " + std::to_string(area);
    return fault;
}

std::string validate_edges(const Triangulation& t) {
    std::string fault;
    t.for_each_edge([&](VertexId a, VertexId b, bool constrained) {
        Triangulation::Edge edge{}, back{};
        if (!fault.empty()) return;
        if (!t.find_edge(a, b, edge) || !t.find_edge(b, a, back))
            fault = named("the links miss edge ", a, b);
        else if (edge.constrained != constrained || edge.left != back.right ||
                 edge.right != back.left)
            fault = named("the links disagree about edge ", a, b);
        else if (constrained != t.labels().find(a, b).has_value())
            fault = named("a label too few or too many at edge ", a, b);
        else if (constrained && !(t.on_constraint(a) && t.on_constraint(b)))
            fault = named("a vertex does not know of the constraint ", a, b);
        else if (!constrained && edge.left.valid() && edge.right.valid() &&
                 in_circle(t.position(a), t.position(b), t.position(edge.left),
                           t.position(edge.right)) > 0)
            fault = named("Delaunay fails, and no constraint excuses it, at edge ", a, b);
    });
    std::size_t labels = 0;
    for (std::size_t count : t.labels().counts()) labels += count;
    if (fault.empty() && (labels != t.constraints() || labels != t.labels().size()))
        fault = "there are " + std::to_string(t.labels().size()) + " labels, " +
                std::to_string(labels) + " by kind, for " + std::to_string(t.constraints()) +
                " constraints";
    return fault;
}

/// Whether the direction of p, seen from the centre, lies within a wedge; by angles, so that it
/// owes nothing to the predicates which the mesh itself goes by, but where both rays have one
/// direction: these do not tell a sliver from all around.
bool between(const Wedge& w, glm::dvec2 p) {
    const auto angle = [&](glm::dvec2 q) { return std::atan2(q.y - w.centre.y, q.x - w.centre.x); };
    const auto turn = [&](double from, double to) {
        const double t = std::fmod(to - from, 2 * std::numbers::pi);
        return t < 0 ? t + 2 * std::numbers::pi : t;
    };
    const double rounding = 1e-9;  // radians; samples keep farther from their constraints
    double whole = turn(angle(w.start), angle(w.end));
    if (whole < rounding && w.turn < 0) whole = 2 * std::numbers::pi;
    return turn(angle(w.start), angle(p)) <= whole + rounding;
}

}  // namespace

std::string Mesh::validate() const {
    const Triangulation& t = triangulation_;
    if (std::string fault = validate_faces(t, double(width_) * height_); !fault.empty())
        return fault;
    if (std::string fault = validate_edges(t); !fault.empty()) return fault;

    std::vector<bool> reached(samples_.size());
    std::vector<Spoke> fan;
    std::vector<Sector> sectors;
    for (std::uint32_t i = 0; i < t.vertex_ids(); ++i) {
        const VertexId v{i};
        for (SampleId id = first_[i]; id.valid(); id = samples_[id.value].next) {
            if (reached[id.value]) return named("a sample is held twice, by vertex ", v);
            reached[id.value] = true;
        }
        if (!t.alive(v) || !t.on_constraint(v)) continue;
        t.fan(v, fan);
        find_sectors(fan, sectors);
        std::set<SampleId> used;
        std::size_t faces = 0;
        for (const Sector& sector : sectors) {
            const Wedge w = wedge(v, fan, sector);
            const SampleId shown = corner(v, fan[sector.first].to, true);
            for (SampleId id = first_[i]; id.valid(); id = samples_[id.value].next) {
                const glm::dvec2 p = samples_[id.value].position;
                if (!w.contains(p)) continue;
                if (!shown.valid()) return named("a sector misses its sample at vertex ", v);
                if (w.clearance(p) > w.clearance(samples_[shown.value].position))
                    return named("a sector shows the less clear of two samples at vertex ", v);
                used.insert(id);
            }
            for (std::size_t f = 0; f < sector.faces; ++f, ++faces) {
                const VertexId to = fan[(sector.first + f) % fan.size()].to;
                const VertexId after = fan[(sector.first + f + 1) % fan.size()].to;
                const SampleId id = corner(v, to, true);
                if (id != corner(v, after, false))
                    return named("a face's corner has two samples at vertex ", v);
                if (!id.valid()) continue;
                used.insert(id);
                if (!w.whole && !between(w, samples_[id.value].position))
                    return named("a corner's sample lies outside its sector at vertex ", v);
            }
        }
        if (faces != fan.size() - (fan.back().face ? 0 : 1))
            return named("the sectors do not hold every face around vertex ", v);
        // A sample older than the constraint may lie on it, or at the vertex: it is of no side.
        const auto on_spoke = [&](glm::dvec2 p) {
            return std::any_of(fan.begin(), fan.end(), [&](const Spoke& spoke) {
                return orientation(t.position(v), t.position(spoke.to), p) == 0;
            });
        };
        for (SampleId id = first_[i]; id.valid(); id = samples_[id.value].next)
            if (!used.contains(id) && !on_spoke(samples_[id.value].position))
                return named("a one-sided sample is in no sector of vertex ", v);
    }
    if (std::find(reached.begin(), reached.end(), false) != reached.end())
        return "a sample belongs to no vertex";
    return {};
}

}  // namespace povpreview
