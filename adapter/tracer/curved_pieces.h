// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "backend/oracle/closed_forms.h"

namespace povpreview::tracer {

/// An object with curved surfaces as pieces of surfaces of solids, each with the condition under
/// which POV-Ray shows a point of it (csg.cpp, objects.cpp):
///
///     intersection    of each child's surface what is inside all others
///     merge           of each child's surface what is inside no other
///     union           all of each child's surface
///     clipped_by      of any surface what is inside all clips
class CurvedPieces {
   public:
    using Clips = std::vector<pov::ObjectPtr>;
    struct Piece {
        const pov::ObjectBase* object;  ///< the primitive that it belongs to
        FaceNumber number;
        std::uint32_t solid = 0;
        Condition where;
    };

    /// Returns null, or why the object cannot be had in closed form. `clips` are those of what the
    /// object is part of. Bounds are taken to hold all that they bound.
    const char* build(const pov::ObjectBase& object, const Clips& clips);

    const std::vector<ClosedSolid>& solids() const { return solids_; }
    /// That its solids have in all.
    std::size_t numbers() const;
    /// None of them is nowhere.
    const std::vector<Piece>& pieces() const { return pieces_; }

   private:
    /// Of one object, with what clips it: what shows of it, and its inside.
    struct Part {
        std::vector<Piece> pieces;
        Condition inside = Condition::nowhere();
    };

    const char* add(const pov::ObjectBase& object, int depth, Part& part);
    const char* add_primitive(const pov::ObjectBase& object, Part& part);
    const char* add_compound(const pov::ObjectBase& object, int depth, Part& part);
    const char* clip(const Clips& clips, int depth, Part& part);

    std::vector<ClosedSolid> solids_;
    std::vector<Piece> pieces_;
    bool cut_by_others_ = false;  ///< what is being added is part of an intersection or merge
};

}  // namespace povpreview::tracer
