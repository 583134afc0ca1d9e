// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/triangulation.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cassert>

namespace povpreview {

namespace {

struct VertexInfo {
    VertexId id{};
    std::uint32_t constraints = 0;  ///< constrained edges that end here
    bool border = false;
    bool touched = false;  ///< in the list of the current operation
};

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Faces = CGAL::Constrained_triangulation_face_base_2<Kernel>;
using Vertices = CGAL::Triangulation_vertex_base_with_info_2<VertexInfo, Kernel>;
using Structure = CGAL::Triangulation_data_structure_2<Vertices, Faces>;
using Base =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure, CGAL::Exact_predicates_tag>;

/// CGAL's triangulation, watched: it notes every vertex around which something changes, gives new
/// ones their numbers and keeps the labels of constraints.
class Watched : public Base {
   public:
    Watched(glm::dvec2 low_corner, glm::dvec2 high_corner) : low(low_corner), high(high_corner) {}

    const glm::dvec2 low, high;
    std::vector<Vertex_handle> handles;  // by id; null: removed
    std::vector<glm::dvec2> positions;   // by id
    std::vector<Vertex_handle> touched;
    std::vector<VertexId> path;
    ConstraintLabels labels;

    void touch(Vertex_handle v) {
        if (is_infinite(v) || v->info().touched) return;
        name(v);
        v->info().touched = true;
        touched.push_back(v);
    }

    VertexId name(Vertex_handle v) {
        VertexInfo& info = v->info();
        if (info.id.valid()) return info.id;
        const glm::dvec2 p{v->point().x(), v->point().y()};
        info.id = VertexId{static_cast<std::uint32_t>(handles.size())};
        info.border = p.x <= low.x || p.y <= low.y || p.x >= high.x || p.y >= high.y;
        handles.push_back(v);
        positions.push_back(p);
        return info.id;
    }

    Vertex_handle insert_at(const Point& p, Locate_type type, Face_handle face, int index) {
        // CGAL frees a constraint before it looks for a crossing on it, and mends what is no longer
        // Delaunay by inserting there, even where a vertex stands already.
        if (type != EDGE || !face->is_constrained(index)) {
            Vertex_handle v = Base::insert(p, type, face, index);
            touch(v);
            return v;
        }
        Vertex_handle a = face->vertex(cw(index)), b = face->vertex(ccw(index));
        const auto label = labels.take(a->info().id, b->info().id);
        Vertex_handle v = Base::insert(p, type, face, index);
        for (Vertex_handle w : {a, v, b}) touch(w);
        for (Vertex_handle w : {a, b}) labels.add(v->info().id, w->info().id, label.value());
        return v;
    }

    /// CGAL's insert_constraint, step by step so as to note every vertex on the way: CGAL is silent
    /// where the constraint runs along edges that are there already. Appends those after `from` to
    /// `way`, if there is one.
    void constrain(Vertex_handle from, Vertex_handle to, ConstraintLabel label,
                   std::vector<VertexId>* way) {
        std::vector<std::pair<Vertex_handle, Vertex_handle>> pending{{from, to}};
        while (!pending.empty()) {
            auto [a, b] = pending.back();
            pending.pop_back();
            touch(a);
            touch(b);
            Vertex_handle next;  // the first vertex on the way from a to b
            Face_handle face;
            int index = 0;
            if (includes_edge(a, b, next, face, index)) {
                mark_constraint(face, index);
            } else {
                List_faces crossed;
                List_edges left, right;
                if (find_intersected_faces(a, b, crossed, left, right, next)) {
                    // It met a constraint, which now ends in `next`.
                    if (next == a || next == b) {
                        pending.emplace_back(a, b);
                    } else {
                        pending.emplace_back(next, b);
                        pending.emplace_back(a, next);
                    }
                    continue;
                }
                triangulate_hole(crossed, left, right);
            }
            touch(next);
            labels.add(a->info().id, next->info().id, label);
            if (way) way->push_back(next->info().id);
            if (next != b) pending.emplace_back(next, b);
        }
    }

