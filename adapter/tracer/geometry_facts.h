// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "backend/oracle/point.h"

namespace povpreview::tracer {

/// As wire::Polygon, but for its rings.
struct PolygonFacts {
    std::uint32_t surface = 0, material = 0, smooth = 0;
    float mirror = 0;
    bool transparent = false, no_shadow = false, no_image = false, no_reflection = false,
         double_illuminate = false, convex = false;
    std::uint32_t rings = 0;
};

/// Part of a scene's polygons, complete in itself; as wire::Geometry.
struct GeometryChunk {
    std::vector<Point> points;
    std::vector<std::uint32_t> corners;  ///< indices into `points`, ring by ring
    std::vector<std::uint32_t> rings;    ///< how many corners each has
    std::vector<PolygonFacts> polygons;
    /// Objects that are not polygonal: how many, by kind and reason.
    std::map<std::pair<std::string, std::string>, unsigned> left_out;
    bool last = false;
};

}  // namespace povpreview::tracer
