// SPDX-License-Identifier: AGPL-3.0-or-later
#include "backend/oracle/solids.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace povpreview::tracer {

namespace {

/// A piece of surface to be judged from just behind it and from just in front of it; it lies wholly
/// inside or wholly outside of every cell that matters, or on its border.
///
///        in front      normal
///     ------ piece ------|------
///         behind
struct Spot {
    explicit Spot(const ConvexPolygon& polygon)
        : corners(polygon), inner(inner_point(polygon)), plane(plane_of(polygon)) {}
    const ConvexPolygon& corners;
    Point inner;
    Plane plane;
};
constexpr std::array<bool, 2> behind_and_in_front{false, true};

bool lies_on(const Spot& spot, const Plane& plane, double distance) {
    return std::fabs(distance) <= 4 * plane.tolerance(spot.inner) &&
           side_of(spot.corners, plane) == Side::on;
}

bool inside(const ConvexCell& cell, const Spot& spot, bool in_front) {
    if (cell.extent.apart(spot.inner)) return false;
    for (const Plane& plane : cell.planes) {
        const double distance = plane.distance(spot.inner);
        if (lies_on(spot, plane, distance)) {
            const bool alike = dot(plane.normal, spot.plane.normal) > 0;
            if (alike == in_front) return false;
        } else if (distance >= 0) {
            return false;
        }
    }
    return true;
}

bool inside(const Leaf& leaf, const Spot& spot, bool in_front) {
    if (leaf.cells.empty()) return false;
    const bool in_cells =
        std::any_of(leaf.cells.begin(), leaf.cells.end(),
                    [&](const ConvexCell& cell) { return inside(cell, spot, in_front); });
    return in_cells != leaf.inverted;
}

bool inside(const Solid& solid, const Spot& spot, bool in_front) {
    const auto in = [&](const Solid& part) { return inside(part, spot, in_front); };
    if (!std::all_of(solid.clips.begin(), solid.clips.end(), in)) return false;
    switch (solid.kind) {
        case Solid::Kind::leaf:
            return inside(solid.leaf, spot, in_front);
        case Solid::Kind::intersect:
            return std::all_of(solid.parts.begin(), solid.parts.end(), in);
        case Solid::Kind::unite:
        case Solid::Kind::merge:
            return std::any_of(solid.parts.begin(), solid.parts.end(), in);
    }
    return false;
}

/// The way from the root to a leaf: each solid on it, with the part of it that comes next.
struct Path {
    struct Step {
        const Solid* solid;
        const Solid* next;
    };
    std::vector<Step> steps;
    const Solid* leaf = nullptr;
};

void collect_paths(const Solid& solid, std::vector<Path::Step>& steps, std::vector<Path>& paths) {
    if (solid.kind == Solid::Kind::leaf) {
        paths.push_back({steps, &solid});
        return;
    }
    for (const Solid& part : solid.parts) {
        steps.push_back({&solid, &part});
        collect_paths(part, steps, paths);
        steps.pop_back();
    }
}

/// On which side of the spot a solid is inside; what cannot be crossed from outside to inside (a
/// patch, a box without thickness) is taken as shown from both sides.
struct Sides {
    std::array<bool, 2> in{};
    bool patch = false;

