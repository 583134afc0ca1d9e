// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>

#include "backend/oracle/compound_faces.h"
#include "backend/oracle/geometry_writer.h"
#include "backend/oracle/surface_index.h"
#include "backend/oracle/surface_looks.h"

namespace povpreview::tracer {

/// Sends the polygonal part of a scene: the faces of its objects in world space, and of the rest
/// how many of which kind were left out and why. Only reads the scene.
class GeometryExport {
   public:
    /// Polygons in all; objects that would exceed it are left out.
    static constexpr std::size_t max_polygons = 400000;

    struct Surroundings {
        const SurfaceIndex& surfaces;
        Point eye;
        CompoundFaces::Inside inside;
        std::function<void()> pause;  ///< called between objects; may throw to end it all
        std::function<void(const GeometryChunk&)> send;
    };

    explicit GeometryExport(Surroundings surroundings)
        : around_(std::move(surroundings)), writer_(around_.send) {}

    void run(const std::vector<pov::ObjectPtr>& objects);

   private:
    void add(const pov::ObjectBase& object);
    void add_primitive(const pov::ObjectBase& object);
    void add_compound(const pov::ObjectBase& object);
    PolygonFacts facts(const pov::ObjectBase& object, const pov::ObjectBase& flagged,
                       const ObjectFaces::Face& face);
    FaceLimits limits(const pov::ObjectBase& object) const;

    Surroundings around_;
    GeometryWriter writer_;
    SurfaceLooks looks_;
};

}  // namespace povpreview::tracer
