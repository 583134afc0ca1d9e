// SPDX-License-Identifier: AGPL-3.0-or-later
#include "backend/oracle/geometry_export.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

// The order of POV-Ray's headers matters: frame.h first, povdebug.h last.
// clang-format off
#include "backend/frame.h"
#include "backend/scene/objects.h"
#include "backend/lighting/point.h"
#include "backend/shape/bezier.h"
#include "backend/shape/csg.h"
// clang-format on

#include "backend/oracle/object_kinds.h"
#include "base/povdebug.h"

namespace povpreview::tracer {

namespace {

template <typename Class>
bool is_a(const pov::ObjectBase& object) {
    return dynamic_cast<const Class*>(&object) != nullptr;
}

const std::vector<pov::ObjectPtr>& children(const pov::ObjectBase& object) {
    return static_cast<const pov::CompoundObject&>(object).children;
}

bool is_union(const pov::ObjectBase& object) {
    return is_a<pov::CSGUnion>(object) && !is_a<pov::CSGMerge>(object);
}

/// A union shows what its parts show.
bool is_sum_of_parts(const pov::ObjectBase& object) {
    return is_union(object) && object.Clip.empty() && object.Bound.empty();
}

/// POV-Ray's box around an object: no ray that misses it sees the object.
BoxFacts box_of(const pov::ObjectBase& object) {
    const auto side = [&object](int i) {
        const double low = object.BBox.Lower_Left[i], size = object.BBox.Lengths[i],
                     high = low + size;
        // It is kept in single precision.
        const double slack = 1e-6 * (std::fabs(low) + std::fabs(high));
        constexpr double far = 0.1 * BOUND_HUGE, infinity = HUGE_VAL;
        return std::pair(low > -far ? low - slack : -infinity,
                         high < far ? high + slack : infinity);
    };
    const auto [low_x, high_x] = side(0);
    const auto [low_y, high_y] = side(1);
    const auto [low_z, high_z] = side(2);
    return {{low_x, low_y, low_z}, {high_x, high_y, high_z}};
}

BoxFacts common_box(const BoxFacts& a, const BoxFacts& b) {
    return {
        {std::max(a.low.x, b.low.x), std::max(a.low.y, b.low.y), std::max(a.low.z, b.low.z)},
        {std::min(a.high.x, b.high.x), std::min(a.high.y, b.high.y), std::min(a.high.z, b.high.z)}};
}

/// Whether some of an object is seen by the eye alone or in mirrors alone.
bool differs_in_mirrors(const pov::ObjectBase& object) {
    if (Test_Flag(&object, NO_IMAGE_FLAG) || Test_Flag(&object, NO_REFLECTION_FLAG)) return true;
    if (!is_a<pov::CSG>(object)) return false;
    return std::any_of(children(object).begin(), children(object).end(),
                       [](pov::ConstObjectPtr child) { return differs_in_mirrors(*child); });
}

bool stands_alone(const pov::ObjectBase& object) {
    const bool clipped = !object.Clip.empty() && !is_a<pov::BicubicPatch>(object);
    return !is_a<pov::CSG>(object) && !clipped && object.Bound.empty();
}

bool too_long(const ObjectFaces& faces, const ObjectFaces::Face& face) {
    std::size_t corners = 0;
    for (std::uint32_t r = face.first_ring; r < face.first_ring + face.rings; ++r)
        corners += faces.rings[r].count;
    return corners > GeometryWriter::max_corners;
}

}  // namespace

void GeometryExport::run(const std::vector<pov::ObjectPtr>& objects) {
    for (auto object = objects.rbegin(); object != objects.rend(); ++object)
        waiting_.push_back({*object, {}, everything});
    while (!waiting_.empty()) {
        const Waiting next = std::move(waiting_.back());
        waiting_.pop_back();
        around_.pause();
        if (next.object == nullptr) continue;
        if (is_a<pov::LightSource>(*next.object))
            add_light(next);
        else if (next.clips.empty() && is_sum_of_parts(*next.object))
            split(next, next.box, false);
        else
            add(next);
    }
    for (const pov::ImageData* image : images()) writer_.add(size_of(*image));
    if (looks_.drawable().too_large() > 0)
        writer_.leave_out({"image_map", "larger than 8 million texels", false},
                          looks_.drawable().too_large());
    writer_.finish();
}

void GeometryExport::add_light(const Waiting& light) {
    for (const pov::ObjectPtr looks_like : children(*light.object)) {
        writer_.leave_out({"light_source", "looks like something", false});
        const BoxFacts box = common_box(light.box, box_of(*looks_like));
        if (!Test_Flag(light.object, NO_IMAGE_FLAG))
            writer_.add_unknown(box);
        else
            writer_.add_unknown_in_mirrors(box);
    }
}

void GeometryExport::split(const Waiting& part, const BoxFacts& box, bool clipped) {
    CurvedPieces::Clips clips = part.clips;
    if (clipped) clips.insert(clips.end(), part.object->Clip.begin(), part.object->Clip.end());
    const std::vector<pov::ObjectPtr>& parts = children(*part.object);
    for (auto object = parts.rbegin(); object != parts.rend(); ++object)
        waiting_.push_back({*object, clips, box});
}

/// As polygons, or else in pieces, or else as unknown.
void GeometryExport::add(const Waiting& part) {
    const pov::ObjectBase& object = *part.object;
    const char* reason = !part.clips.empty()    ? "clipped"
                         : stands_alone(object) ? add_primitive(object)
                                                : add_compound(object);
    if (reason == nullptr) return;
    const BoxFacts box = common_box(part.box, box_of(object));
    // A bound that hides some of what it bounds does so depending on where the ray comes from.
    const bool hides = std::string_view(reason).rfind("bounded", 0) == 0;
    if (is_union(object) && !hides) {
        split(part, box, true);
        return;
    }
    const bool seen = !Test_Flag(&object, NO_IMAGE_FLAG);
    bool drawn = false;
    if (seen && !hides) {
        const char* other_reason = add_pieces(part, box);
        drawn = other_reason == nullptr;
        if (!drawn && std::string_view(other_reason) != no_closed_form) reason = other_reason;
    }
    if (seen && !drawn) writer_.add_unknown(box);
    if (!seen || (drawn && differs_in_mirrors(object))) writer_.add_unknown_in_mirrors(box);
    writer_.leave_out({object_kind(object), reason, drawn});
}

const char* GeometryExport::add_primitive(const pov::ObjectBase& object) {
    ObjectFaces faces;
    if (const char* reason = faces_of(object, limits(object), faces)) return reason;
    writer_.begin(faces);
    bool whole = true;
    for (const ObjectFaces::Face& face : faces.faces)
        if (too_long(faces, face)) {
            writer_.leave_out({object_kind(object), "too many corners", false});
            whole = false;
        } else {
            writer_.add(face, facts(object, object, face));
        }
    if (!whole) writer_.add_unknown(box_of(object));
    return nullptr;
}

const char* GeometryExport::add_compound(const pov::ObjectBase& object) {
    CompoundFaces compound(limits(object), around_.inside);
    if (const char* reason = compound.build(object)) return reason;
    // Pieces come leaf by leaf, and face by face.
    const SolidPiece* last = nullptr;
    for (const SolidPiece& piece : compound.pieces()) {
        const CompoundFaces::Primitive& primitive = compound.primitives()[piece.leaf];
        const ObjectFaces::Face& face = primitive.faces.faces[piece.face];
        if (last == nullptr || last->leaf != piece.leaf) writer_.begin(primitive.faces);
        const bool again = last != nullptr && last->leaf == piece.leaf && last->face == piece.face;
        last = &piece;
        PolygonFacts polygon = facts(*primitive.object, *primitive.flagged, face);
        if (!piece.whole)
            writer_.add(piece.corners, polygon);
        else if (!again)
            writer_.add(face, polygon);
    }
    return nullptr;
}

const char* GeometryExport::add_pieces(const Waiting& part, const BoxFacts& box) {
    CurvedPieces curved;
    if (const char* reason = curved.build(*part.object, part.clips)) return reason;
    if (curved.pieces().size() > max_pieces - std::min(max_pieces, writer_.pieces()) ||
        curved.numbers() > max_numbers - std::min(max_numbers, writer_.numbers()))
        return "too many pieces";
    std::vector<PieceFacts> pieces;
    for (const CurvedPieces::Piece& piece : curved.pieces()) {
        PieceFacts facts;
        facts.surface = around_.surfaces.identity(*piece.object, piece.number);
        facts.material = look_of(*piece.object, nullptr).material;
        pieces.push_back(facts);
    }
    writer_.add(curved, pieces, box);
    return nullptr;
}

/// Sends what is new along with it.
Look GeometryExport::look_of(const pov::ObjectBase& object,
                             const pov::Mesh_Triangle_Struct* triangle) {
    const Look look = looks_.of(object, triangle);
    for (const LookFacts& drawable : looks_.take_new()) writer_.add(drawable);
    return look;
}

PolygonFacts GeometryExport::facts(const pov::ObjectBase& object, const pov::ObjectBase& flagged,
                                   const ObjectFaces::Face& face) {
    const Look look = look_of(object, face.triangle);
    PolygonFacts facts;
    facts.surface = around_.surfaces.identity(object, face.number);
    facts.material = look.material;
    facts.smooth = face.smooth ? around_.surfaces.group(object) : 0;
    facts.mirror = face.smooth ? 0 : look.mirror;
    facts.transparent = look.transparent;
    facts.no_shadow = (flagged.Flags & NO_SHADOW_FLAG) != 0;
    facts.no_image = (flagged.Flags & NO_IMAGE_FLAG) != 0;
    facts.no_reflection = (flagged.Flags & NO_REFLECTION_FLAG) != 0;
    facts.double_illuminate = (object.Flags & DOUBLE_ILLUMINATE_FLAG) != 0;
    return facts;
}

FaceLimits GeometryExport::limits(const pov::ObjectBase& object) const {
    FaceLimits limits;
    limits.max_faces = max_polygons - std::min(max_polygons, writer_.polygons());
    limits.middle = around_.eye;
    limits.reach = MAX_DISTANCE;
    // What is left of planes that bound something finite is within it: the nearer the corners of
    // what is cut, the less rounding is there in the cuts.
    const auto& box = object.BBox;
    const Point low{box.Lower_Left[0], box.Lower_Left[1], box.Lower_Left[2]},
        size{box.Lengths[0], box.Lengths[1], box.Lengths[2]};
    if (!stands_alone(object) && length(size) < 0.01 * MAX_DISTANCE) {
        limits.middle = low + 0.5 * size;
        limits.reach = 2 * length(size);
    }
    return limits;
}

}  // namespace povpreview::tracer
