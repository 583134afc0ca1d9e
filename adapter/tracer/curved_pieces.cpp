// SPDX-License-Identifier: AGPL-3.0-or-later
#include "backend/oracle/curved_pieces.h"

#include <algorithm>
#include <utility>

// The order of POV-Ray's headers matters: frame.h first, povdebug.h last.
// clang-format off
#include "backend/frame.h"
#include "backend/scene/objects.h"
#include "backend/lighting/point.h"
#include "backend/shape/csg.h"
#include "backend/shape/discs.h"
// clang-format on

#include "base/povdebug.h"

namespace povpreview::tracer {

namespace {

/// Solids and pieces of one object: each pixel before it may look at all of them.
constexpr std::size_t max_solids = 2000, max_pieces = 1000;
/// Objects within objects.
constexpr int max_nesting = 64;

template <typename Class>
bool is_a(const pov::ObjectBase& object) {
    return dynamic_cast<const Class*>(&object) != nullptr;
}

const std::vector<pov::ObjectPtr>& children(const pov::ObjectBase& object) {
    return static_cast<const pov::CompoundObject&>(object).children;
}

/// Restricts pieces to where a condition holds; those of which nothing remains go.
void restrict_to(const Condition& where, std::vector<CurvedPieces::Piece>& pieces) {
    for (CurvedPieces::Piece& piece : pieces) piece.where = piece.where & where;
    pieces.erase(std::remove_if(pieces.begin(), pieces.end(),
                                [](const auto& piece) { return piece.where.is_nowhere(); }),
                 pieces.end());
}

}  // namespace

const char* CurvedPieces::build(const pov::ObjectBase& object, const Clips& clips) {
    Part part;
    if (const char* reason = add(object, 0, part)) return reason;
    if (const char* reason = clip(clips, 0, part)) return reason;
    for (const Piece& piece : part.pieces)
        if (piece.where.too_long()) return "too long a condition";
    pieces_ = std::move(part.pieces);
    return nullptr;
}

std::size_t CurvedPieces::numbers() const {
    std::size_t sum = 0;
    for (const ClosedSolid& solid : solids_) sum += solid.numbers.size();
    return sum;
}

const char* CurvedPieces::add(const pov::ObjectBase& object, int depth, Part& part) {
    if (depth > max_nesting) return "nested too deep";
    const char* reason =
        is_a<pov::CSG>(object) ? add_compound(object, depth, part) : add_primitive(object, part);
    if (reason != nullptr) return reason;
    if (solids_.size() > max_solids || part.pieces.size() > max_pieces) return "too many parts";
    return clip(object.Clip, depth, part);
}

const char* CurvedPieces::add_primitive(const pov::ObjectBase& object, Part& part) {
    // POV-Ray shows what is cut by it as far as rays meet a box around the disc itself.
    if (cut_by_others_ && is_a<pov::Disc>(object))
        return "has a disc, whose inside is half of space";
    ClosedForm form;
    if (const char* reason = closed_form(object, solids_, form)) return reason;
    for (const ClosedForm::Side& side : form.sides)
        part.pieces.push_back({&object, side.number, side.solid, side.where});
    part.inside = form.inside;
    return nullptr;
}

const char* CurvedPieces::add_compound(const pov::ObjectBase& object, int depth, Part& part) {
    const bool intersection = is_a<pov::CSGIntersection>(object),
               merge = is_a<pov::CSGMerge>(object);
    const bool cut = cut_by_others_;
    cut_by_others_ = cut || intersection || merge;
    std::vector<Part> parts;
    for (const pov::ObjectPtr child : children(object)) {
        if (is_a<pov::LightSource>(*child)) {
            if (!children(*child).empty()) return "has a light that looks like something";
            continue;
        }
        // To the eye a merge is without such parts (All_CSG_Merge_Intersections), but not its
        // inside; intersections and unions look at the flag for rays of other kinds only.
        if (merge && Test_Flag(child, NO_IMAGE_FLAG)) return "has a part that is not seen";
        parts.emplace_back();
        if (const char* reason = add(*child, depth + 1, parts.back())) return reason;
    }
    cut_by_others_ = cut;
    part.inside = intersection ? Condition::everywhere() : Condition::nowhere();
    for (std::size_t i = 0; i < parts.size(); ++i) {
        for (std::size_t j = 0; j < parts.size() && (intersection || merge); ++j)
            if (j != i) restrict_to(merge ? !parts[j].inside : parts[j].inside, parts[i].pieces);
        part.pieces.insert(part.pieces.end(), parts[i].pieces.begin(), parts[i].pieces.end());
        part.inside = intersection ? part.inside & parts[i].inside : part.inside | parts[i].inside;
    }
    return nullptr;
}

const char* CurvedPieces::clip(const Clips& clips, int depth, Part& part) {
    // What clips does not show itself, whatever it is that it is made of.
    const bool cut = std::exchange(cut_by_others_, true);
    for (const pov::ObjectPtr object : clips) {
        Part inside;
        if (const char* reason = add(*object, depth + 1, inside)) return reason;
        restrict_to(inside.inside, part.pieces);
        part.inside = part.inside & inside.inside;
    }
    cut_by_others_ = cut;
    return nullptr;
}

}  // namespace povpreview::tracer
