// SPDX-License-Identifier: AGPL-3.0-or-later
#include "backend/oracle/geometry_export.h"

#include <algorithm>

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

/// A union shows what its parts show.
bool is_sum_of_parts(const pov::ObjectBase& object) {
    return is_a<pov::CSGUnion>(object) && !is_a<pov::CSGMerge>(object) && object.Clip.empty() &&
           object.Bound.empty();
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
    // A stack of our own: unions nest as deep as people like.
    std::vector<const pov::ObjectBase*> waiting(objects.rbegin(), objects.rend());
    while (!waiting.empty()) {
        const pov::ObjectBase* object = waiting.back();
        waiting.pop_back();
        around_.pause();
        if (object == nullptr) continue;
        if (is_sum_of_parts(*object))
            waiting.insert(waiting.end(), children(*object).rbegin(), children(*object).rend());
        else
            add(*object);
    }
    writer_.finish();
}

void GeometryExport::add(const pov::ObjectBase& object) {
    if (is_a<pov::LightSource>(object)) {
        if (!children(object).empty()) writer_.leave_out("light_source", "looks like something");
    } else if (stands_alone(object)) {
        add_primitive(object);
    } else {
        add_compound(object);
    }
}

void GeometryExport::add_primitive(const pov::ObjectBase& object) {
    ObjectFaces faces;
    if (const char* reason = faces_of(object, limits(object), faces)) {
        writer_.leave_out(object_kind(object), reason);
        return;
    }
    writer_.begin(faces);
    for (const ObjectFaces::Face& face : faces.faces)
        if (too_long(faces, face))
            writer_.leave_out(object_kind(object), "too many corners");
        else
            writer_.add(face, facts(object, object, face));
}

void GeometryExport::add_compound(const pov::ObjectBase& object) {
    CompoundFaces compound(limits(object), around_.inside);
    if (const char* reason = compound.build(object)) {
        writer_.leave_out(object_kind(object), reason);
        return;
    }
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
}

PolygonFacts GeometryExport::facts(const pov::ObjectBase& object, const pov::ObjectBase& flagged,
                                   const ObjectFaces::Face& face) {
    const Look look = looks_.of(object, face.triangle);
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
