// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>

#include "backend/oracle/compound_faces.h"
#include "backend/oracle/geometry_writer.h"
#include "backend/oracle/surface_index.h"
#include "backend/oracle/surface_looks.h"

namespace povpreview::tracer {

/// Sends what can be drawn of a scene without tracing, in world space: the faces of its polygonal
/// objects, those curved ones that have closed forms in pieces, and of the rest boxes around them.
/// Only reads the scene.
class GeometryExport {
   public:
    /// Polygons in all, pieces, and numbers of their solids; objects that would exceed it are left
    /// out.
    static constexpr std::size_t max_polygons = 400000, max_pieces = 400000, max_numbers = 2000000;

    struct Surroundings {
        const SurfaceIndex& surfaces;
        const LinearLight& linear;
        Point eye;
        CompoundFaces::Inside inside;
        std::function<void()> pause;  ///< called between objects; may throw to end it all
        std::function<void(const GeometryChunk&)> send;
    };

    explicit GeometryExport(Surroundings surroundings)
        : around_(std::move(surroundings)), writer_(around_.send), looks_(around_.linear) {}

    void run(const std::vector<pov::ObjectPtr>& objects);
    /// Of the looks that were sent, by number; whose texels are to follow.
    const std::vector<const pov::ImageData*>& images() { return looks_.drawable().images(); }

   private:
    /// An object that is still to be added, and what it is part of says of it.
    struct Waiting {
        const pov::ObjectBase* object;
        CurvedPieces::Clips clips;
        BoxFacts box;
    };
    void add(const Waiting& part);
    void add_light(const Waiting& light);
    const char* add_primitive(const pov::ObjectBase& object);
    const char* add_compound(const pov::ObjectBase& object);
    const char* add_pieces(const Waiting& part, const BoxFacts& box);
    void split(const Waiting& part, const BoxFacts& box, bool clipped);
    Look look_of(const pov::ObjectBase& object, const pov::Mesh_Triangle_Struct* triangle);
    PolygonFacts facts(const pov::ObjectBase& object, const pov::ObjectBase& flagged,
                       const ObjectFaces::Face& face);
    FaceLimits limits(const pov::ObjectBase& object) const;

    Surroundings around_;
    std::vector<Waiting> waiting_;  ///< a stack: unions nest as deep as people like
    GeometryWriter writer_;
    SurfaceLooks looks_;
};

}  // namespace povpreview::tracer
