// SPDX-License-Identifier: AGPL-3.0-or-later
#include "adapter/geometry.h"

namespace povpreview {
namespace {

std::uint32_t size32(std::size_t size) { return static_cast<std::uint32_t>(size); }

}  // namespace

void Geometry::append(const Geometry& other) {
    const std::uint32_t first_point = size32(points.size()), first_corner = size32(corners.size()),
                        first_ring = size32(rings.size());
    points.insert(points.end(), other.points.begin(), other.points.end());
    for (const std::uint32_t corner : other.corners) corners.push_back(first_point + corner);
    for (const Ring& ring : other.rings) rings.push_back({first_corner + ring.first, ring.count});
    for (Polygon polygon : other.polygons) {
        polygon.first_ring += first_ring;
        polygons.push_back(polygon);
    }
    const auto add_all = [](auto& to, const auto& from) {
        to.insert(to.end(), from.begin(), from.end());
    };
    add_all(left_out, other.left_out);
    if (!corner_uvs.empty() || !other.corner_uvs.empty()) {
        corner_uvs.resize(first_corner);
        add_all(corner_uvs, other.corner_uvs);
        corner_uvs.resize(corners.size());
    }
    const std::uint32_t first_solid = size32(solids.size()), first_step = size32(conditions.size()),
                        first_piece = size32(pieces.size()), first_number = size32(numbers.size());
    for (Solid solid : other.solids) {
        solid.first_number += first_number;
        solids.push_back(solid);
    }
    add_all(numbers, other.numbers);
    for (const ConditionStep step : other.conditions)
        conditions.push_back(step < 0 ? step : step + static_cast<ConditionStep>(first_solid));
    for (CurvedPiece piece : other.pieces) {
        piece.solid += first_solid;
        piece.first_condition += first_step;
        pieces.push_back(piece);
    }
    for (CurvedObject object : other.objects) {
        object.first_piece += first_piece;
        objects.push_back(object);
    }
    add_all(unknown, other.unknown);
    add_all(unknown_in_mirrors, other.unknown_in_mirrors);
    add_all(looks, other.looks);
    add_all(images, other.images);
}

}  // namespace povpreview
