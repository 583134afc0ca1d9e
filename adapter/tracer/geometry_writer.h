// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>

#include "backend/oracle/geometry_facts.h"
#include "backend/oracle/object_faces.h"

namespace povpreview::tracer {

/// Collects polygons into chunks, each small enough not to delay the answers that are sent between
/// them, and hands on those that are full.
class GeometryWriter {
   public:
    /// A polygon of more corners is not sent.
    static constexpr std::size_t max_corners = 20000;

    explicit GeometryWriter(std::function<void(const GeometryChunk&)> send)
        : send_(std::move(send)) {}

    /// What the next faces belong to; forgets the points of the last object.
    void begin(const ObjectFaces& object);
    /// A face of that object. `facts` lacks what the face itself says.
    void add(const ObjectFaces::Face& face, PolygonFacts facts);
    /// A convex polygon.
    void add(const ConvexPolygon& polygon, PolygonFacts facts);
    void leave_out(const std::string& kind, const std::string& reason);
    /// Sends what is left.
    void finish();

    std::size_t polygons() const { return polygons_; }

   private:
    /// Of points or corners in a chunk; about half a megabyte.
    static constexpr std::size_t chunk_size = 16384;

    void send_if_full();
    void add_polygon(const PolygonFacts& facts);

    std::function<void(const GeometryChunk&)> send_;
    GeometryChunk chunk_;
    const ObjectFaces* object_ = nullptr;
    std::vector<std::uint32_t> index_of_;  ///< in the chunk, by point of the object; plus 1, or 0
    std::vector<std::uint32_t> indexed_;   ///< points of the object that have an index
    std::size_t polygons_ = 0;
};

}  // namespace povpreview::tracer
