// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <unordered_map>
#include <vector>

// The order of POV-Ray's headers matters: frame.h first, povdebug.h last.
// clang-format off
#include "backend/frame.h"
// clang-format on

namespace pov {
struct Mesh_Triangle_Struct;
}

namespace povpreview::tracer {

/// Tells the faces of an object apart, as its class does: the side of a box, the part and segment
/// of a prism, the normal of a mesh's flat triangle. Zero where a class has no faces.
struct FaceNumber {
    int first = 0, second = 0;
};

/// All smooth triangles of a mesh together are one face.
FaceNumber face_number(const pov::Mesh_Triangle_Struct& triangle);

/// Gives every smooth piece of surface in a scene a number: objects are counted in the order of the
/// scene file, and those with creases (boxes, cylinders, prisms, flat meshes) have a number a face.
/// Numbers are the same in every run of the same scene.
class SurfaceIndex {
   public:
    /// Walks the objects and everything inside them.
    explicit SurfaceIndex(const std::vector<pov::ObjectPtr>& objects);

    /// The surface that was hit; never 0.
    std::uint32_t identity(const pov::Intersection& hit) const;
    /// The same for a face of an object; equals what a hit on it gives.
    std::uint32_t identity(const pov::ObjectBase& object, FaceNumber face) const;
    /// What the object's smooth faces belong to: a mesh or height field itself; or the union whose
    /// triangles and patches together look like one surface. POV-Ray dissolves most unions, so all
    /// triangles that are in none, and all patches, are taken as one. Never 0.
    std::uint32_t group(const pov::ObjectBase& object) const;

   private:
    /// Where POV-Ray writes down which face of an object was hit.
    enum class Faces : std::uint8_t { none, first, first_and_second, mesh };

    struct Entry {
        std::uint32_t number;
        Faces faces;
        std::uint32_t group;
    };

    void add(const pov::ObjectBase* object, std::uint32_t parent);
    Entry entry(const pov::ObjectBase& object) const;
    static FaceNumber face_hit(const pov::Intersection& hit, Faces faces);
    static std::uint32_t identity(const Entry& entry, FaceNumber face);

    std::unordered_map<const pov::ObjectBase*, Entry> entries_;
    std::uint32_t last_ = 0;
};

}  // namespace povpreview::tracer