    bool accept(std::size_t side) const { return patch || in[side]; }
};

bool all_inside_somewhere(const std::vector<Solid>& solids, const Spot& spot) {
    return std::any_of(behind_and_in_front.begin(), behind_and_in_front.end(), [&](bool in_front) {
        return std::all_of(solids.begin(), solids.end(),
                           [&](const Solid& s) { return inside(s, spot, in_front); });
    });
}

/// Whether the surface of `below`, one of the parts of `solid`, is surface of `solid` at the spot.
bool passes(const Solid& solid, const Solid* below, const Sides& sides, const Spot& spot) {
    const auto others = [&](auto&& predicate) {
        return std::all_of(solid.parts.begin(), solid.parts.end(),
                           [&](const Solid& part) { return &part == below || predicate(part); });
    };
    if (solid.kind == Solid::Kind::unite) return true;
    const bool border = sides.in[0] != sides.in[1];
    for (std::size_t side = 0; side < 2; ++side) {
        const bool in_front = behind_and_in_front[side];
        if (solid.kind == Solid::Kind::intersect) {
            if (sides.accept(side) &&
                others([&](const Solid& part) { return inside(part, spot, in_front); }))
                return true;
        } else if (!(border && sides.in[side])) {
            if (others([&](const Solid& part) { return !inside(part, spot, in_front); }))
                return true;
        }
    }
    return false;
}

/// Whether a piece of the surface of a leaf is surface of the whole.
bool is_shown(const Path& path, const Spot& spot) {
    Sides sides;
    const auto look = [&](const auto& solid) {
        for (std::size_t side = 0; side < 2; ++side)
            sides.in[side] = inside(solid, spot, behind_and_in_front[side]);
    };
    look(path.leaf->leaf);
    sides.patch = !sides.in[0] && !sides.in[1];
    if (!all_inside_somewhere(path.leaf->clips, spot)) return false;
    look(*path.leaf);
    for (auto step = path.steps.rbegin(); step != path.steps.rend(); ++step) {
        if (!passes(*step->solid, step->next, sides, spot)) return false;
        if (!all_inside_somewhere(step->solid->clips, spot)) return false;
        look(*step->solid);
    }
    return true;
}

/// Another leaf that decides about a leaf's surface; with its path unless it only clips.
struct Cutter {
    const Leaf* leaf;
    const Path* path;
};

using PathOf = std::map<const Solid*, const Path*>;

void collect_cutters(const Solid& solid, const PathOf& path_of, std::vector<Cutter>& cutters) {
    if (solid.kind == Solid::Kind::leaf) {
        const auto found = path_of.find(&solid);
        cutters.push_back({&solid.leaf, found == path_of.end() ? nullptr : found->second});
    }
    for (const Solid& part : solid.parts) collect_cutters(part, path_of, cutters);
    for (const Solid& clip : solid.clips) collect_cutters(clip, path_of, cutters);
}

std::vector<Cutter> cutters_of(const Path& path, const PathOf& path_of) {
    std::vector<Cutter> cutters;
    const auto add_clips = [&](const Solid& solid) {
        for (const Solid& clip : solid.clips) collect_cutters(clip, path_of, cutters);
    };
    add_clips(*path.leaf);
    for (const Path::Step& step : path.steps) {
        add_clips(*step.solid);
        if (step.solid->kind == Solid::Kind::unite) continue;
        for (const Solid& part : step.solid->parts)
            if (&part != step.next) collect_cutters(part, path_of, cutters);
    }
    return cutters;
}

/// Cuts away what is outside a cell, plane by plane, so that no more pieces come about than needed:
///
///     +-----------+      +--+--+-----+
///     |  +-----+  |      |  |  1  |  |
///     |  | cell|  |  ->  |  +-----+  |
///     |  +-----+  |      |0 | in  | 2|
///     +-----------+      +--+-----+--+
///
void cut_by(const ConvexCell& cell, const ConvexPolygon& polygon,
            std::vector<ConvexPolygon>& pieces) {
    std::vector<ConvexPolygon> outside;
    ConvexPolygon rest = polygon;
    for (const Plane& plane : cell.planes) {
        const Side side = side_of(rest, plane);
        if (side == Side::in_front) {
            pieces.push_back(polygon);  // does not reach into the cell
            return;
        }
        if (side != Side::both) continue;
        Halves halves = cut(rest, plane);
        outside.push_back(std::move(halves.in_front));
        rest = std::move(halves.behind);
    }
    pieces.insert(pieces.end(), outside.begin(), outside.end());
    pieces.push_back(std::move(rest));
}

std::vector<ConvexPolygon> cut_by_all(const std::vector<Cutter>& cutters,
                                      const ConvexPolygon& face) {
    const Extent extent = Extent::around(face);
    std::vector<ConvexPolygon> pieces{face};
    for (const Cutter& cutter : cutters)
        for (const ConvexCell& cell : cutter.leaf->cells) {
            if (cell.extent.apart(extent)) continue;
            std::vector<ConvexPolygon> cut;
            for (const ConvexPolygon& piece : pieces) cut_by(cell, piece, cut);
            pieces = std::move(cut);
        }
    return pieces;
}

bool covers(const ConvexPolygon& face, const Spot& spot) {
    if (Extent::around(face).apart(spot.inner) || side_of(face, spot.plane) != Side::on)
        return false;
    const Point normal = area_normal(face);
    for (std::size_t i = 0; i < face.size(); ++i) {
        const Point &a = face[i], &b = face[(i + 1) % face.size()];
        if (dot(cross(b - a, spot.inner - a), normal) < 0) return false;
    }
    return true;
}

/// Whether an earlier leaf shows the same piece of surface.
bool is_shown_before(const Path& path, const std::vector<Cutter>& cutters, const Spot& spot) {
    return std::any_of(cutters.begin(), cutters.end(), [&](const Cutter& cutter) {
        return cutter.path != nullptr && cutter.path < &path &&
               std::any_of(cutter.leaf->faces.begin(), cutter.leaf->faces.end(),
                           [&](const SolidFace& face) { return covers(face.corners, spot); }) &&
               is_shown(*cutter.path, spot);
    });
}

}  // namespace

bool resolve(const Solid& root, std::size_t max_pieces, std::vector<SolidPiece>& pieces) {
    std::vector<Path> paths;
    std::vector<Path::Step> steps;
    collect_paths(root, steps, paths);
    PathOf path_of;
    for (const Path& path : paths) path_of[path.leaf] = &path;

    for (const Path& path : paths) {
        const std::vector<Cutter> cutters = cutters_of(path, path_of);
        const std::size_t first = pieces.size();
        std::vector<std::uint32_t> damaged;
        for (const SolidFace& face : path.leaf->leaf.faces) {
            if (length(area_normal(face.corners)) == 0) continue;
            for (ConvexPolygon& piece : cut_by_all(cutters, face.corners)) {
                const Spot spot(piece);
                if (piece.size() < 3 || spot.plane.normal == Point{}) continue;
                if (is_shown(path, spot) && !is_shown_before(path, cutters, spot))
                    pieces.push_back({path.leaf->number, face.face, true, std::move(piece)});
                else
                    damaged.push_back(face.face);
            }
            if (pieces.size() > max_pieces) return false;
        }
        std::sort(damaged.begin(), damaged.end());
        for (std::size_t i = first; i < pieces.size(); ++i)
            pieces[i].whole = !std::binary_search(damaged.begin(), damaged.end(), pieces[i].face);
    }
    return true;
}

bool is_inside(const Solid& solid, const Point& point) {
    const ConvexPolygon nowhere{point};
    return inside(solid, Spot(nowhere), false);
}

}  // namespace povpreview::tracer