   protected:
    // CGAL inserts the crossings of constraints by these two.
    Vertex_handle virtual_insert(const Point& p, Face_handle start) override {
        Locate_type type;
        int index = 0;
        Face_handle face = locate(p, type, index, start);
        return insert_at(p, type, face, index);
    }
    Vertex_handle virtual_insert(const Point& p, Locate_type type, Face_handle face,
                                 int index) override {
        return insert_at(p, type, face, index);
    }
    // As CGAL's, but with our `constrain` for the halves of the constraint that is crossed.
    Vertex_handle intersect(Face_handle face, int index, Vertex_handle a,
                            Vertex_handle b) override {
        Vertex_handle c = face->vertex(cw(index)), d = face->vertex(ccw(index));
        touch(c);
        touch(d);
        const auto label = labels.take(c->info().id, d->info().id);
        Vertex_handle crossing =
            insert_intersection(face, index, a, b, c, d, a->point(), b->point(), c->point(),
                                d->point(), CGAL::Exact_predicates_tag());
        touch(crossing);
        if (crossing != c && crossing != d) {
            constrain(c, crossing, label.value(), nullptr);
            constrain(crossing, d, label.value(), nullptr);
        } else {
            constrain(c, d, label.value(), nullptr);
        }
        return crossing;
    }
    // A constraint replaces the faces that it crosses; all new edges end on the hole's rim.
    void triangulate_hole(List_faces& faces, List_edges& left, List_edges& right) override {
        for (const List_edges* rim : {&left, &right})
            for (const Edge& edge : *rim) {
                touch(edge.first->vertex(cw(edge.second)));
                touch(edge.first->vertex(ccw(edge.second)));
            }
        Base::triangulate_hole(faces, left, right);
    }
};

using Handle = Watched::Vertex_handle;
using Face = Watched::Face_handle;

Watched::Point point(glm::dvec2 p) { return {p.x, p.y}; }

}  // namespace

struct Triangulation::Impl {
    Impl(glm::dvec2 low, glm::dvec2 high) : cdt(low, high) {}

    Watched cdt;
    std::vector<VertexId> touched;
    std::size_t constraints = 0;

    Handle handle(VertexId id) const {
        assert(id.value < cdt.handles.size() && cdt.handles[id.value] != Handle());
        return cdt.handles[id.value];
    }

    void begin() {
        for (Handle v : cdt.touched) v->info().touched = false;
        cdt.touched.clear();
        cdt.path.clear();
        touched.clear();
    }

    std::uint32_t count_constraints(Handle v) const {
        std::uint32_t count = 0;
        auto edge = cdt.incident_edges(v), end = edge;
        do {
            if (!cdt.is_infinite(*edge) && edge->first->is_constrained(edge->second)) ++count;
        } while (++edge != end);
        return count;
    }

    /// Brings the counts of constraints up to date.
    void finish() {
        std::size_t sum_before = 0, sum_after = 0;
        for (Handle v : cdt.touched) {
            sum_before += v->info().constraints;
            v->info().constraints = count_constraints(v);
            sum_after += v->info().constraints;
            touched.push_back(v->info().id);
        }
        constraints = (2 * constraints + sum_after - sum_before) / 2;  // counted at both ends
    }

    Insertion insert(glm::dvec2 p, VertexId near) {
        Watched::Locate_type type;
        int index = 0;
        Face face = cdt.locate(point(p), type, index, handle(near)->face());
        assert(type != Watched::OUTSIDE_CONVEX_HULL && type != Watched::OUTSIDE_AFFINE_HULL);
        if (type == Watched::VERTEX) return {face->vertex(index)->info().id, false};
        return {cdt.insert_at(point(p), type, face, index)->info().id, true};
    }

    ConstraintLabel free_edge(VertexId a, VertexId b) {
        Face face;
        int index = 0;
        [[maybe_unused]] const bool found = cdt.is_edge(handle(a), handle(b), face, index);
        assert(found && face->is_constrained(index));
        std::vector<Face> flipped;
        cdt.remove_constrained_edge(face, index, std::back_inserter(flipped));
        cdt.touch(handle(a));
        cdt.touch(handle(b));
        for (Face f : flipped)
            for (int i = 0; i < 3; ++i) cdt.touch(f->vertex(i));
        return cdt.labels.take(a, b).value();
    }

