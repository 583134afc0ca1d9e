// SPDX-License-Identifier: AGPL-3.0-or-later
#include "backend/oracle/surface_index.h"

// The order of POV-Ray's headers matters: frame.h first, povdebug.h last.
// clang-format off
#include "backend/frame.h"
#include "backend/scene/objects.h"
#include "backend/shape/bezier.h"
#include "backend/shape/boxes.h"
#include "backend/shape/cones.h"
#include "backend/shape/csg.h"
#include "backend/shape/mesh.h"
#include "backend/shape/prism.h"
#include "backend/shape/sor.h"
#include "backend/shape/triangle.h"
// clang-format on

#include "backend/oracle/hash.h"
#include "backend/oracle/prism_parts.h"
#include "base/povdebug.h"

namespace povpreview::tracer {

/// Groups of what is part of no union; no object's number.
constexpr std::uint32_t loose_triangles = ~std::uint32_t{1}, loose_patches = ~std::uint32_t{2};

SurfaceIndex::SurfaceIndex(const std::vector<pov::ObjectPtr>& objects) {
    for (const pov::ObjectPtr object : objects) add(object, 0);
}

void SurfaceIndex::add(const pov::ObjectBase* object, std::uint32_t parent) {
    if (object == nullptr) return;
    const auto is = [object](auto* type) {
        return dynamic_cast<decltype(type)>(object) != nullptr;
    };
    std::uint32_t number = ++last_;
    Faces faces = Faces::none;
    if (is(static_cast<const pov::Box*>(nullptr)) || is(static_cast<const pov::Cone*>(nullptr)))
        faces = Faces::first;
    else if (is(static_cast<const pov::Sor*>(nullptr)))
        faces = Faces::first;  // base, cap or the curve; its pieces join smoothly
    else if (is(static_cast<const pov::Prism*>(nullptr)))
        faces = Faces::first_and_second;
    else if (is(static_cast<const pov::Mesh*>(nullptr)))
        faces = Faces::mesh;
    else if (is(static_cast<const pov::SmoothTriangle*>(nullptr)) && parent != 0)
        number = parent;  // one of many that together look smooth
    std::uint32_t group = number;
    if (is(static_cast<const pov::SmoothTriangle*>(nullptr)))
        group = parent != 0 ? parent : loose_triangles;
    else if (is(static_cast<const pov::BicubicPatch*>(nullptr)))
        group = parent != 0 ? parent : loose_patches;
    entries_.try_emplace(object, Entry{number, faces, group});
    if ((object->Type & IS_COMPOUND_OBJECT) != 0)
        for (const pov::ObjectPtr child : static_cast<const pov::CompoundObject*>(object)->children)
            add(child, number);
}

SurfaceIndex::Entry SurfaceIndex::entry(const pov::ObjectBase& object) const {
    const auto found = entries_.find(&object);
    if (found != entries_.end()) return found->second;
    // An object that is not in the scene's list is a surface all the same.
    return {~std::uint32_t{0} - static_cast<std::uint32_t>(object.Type), Faces::none,
            ~std::uint32_t{0}};
}

FaceNumber face_number(const pov::MESH_TRIANGLE& triangle) {
    return {triangle.Smooth ? 0 : static_cast<int>(triangle.Normal_Ind) + 1, 0};
}

FaceNumber SurfaceIndex::face_hit(const pov::Intersection& hit, Faces faces) {
    switch (faces) {
        case Faces::none:
            break;  // i1 is not set
        case Faces::first:
            return {hit.i1, 0};
        case Faces::first_and_second:
            return {hit.i1, hit.i1 == spline_hit ? hit.i2 : 0};
        case Faces::mesh:
            return face_number(*static_cast<const pov::MESH_TRIANGLE*>(hit.Pointer));
    }
    return {};
}

std::uint32_t SurfaceIndex::identity(const Entry& entry, FaceNumber face) {
    std::uint64_t hash = mix(0, entry.number);
    if (entry.faces != Faces::none)
        hash = mix(mix(hash, static_cast<std::uint64_t>(face.first)),
                   static_cast<std::uint64_t>(face.second));
    return fold(hash);
}

std::uint32_t SurfaceIndex::identity(const pov::Intersection& hit) const {
    const Entry found = entry(*hit.Object);
    return identity(found, face_hit(hit, found.faces));
}

std::uint32_t SurfaceIndex::identity(const pov::ObjectBase& object, FaceNumber face) const {
    return identity(entry(object), face);
}

std::uint32_t SurfaceIndex::group(const pov::ObjectBase& object) const {
    return entry(object).group;
}

}  // namespace povpreview::tracer
