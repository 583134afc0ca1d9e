// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>

#include "backend/oracle/curved_pieces.h"
#include "backend/oracle/geometry_facts.h"
#include "backend/oracle/object_faces.h"

namespace povpreview::tracer {

/// Collects what can be drawn into chunks, each small enough not to delay the answers that are sent
/// between them, and hands on those that are full.
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
    /// An object in pieces; `facts`, one a piece, lack what the pieces themselves say.
    void add(const CurvedPieces& object, const std::vector<PieceFacts>& facts,
             const BoxFacts& bounds);
    void add(const LookFacts& look) { chunk_.looks.push_back(look); }
    /// There is something in the box of which nothing more is known.
    void add_unknown(const BoxFacts& box) { chunk_.unknown.push_back(box); }
    /// Mirrors do not show what is in the box as the eye sees it.
    void add_unknown_in_mirrors(const BoxFacts& box) { chunk_.unknown_in_mirrors.push_back(box); }
    void add(const ImageSize& image) { chunk_.images.push_back(image); }
    void leave_out(const LeftOutFacts& object, unsigned count = 1) {
        chunk_.left_out[object] += count;
    }
    /// Sends what is left.
    void finish();

    std::size_t polygons() const { return polygons_; }
    std::size_t pieces() const { return pieces_; }
    std::size_t numbers() const { return numbers_; }  ///< of solids

   private:
    /// Of points, corners or whatever there is most of in a chunk; about half a megabyte.
    static constexpr std::size_t chunk_size = 16384;
    /// Of solids, which are larger.
    static constexpr std::size_t chunk_solids = 4096;

    void send_if_full();
    void add_polygon(const PolygonFacts& facts);
    void add_uvs(const ObjectFaces::Ring& ring);

    std::function<void(const GeometryChunk&)> send_;
    GeometryChunk chunk_;
    std::size_t chunk_numbers_ = 0;  ///< of its solids
    const ObjectFaces* object_ = nullptr;
    std::vector<std::uint32_t> index_of_;  ///< in the chunk, by point of the object; plus 1, or 0
    std::vector<std::uint32_t> indexed_;   ///< points of the object that have an index
    std::size_t polygons_ = 0, pieces_ = 0, numbers_ = 0;
};

}  // namespace povpreview::tracer
