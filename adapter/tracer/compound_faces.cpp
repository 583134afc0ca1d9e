// SPDX-License-Identifier: AGPL-3.0-or-later
#include "backend/oracle/compound_faces.h"

#include <algorithm>
#include <string_view>
#include <utility>

// The order of POV-Ray's headers matters: frame.h first, povdebug.h last.
// clang-format off
#include "backend/frame.h"
#include "backend/scene/objects.h"
#include "backend/lighting/point.h"
#include "backend/shape/bezier.h"
#include "backend/shape/boxes.h"
#include "backend/shape/cones.h"
#include "backend/shape/csg.h"
#include "backend/shape/discs.h"
#include "backend/shape/planes.h"
#include "backend/shape/spheres.h"
// clang-format on

#include "backend/oracle/even_odd.h"
#include "base/povdebug.h"

namespace povpreview::tracer {

namespace {

/// Each primitive may be cut by each other; more of them than this take longer than they are worth.
constexpr std::size_t max_primitives = 1000;
/// Pieces of one compound: each is judged by all of its parts.
constexpr std::size_t max_pieces = 20000;
/// Cells that one primitive's inside may consist of, and corners that a face of it may have.
constexpr std::size_t max_cells = 500, max_corners = 2000;

template <typename Class>
bool is_a(const pov::ObjectBase& object) {
    return dynamic_cast<const Class*>(&object) != nullptr;
}

const std::vector<pov::ObjectPtr>& children(const pov::ObjectBase& object) {
    return static_cast<const pov::CompoundObject&>(object).children;
}

/// An even-odd polygon as convex ones, by way of coordinates in its plane. That is spanned by a
/// first point, the one farthest from it, and the one farthest from their line: areas of the rings
/// may cancel out.
std::vector<ConvexPolygon> convex_pieces(const std::vector<ConvexPolygon>& rings) {
    const Point origin = rings.front().front();
    Point u, normal;
    for (const ConvexPolygon& ring : rings)
        for (const Point& p : ring)
            if (length(p - origin) > length(u)) u = p - origin;
    for (const ConvexPolygon& ring : rings)
        for (const Point& p : ring) {
            const Point area = cross(u, p - origin);
            if (length(area) > length(normal)) normal = area;
        }
    if (!(length(normal) > 0)) return {};
    Point v = cross(normal, u);
    u = (1 / length(u)) * u;
    v = (1 / length(v)) * v;
    std::vector<Ring> flat;
    for (const ConvexPolygon& ring : rings) {
        flat.emplace_back();
        for (const Point& p : ring) flat.back().push_back({dot(p - origin, u), dot(p - origin, v)});
    }
    std::vector<ConvexPolygon> pieces;
    for (const Ring& piece : trapezoids(flat)) {
        pieces.emplace_back();
        for (const Point2& p : piece) pieces.back().push_back(origin + p.u * u + p.v * v);
    }
    return pieces;
}

/// Whether the inside of an object that bounds others is convex.
bool is_convex(const pov::ObjectBase& object) {
    if (Test_Flag(&object, INVERTED_FLAG) || !object.Clip.empty()) return false;
    if (is_a<pov::CSGIntersection>(object))
        return std::all_of(children(object).begin(), children(object).end(),
                           [](pov::ConstObjectPtr child) { return is_convex(*child); });
    return is_a<pov::Box>(object) || is_a<pov::Sphere>(object) || is_a<pov::Cone>(object) ||
           is_a<pov::Plane>(object);
}

}  // namespace

const char* CompoundFaces::build(const pov::ObjectBase& object) {
    Solid root;
    if (const char* reason = add(object, nullptr, root)) return reason;
    return resolve(root, std::min(limits_.max_faces, max_pieces), pieces_) ? nullptr
                                                                           : "too many faces";
}

/// `flagged`: the object whose flags count for all below it; null while each has its own.
const char* CompoundFaces::add(const pov::ObjectBase& object, const pov::ObjectBase* flagged,
                               Solid& solid) {
    const std::size_t first_primitive = primitives_.size();
    if (is_a<pov::CSG>(object)) {
        const bool intersection = is_a<pov::CSGIntersection>(object);
        solid.kind = intersection                  ? Solid::Kind::intersect
                     : is_a<pov::CSGMerge>(object) ? Solid::Kind::merge
                                                   : Solid::Kind::unite;
        // POV-Ray looks at the flags of an intersection as a whole, but of each part of a union.
        if (intersection && flagged == nullptr) flagged = &object;
        const bool cut = cut_by_others_;
        cut_by_others_ = cut || solid.kind != Solid::Kind::unite;
        solid.parts.reserve(children(object).size());
        for (const pov::ObjectPtr child : children(object)) {
            if (is_a<pov::LightSource>(*child)) {
                if (!children(*child).empty()) return "has a light that looks like something";
                continue;
            }
            solid.parts.emplace_back();
            if (const char* reason = add(*child, flagged, solid.parts.back())) return reason;
        }
        cut_by_others_ = cut;
    } else if (const char* reason =
                   add_primitive(object, flagged != nullptr ? *flagged : object, solid)) {
        return reason;
    }
    if (const char* reason = check_bound(object, solid, first_primitive)) return reason;
    return add_clips(object, solid);
}

const char* CompoundFaces::add_clips(const pov::ObjectBase& object, Solid& solid) {
    if (is_a<pov::BicubicPatch>(object)) return nullptr;  // POV-Ray does not clip it
    const std::size_t shown = primitives_.size();
    const bool cut = std::exchange(cut_by_others_, false);
    for (const pov::ObjectPtr clip : object.Clip) {
        solid.clips.emplace_back();
        if (const char* reason = add(*clip, &object, solid.clips.back())) {
            return std::string_view(reason) == "curved" ? "clipped by something curved" : reason;
        }
    }
    cut_by_others_ = cut;
    primitives_.resize(shown);  // only their inside is needed, and the solid has that
    return nullptr;
}

const char* CompoundFaces::add_primitive(const pov::ObjectBase& object,
                                         const pov::ObjectBase& flagged, Solid& solid) {
    if (primitives_.size() >= max_primitives) return "too many parts";
    const auto number = static_cast<std::uint32_t>(primitives_.size());
    primitives_.push_back({&object, &flagged, {}});
    ObjectFaces& faces = primitives_.back().faces;
    if (const char* reason = faces_of(object, limits_, faces)) return reason;
    if (!has_cells(object)) return "has an inside that is not known to be convex";
    // POV-Ray shows what is cut by it as far as rays meet a box around the disc itself.
    if (cut_by_others_ && is_a<pov::Disc>(object))
        return "has a disc, whose inside is half of space";
    for (const ObjectFaces::Ring& ring : faces.rings)
        if (ring.count > max_corners) return "too many corners";
    solid.kind = Solid::Kind::leaf;
    solid.number = number;
    solid.leaf.cells = cells_of(object, faces);
    if (solid.leaf.cells.size() > max_cells) return "too many corners";
    solid.leaf.inverted = Test_Flag(&object, INVERTED_FLAG) != 0;
    for (std::uint32_t i = 0; i < faces.faces.size(); ++i) {
        const std::vector<ConvexPolygon> rings = faces.rings_of(faces.faces[i]);
        for (const ConvexPolygon& piece : faces.faces[i].convex ? rings : convex_pieces(rings))
            solid.leaf.faces.push_back({piece, i});
    }
    return nullptr;
}

/// A bound that holds everything has no effect. One that does not hides what POV-Ray's rays reach
/// without meeting it, which depends on where they come from.
const char* CompoundFaces::check_bound(const pov::ObjectBase& object, const Solid& solid,
                                       std::size_t first_primitive) const {
    if (object.Bound.empty() || object.Bound == object.Clip) return nullptr;
    for (const pov::ObjectPtr bound : object.Bound)
        if (!is_convex(*bound)) return "bounded by something not convex";
    std::vector<Point> points;
    for (std::size_t i = first_primitive; i < primitives_.size(); ++i) {
        const std::vector<Point>& corners = primitives_[i].faces.points;
        points.insert(points.end(), corners.begin(), corners.end());
    }
    if (bounds_hold(object, points)) return nullptr;
    // What the parts leave of each other may be less, above all of planes.
    std::vector<SolidPiece> pieces;
    if (!resolve(solid, std::min(limits_.max_faces, max_pieces), pieces)) return "too many faces";
    points.clear();
    for (const SolidPiece& piece : pieces)
        points.insert(points.end(), piece.corners.begin(), piece.corners.end());
    return bounds_hold(object, points) ? nullptr : "bounded by less than all";
}

/// Whether all of an object's bounds hold all of the points.
bool CompoundFaces::bounds_hold(const pov::ObjectBase& object,
                                const std::vector<Point>& points) const {
    Extent extent;
    for (const Point& p : points) extent.include(p);
    const Point middle = 0.5 * (extent.low + extent.high);
    for (const pov::ObjectPtr bound : object.Bound)
        for (const Point& p : points)
            // Not exactly at the corner, where rounding decides.
            if (!inside_(p + 1e-6 * (middle - p), *bound)) return false;
    return true;
}

}  // namespace povpreview::tracer
