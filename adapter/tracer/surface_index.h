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

namespace povpreview::tracer {

/// Gives every smooth piece of surface in a scene a number: objects are counted in the order of the
/// scene file, and those with creases (boxes, cylinders, prisms, flat meshes) have a number a face.
/// Numbers are the same in every run of the same scene.
class SurfaceIndex {
   public:
    /// Walks the objects and everything inside them.
    explicit SurfaceIndex(const std::vector<pov::ObjectPtr>& objects);

    /// The surface that was hit; never 0.
    std::uint32_t identity(const pov::Intersection& hit) const;

   private:
    /// Where POV-Ray writes down which face of an object was hit.
    enum class Faces : std::uint8_t { none, first, first_and_second, mesh };

    struct Entry {
        std::uint32_t number;
        Faces faces;
    };

    void add(const pov::ObjectBase* object, std::uint32_t parent);

    std::unordered_map<const pov::ObjectBase*, Entry> entries_;
    std::uint32_t last_ = 0;
};

}  // namespace povpreview::tracer
