// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <glm/mat4x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "core/polygonal/polygon_scene.h"

/// What of a scene can be drawn without tracing a ray, in world space: the source of the DetailMap
/// (paper, section 2) and, its polygons, of the edges known beforehand. Anything may be wrong with
/// it, as with a PolygonScene.
namespace povpreview {

/// A solid bounded by one surface f = 0, in a frame of its own; inside is f <= 0.
///
/// An outline is a list of cubic Bézier segments, four control points (u, v) each; inside is what
/// an odd number of its curves surround. A blob's list is its threshold and then, a component, the
/// 12 numbers of a matrix from the solid's frame (columns), a strength s, and a shape: with r the
/// distance from the origin (0), the same where z >= 0 (1), or that from the z axis for z in [0, 1]
/// (2), the field is s (1 - r^2)^2 where r < 1.
struct Solid {
    enum class Kind : std::uint8_t {
        half_space,  ///< f = z
        sphere,      ///< f = x^2 + y^2 + z^2 - 1
        cylinder,    ///< f = x^2 + y^2 - 1, endless along z
        cone,        ///< f = x^2 + y^2 - z^2, both nappes, endless
        quadric,     ///< f = c . (xx, yy, zz, xy, xz, yz, x, y, z, 1)
        torus,       ///< f = (sqrt(x^2 + z^2) - 1)^2 + y^2 - c[0]^2
        /// f = ((|x|^c[0] + |y|^c[0])^(c[1]/c[0]) + |z|^c[1])^(1/c[1]) - 1, both at least 1
        superellipsoid,
        prism,        ///< (x, y) inside an outline, endless along z
        conic_prism,  ///< (x / z, y / z) inside an outline, on both sides of the apex, endless
        lathe,        ///< (sqrt(x^2 + y^2), z) inside an outline
        /// (x^2 + y^2, z) inside an outline, which may be open towards smaller u
        surface_of_revolution,
        blob  ///< threshold - sum of the components' fields
    };
    Kind kind = Kind::sphere;
    glm::dmat4x3 to_frame{1};  ///< from the world; need not keep angles
    std::array<double, 10> coefficients{};
    /// Its list, in DrawableScene::numbers.
    std::uint32_t first_number = 0, numbers = 0;
};
constexpr std::size_t outline_numbers_a_segment = 8, blob_numbers_a_component = 14;

/// A part of the boundary of a solid: its points where a condition holds. That is how primitives
/// with ends, CSG and clipping are made of endless solids:
///
///     side of a closed cylinder = boundary of the endless one where inside(cap 1) and inside(cap
///     2) difference { A B }        = boundary of A where not inside(B), of B where inside(A)
struct CurvedPiece {
    std::uint32_t solid = 0;     ///< in DrawableScene::solids
    std::uint32_t surface = 0;   ///< identity, as samples carry it (Sample::surface)
    std::uint32_t material = 0;  ///< in DrawableScene::looks
    /// Its condition: a program in DrawableScene::conditions; empty: holds everywhere.
    std::uint32_t first_condition = 0, conditions = 0;
};

/// A step of a condition, for a machine with a stack of truth values, at most 32 deep: a number
/// from 0 on pushes whether the point is inside the solid of that number.
using ConditionStep = std::int32_t;
constexpr ConditionStep condition_not = -1;  ///< of the top
constexpr ConditionStep condition_and = -2;  ///< of the top two, in their place
constexpr ConditionStep condition_or = -3;   ///< of the top two, in their place

/// An axis-aligned box in world space; its sides may be infinitely far.
struct Bounds {
    glm::dvec3 low{}, high{};
};

/// An object with curved surfaces.
struct CurvedObject {
    Bounds bounds;                              ///< hold all that is visible of it
    std::uint32_t first_piece = 0, pieces = 0;  ///< in DrawableScene::pieces
};

/// How an image covers a surface. A point of the world goes by `to_map` into the pigment's own
/// space, turned so that a planar image lies along x and y and a torus has its large radius at 1;
/// `mapping` takes it from there to the unit square as POV-Ray's map_type does. Mapping::uv is
/// planar, but of (u, v, 0) in place of the point, from DrawableScene::corner_uvs.
struct ImageLook {
    enum class Mapping : std::uint8_t { planar, spherical, cylindrical, toroidal, uv };
    enum class Interpolation : std::uint8_t { none, bilinear, bicubic, normalised_distance };
    std::uint32_t image = 0;  ///< in DrawableScene::images
    Mapping mapping = Mapping::planar;
    Interpolation interpolation = Interpolation::none;
    bool once = false;  ///< outside of the unit square: not drawn, see Look::Kind::traced
    glm::dmat4x3 to_map{1};
};

/// A list of colours laid out in space. A point of the world goes by `to_pattern` into the
/// pattern's own space, where checkers are cubes of size 1, POV-Ray's bricks have `brick_size` with
/// mortar between them that is part of it, and hexagons lie in the plane of x and z, their sides of
/// length 1.
struct PatternLook {
    enum class Kind : std::uint8_t { checker, brick, hexagon };
    Kind kind = Kind::checker;
    std::array<glm::vec3, 3> colours{};  ///< linear; of bricks the mortar's first, then theirs
    glm::dvec3 brick_size{8, 3, 4.5};
    double mortar = .5;
    glm::dmat4x3 to_pattern{1};
};

/// What is known of a material's albedo beforehand.
struct Look {
    enum class Kind : std::uint8_t {
        plain,    ///< one colour all over
        image,    ///< an image map that can be drawn
        pattern,  ///< a pattern of colours that can be drawn
        traced,   ///< varies, and only the ray tracer can say how
        mixed     ///< not by its albedo alone: finishes or transparency vary, layers over glass
    };
    Kind kind = Kind::mixed;
    ImageLook image;        ///< Kind::image
    PatternLook pattern{};  ///< Kind::pattern
    /// Share of light that it reflects at least, 0..1, where its surface is flat as a flat mirror
    /// does; 0 if anything bends the light.
    float mirror = 0;
};

/// An image as the ray tracer holds it: in the scene's working gamma, row by row from the top.
struct ImageTexels {
    std::uint32_t width = 0, height = 0;
    std::vector<std::array<std::uint16_t, 4>> texels;  ///< half floats: red, green, blue, opacity
};

struct DrawableScene {
    /// Faces with the camera. `Face::material` is in `looks`.
    PolygonScene polygons;
    /// Beside PolygonScene::corners; empty where no face is of ImageLook::Mapping::uv.
    std::vector<glm::vec2> corner_uvs;

    std::vector<Solid> solids;
    std::vector<double> numbers;  ///< outlines and blobs of solids
    std::vector<ConditionStep> conditions;
    std::vector<CurvedPiece> pieces;
    std::vector<CurvedObject> objects;
    /// Objects that cannot be drawn exactly, as boxes around them: what is not nearer than such a
    /// box is not known.
    std::vector<Bounds> unknown;
    /// The same of objects that mirrors do not show as the eye sees them.
    std::vector<Bounds> unknown_in_mirrors;

    std::vector<Look> looks;  ///< by material; a material beyond its end is mixed
    std::vector<ImageTexels> images;
    float working_gamma = 1;  ///< of `images`
};

}  // namespace povpreview