    void constrain(VertexId a, VertexId b, ConstraintLabel label) {
        if (cdt.path.empty()) cdt.path.push_back(a);
        if (a != b) cdt.constrain(handle(a), handle(b), label, &cdt.path);
    }
};

Triangulation::Triangulation(glm::dvec2 low, glm::dvec2 high)
    : impl_(std::make_unique<Impl>(low, high)) {
    assert(low.x < high.x && low.y < high.y);
    for (glm::dvec2 corner : {low, {high.x, low.y}, high, {low.x, high.y}})
        impl_->cdt.name(impl_->cdt.insert(point(corner)));
}
Triangulation::~Triangulation() = default;
Triangulation::Triangulation(Triangulation&&) noexcept = default;
Triangulation& Triangulation::operator=(Triangulation&&) noexcept = default;

Triangulation::Insertion Triangulation::insert(glm::dvec2 position, VertexId near) {
    impl_->begin();
    const Insertion insertion = impl_->insert(position, near);
    impl_->finish();
    return insertion;
}

void Triangulation::constrain(VertexId a, VertexId b, ConstraintLabel label) {
    impl_->begin();
    impl_->constrain(a, b, label);
    impl_->finish();
}

Triangulation::Insertion Triangulation::split(VertexId a, VertexId b, glm::dvec2 p) {
    impl_->begin();
    const ConstraintLabel label = impl_->free_edge(a, b);
    const Insertion insertion = impl_->insert(p, a);
    impl_->constrain(a, insertion.vertex, label);
    impl_->constrain(insertion.vertex, b, label);
    impl_->finish();
    return insertion;
}

void Triangulation::remove(VertexId vertex) {
    impl_->begin();
    Handle v = impl_->handle(vertex);
    assert(v->info().constraints == 0 && !v->info().border);
    auto around = impl_->cdt.incident_vertices(v), end = around;
    do impl_->cdt.touch(around);
    while (++around != end);
    impl_->cdt.remove(v);
    impl_->cdt.handles[vertex.value] = Handle();
    impl_->finish();
}

std::span<const VertexId> Triangulation::touched() const { return impl_->touched; }
std::span<const VertexId> Triangulation::path() const { return impl_->cdt.path; }

glm::dvec2 Triangulation::position(VertexId vertex) const {
    return impl_->cdt.positions[vertex.value];
}
bool Triangulation::alive(VertexId vertex) const {
    return vertex.value < impl_->cdt.handles.size() && impl_->cdt.handles[vertex.value] != Handle();
}
bool Triangulation::on_constraint(VertexId vertex) const {
    return impl_->handle(vertex)->info().constraints > 0;
}
bool Triangulation::on_border(VertexId vertex) const {
    return impl_->handle(vertex)->info().border;
}
std::size_t Triangulation::vertex_ids() const { return impl_->cdt.handles.size(); }
std::size_t Triangulation::vertices() const { return impl_->cdt.number_of_vertices(); }
std::size_t Triangulation::faces() const { return impl_->cdt.number_of_faces(); }
std::size_t Triangulation::constraints() const { return impl_->constraints; }
const ConstraintLabels& Triangulation::labels() const { return impl_->cdt.labels; }

void Triangulation::fan(VertexId vertex, std::vector<Spoke>& spokes) const {
    spokes.clear();
    const Watched& cdt = impl_->cdt;
    Handle v = impl_->handle(vertex);
    auto face = cdt.incident_faces(v), end = face;
    std::size_t outside = 0;  // spokes before the outside
    do {
        // The face to the left of the spoke v-w; w is its vertex counter-clockwise after v.
        const int at = face->index(v);
        Handle w = face->vertex(cdt.ccw(at));
        if (cdt.is_infinite(w)) continue;
        const bool inside = !cdt.is_infinite(face);
        spokes.push_back({w->info().id, face->is_constrained(cdt.cw(at)), inside});
        if (!inside) outside = spokes.size();
    } while (++face != end);
    std::rotate(spokes.begin(), spokes.begin() + static_cast<std::ptrdiff_t>(outside),
                spokes.end());
}

bool Triangulation::find_edge(VertexId a, VertexId b, Edge& edge) const {
    if (!alive(a) || !alive(b)) return false;
    Face face;
    int index = 0;
    if (!impl_->cdt.is_edge(impl_->handle(a), impl_->handle(b), face, index)) return false;
    // CGAL gives the edge by the vertex across it; a is before or after that.
    Handle here = face->vertex(index);
    Handle there = impl_->cdt.mirror_vertex(face, index);
    if (face->vertex(impl_->cdt.ccw(index)) != impl_->handle(a)) std::swap(here, there);
    edge.constrained = face->is_constrained(index);
    edge.left = impl_->cdt.is_infinite(here) ? VertexId{} : here->info().id;
    edge.right = impl_->cdt.is_infinite(there) ? VertexId{} : there->info().id;
    return true;
}

std::array<VertexId, 3> Triangulation::locate(glm::dvec2 position, VertexId near) const {
    Face face = impl_->cdt.locate(point(position), impl_->handle(near)->face());
    for (int i = 0; i < 3; ++i)  // on the border CGAL may answer with the face outside
        if (impl_->cdt.is_infinite(face->vertex(i))) {
            face = face->neighbor(i);
            break;
        }
    return {face->vertex(0)->info().id, face->vertex(1)->info().id, face->vertex(2)->info().id};
}

void Triangulation::for_each_face(
    const std::function<void(VertexId, VertexId, VertexId)>& f) const {
    for (Face face : impl_->cdt.finite_face_handles())
        f(face->vertex(0)->info().id, face->vertex(1)->info().id, face->vertex(2)->info().id);
}

void Triangulation::for_each_edge(const std::function<void(VertexId, VertexId, bool)>& f) const {
    const Watched& cdt = impl_->cdt;
    for (const auto& [face, index] : cdt.finite_edges())
        f(face->vertex(cdt.ccw(index))->info().id, face->vertex(cdt.cw(index))->info().id,
          face->is_constrained(index));
}

bool Triangulation::sound() const { return impl_->cdt.is_valid(); }

}  // namespace povpreview
