// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <deque>
#include <functional>

#include "backend/oracle/object_faces.h"
#include "backend/oracle/solids.h"

namespace povpreview::tracer {

/// An object as a solid made of its primitives: for everything that is not simply the sum of its
/// parts (intersections, differences, merges, and what is clipped or bounded).
class CompoundFaces {
   public:
    struct Primitive {
        const pov::ObjectBase* object;
        const pov::ObjectBase* flagged;  ///< whose flags say what sees it (no_shadow ...)
        ObjectFaces faces;
    };
    /// Whether a point is inside of an object, as POV-Ray says.
    using Inside = std::function<bool(const Point&, const pov::ObjectBase&)>;

    CompoundFaces(const FaceLimits& limits, Inside inside)
        : limits_(limits), inside_(std::move(inside)) {}

    /// Returns null, or why the object cannot be resolved to faces.
    const char* build(const pov::ObjectBase& object);

    const std::deque<Primitive>& primitives() const { return primitives_; }
    /// SolidPiece::leaf is the primitive's number, SolidPiece::face that of its face.
    const std::vector<SolidPiece>& pieces() const { return pieces_; }

   private:
    const char* add(const pov::ObjectBase& object, const pov::ObjectBase* flagged, Solid& solid);
    const char* add_clips(const pov::ObjectBase& object, Solid& solid);
    const char* add_primitive(const pov::ObjectBase& object, const pov::ObjectBase& flagged,
                              Solid& solid);
    const char* check_bound(const pov::ObjectBase& object, const Solid& solid,
                            std::size_t first_primitive) const;
    bool bounds_hold(const pov::ObjectBase& object, const std::vector<Point>& points) const;

    FaceLimits limits_;
    Inside inside_;
    std::deque<Primitive> primitives_;
    std::vector<SolidPiece> pieces_;
    bool cut_by_others_ = false;  ///< what is being added is part of an intersection or merge
};

}  // namespace povpreview::tracer
