// SPDX-License-Identifier: AGPL-3.0-or-later
#include "backend/oracle/surface_index.h"

// The order of POV-Ray's headers matters: frame.h first, povdebug.h last.
// clang-format off
#include "backend/frame.h"
#include "backend/scene/objects.h"
#include "backend/shape/boxes.h"
#include "backend/shape/cones.h"
#include "backend/shape/csg.h"
#include "backend/shape/mesh.h"
#include "backend/shape/prism.h"
#include "backend/shape/sor.h"
#include "backend/shape/triangle.h"
// clang-format on

#include "backend/oracle/hash.h"
#include "base/povdebug.h"

namespace povpreview::tracer {

/// Intersection::i1 of a hit on a prism's side; as in POV-Ray's shape/prism.cpp.
constexpr int spline_hit = 3;

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
    entries_.try_emplace(object, Entry{number, faces});
    if ((object->Type & IS_COMPOUND_OBJECT) != 0)
        for (const pov::ObjectPtr child : static_cast<const pov::CompoundObject*>(object)->children)
            add(child, number);
}

std::uint32_t SurfaceIndex::identity(const pov::Intersection& hit) const {
    const auto found = entries_.find(hit.Object);
    // An object that is not in the scene's list is a surface all the same.
    if (found == entries_.end()) return fold(mix(~std::uint64_t{0}, hit.Object->Type));
    const Entry& entry = found->second;
    std::uint64_t hash = mix(0, entry.number);
    switch (entry.faces) {
        case Faces::none:
            break;
        case Faces::first:
            hash = mix(hash, static_cast<std::uint64_t>(hit.i1));
            break;
        case Faces::first_and_second:
            hash = mix(mix(hash, static_cast<std::uint64_t>(hit.i1)),
                       hit.i1 == spline_hit ? static_cast<std::uint64_t>(hit.i2) : 0);
            break;
        case Faces::mesh: {
            const auto* triangle = static_cast<const pov::MESH_TRIANGLE*>(hit.Pointer);
            if (!triangle->Smooth)
                hash = mix(hash, static_cast<std::uint64_t>(triangle->Normal_Ind) + 1);
            break;
        }
    }
    return fold(hash);
}

}  // namespace povpreview::tracer
