// SPDX-License-Identifier: AGPL-3.0-or-later
#include "backend/oracle/geometry_writer.h"

#include <utility>

namespace povpreview::tracer {

void GeometryWriter::begin(const ObjectFaces& object) {
    object_ = &object;
    index_of_.assign(object.points.size(), 0);
    indexed_.clear();
}

void GeometryWriter::add(const ObjectFaces::Face& face, PolygonFacts facts) {
    send_if_full();
    facts.rings = face.rings;
    facts.convex = face.convex;
    for (std::uint32_t r = face.first_ring; r < face.first_ring + face.rings; ++r) {
        const ObjectFaces::Ring& ring = object_->rings[r];
        chunk_.rings.push_back(ring.count);
        for (std::uint32_t i = ring.first; i < ring.first + ring.count; ++i) {
            const std::uint32_t point = object_->corners[i];
            if (index_of_[point] == 0) {
                chunk_.points.push_back(object_->points[point]);
                index_of_[point] = static_cast<std::uint32_t>(chunk_.points.size());
                indexed_.push_back(point);
            }
            chunk_.corners.push_back(index_of_[point] - 1);
        }
        add_uvs(ring);
    }
    add_polygon(facts);
}

void GeometryWriter::add(const ConvexPolygon& polygon, PolygonFacts facts) {
    send_if_full();
    facts.rings = 1;
    facts.convex = true;
    chunk_.rings.push_back(static_cast<std::uint32_t>(polygon.size()));
    for (const Point& corner : polygon) {
        chunk_.corners.push_back(static_cast<std::uint32_t>(chunk_.points.size()));
        chunk_.points.push_back(corner);
    }
    add_polygon(facts);
}

void GeometryWriter::add_polygon(const PolygonFacts& facts) {
    chunk_.polygons.push_back(facts);
    ++polygons_;
}

/// Corners without coordinates of their own have zeros where others have some.
void GeometryWriter::add_uvs(const ObjectFaces::Ring& ring) {
    if (object_->uvs.empty()) return;
    chunk_.corner_uvs.resize(chunk_.corners.size() - ring.count);
    const auto first = object_->uvs.begin() + ring.first;
    chunk_.corner_uvs.insert(chunk_.corner_uvs.end(), first, first + ring.count);
}

void GeometryWriter::add(const CurvedPieces& object, const std::vector<PieceFacts>& facts,
                         const BoxFacts& bounds) {
    send_if_full();
    const auto first_solid = static_cast<std::uint32_t>(chunk_.solids.size());
    chunk_.solids.insert(chunk_.solids.end(), object.solids().begin(), object.solids().end());
    chunk_numbers_ += object.numbers();
    for (std::size_t i = 0; i < object.pieces().size(); ++i) {
        const CurvedPieces::Piece& piece = object.pieces()[i];
        for (const std::int32_t step : piece.where.steps())
            chunk_.steps.push_back(step < 0 ? step : step + static_cast<std::int32_t>(first_solid));
        PieceFacts complete = facts[i];
        complete.solid = first_solid + piece.solid;
        complete.steps = static_cast<std::uint32_t>(piece.where.steps().size());
        chunk_.pieces.push_back(complete);
    }
    pieces_ += object.pieces().size();
    numbers_ += object.numbers();
    chunk_.objects.push_back({bounds, static_cast<std::uint32_t>(object.pieces().size())});
}

void GeometryWriter::send_if_full() {
    if (chunk_.points.size() < chunk_size && chunk_.corners.size() < chunk_size &&
        chunk_.solids.size() < chunk_solids && chunk_.steps.size() < 4 * chunk_size &&
        chunk_.pieces.size() < chunk_size && chunk_.unknown.size() < chunk_size &&
        chunk_.unknown_in_mirrors.size() < chunk_size && chunk_numbers_ < 4 * chunk_size)
        return;
    if (!chunk_.corner_uvs.empty()) chunk_.corner_uvs.resize(chunk_.corners.size());
    const auto left_out = std::exchange(chunk_.left_out, {});  // goes with the last chunk
    send_(chunk_);
    chunk_ = {};
    chunk_numbers_ = 0;
    chunk_.left_out = left_out;
    for (const std::uint32_t point : indexed_) index_of_[point] = 0;
    indexed_.clear();
}

void GeometryWriter::finish() {
    if (!chunk_.corner_uvs.empty()) chunk_.corner_uvs.resize(chunk_.corners.size());
    chunk_.last = true;
    send_(chunk_);
}

}  // namespace povpreview::tracer
