// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <tuple>
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

/// The solids of core/detail/drawable_scene.h; in the order of wire::SolidKind.
enum class SolidKind : std::uint8_t {
    half_space,
    sphere,
    cylinder,
    cone,
    quadric,
    torus,
    superellipsoid,
    prism,
    conic_prism,
    lathe,
    surface_of_revolution,
    blob
};

/// Coordinates i of a solid's frame is row[i] . (x, y, z, 1).
struct LocalFrame {
    std::array<std::array<double, 4>, 3> row{};
};
struct ClosedSolid {
    SolidKind kind = SolidKind::half_space;
    LocalFrame frame;
    std::vector<double> numbers;  ///< coefficients, outline or components
};

/// As wire::Piece; steps of its condition follow one another piece by piece.
struct PieceFacts {
    std::uint32_t solid = 0, surface = 0, material = 0, steps = 0;
};
struct BoxFacts {
    Point low, high;
};
/// All of space.
inline const BoxFacts everything{{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}, {HUGE_VAL, HUGE_VAL, HUGE_VAL}};

struct CurvedFacts {
    BoxFacts bounds;
    std::uint32_t pieces = 0;
};

/// As wire::Pattern.
struct PatternFacts {
    std::uint8_t kind = 0;
    std::array<std::array<float, 3>, 3> colours{};
    Point brick_size;
    double mortar = 0;
};
enum class LookKind : std::uint8_t { plain, image, pattern, traced, mixed };
/// As wire::Look.
struct LookFacts {
    std::uint32_t material = 0, image = 0;
    LookKind kind = LookKind::mixed;
    std::uint8_t mapping = 0, interpolation = 0;  ///< as wire::Mapping and wire::Interpolation
    bool once = false;
    float mirror = 0;
    LocalFrame to_map;
    PatternFacts pattern;
};
/// An object without polygons.
struct LeftOutFacts {
    std::string kind, reason;
    bool drawn = false;  ///< it has pieces instead

    bool operator<(const LeftOutFacts& other) const {
        return std::tie(kind, reason, drawn) < std::tie(other.kind, other.reason, other.drawn);
    }
};
struct ImageSize {
    std::uint32_t width = 0, height = 0;
};

/// Part of an image's texels; as wire::Texels.
struct TexelChunk {
    std::uint32_t image = 0, first = 0;
    std::vector<std::uint16_t> halves;
};

/// Part of what can be drawn of a scene, complete in itself; as wire::Geometry.
struct GeometryChunk {
    std::vector<Point> points;
    std::vector<std::uint32_t> corners;  ///< indices into `points`, ring by ring
    std::vector<std::uint32_t> rings;    ///< how many corners each has
    std::vector<PolygonFacts> polygons;
    std::vector<std::array<float, 2>> corner_uvs;  ///< none, or one a corner
    std::vector<ClosedSolid> solids;
    std::vector<std::int32_t> steps;  ///< of conditions, piece by piece
    std::vector<PieceFacts> pieces;   ///< object by object
    std::vector<CurvedFacts> objects;
    std::vector<BoxFacts> unknown, unknown_in_mirrors;
    std::vector<LookFacts> looks;
    std::vector<ImageSize> images;
    /// How many objects are not polygonal, and why.
    std::map<LeftOutFacts, unsigned> left_out;
    bool last = false;
};

}  // namespace povpreview::tracer
