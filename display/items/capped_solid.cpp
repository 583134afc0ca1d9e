// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/items/capped_solid.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <vector>

#include "display/items/canonical_solid.h"
#include "display/items/face_list.h"
#include "display/items/local_frame.h"

namespace povpreview::items {

namespace {

/// The solids that a condition asks for, if it asks for all of them and nothing else.
std::optional<std::vector<std::uint32_t>> conjunction(const DrawableScene& scene,
                                                      const CurvedPiece& piece) {
    std::vector<std::uint32_t> solids;
    const std::size_t size = scene.conditions.size();
    if (piece.first_condition > size || piece.conditions > size - piece.first_condition)
        return std::nullopt;
    int depth = 0;
    for (std::uint32_t i = 0; i < piece.conditions; ++i) {
        const ConditionStep step = scene.conditions[piece.first_condition + i];
        if (step >= 0 && static_cast<std::size_t>(step) < scene.solids.size())
            solids.push_back(static_cast<std::uint32_t>(step)), ++depth;
        else if (step == condition_and && depth >= 2)
            --depth;
        else
            return std::nullopt;
    }
    if (depth > 1) return std::nullopt;
    return solids;
}

bool is_round(Solid::Kind kind) {
    return kind == Solid::Kind::sphere || kind == Solid::Kind::cylinder ||
           kind == Solid::Kind::cone;
}

glm::dmat3 linear_part_of(const glm::dmat4x3& m) { return {m[0], m[1], m[2]}; }

/// A half space's f in the frame of another solid: dot(.xyz, p) + .w.
glm::dvec4 plane_in(const CanonicalSolid& half_space, const CanonicalSolid& frame) {
    const glm::dvec3 row(half_space.linear_part[0].z, half_space.linear_part[1].z,
                         half_space.linear_part[2].z);
    const glm::dvec3 normal = row * glm::inverse(frame.linear_part);
    return {normal, half_space.offset.z - glm::dot(normal, frame.offset)};
}

/// The rectangle of least area around a convex polygon, as corners of a triangle strip.
std::array<glm::vec2, 4> rectangle_around(const std::vector<glm::dvec2>& hull) {
    std::array<glm::vec2, 4> best{};
    double least = INFINITY;
    for (std::size_t i = 0; i < hull.size(); ++i) {
        const glm::dvec2 edge = hull[(i + 1) % hull.size()] - hull[i];
        const double length = glm::length(edge);
        if (!(length > 0)) continue;
        const glm::dvec2 u = edge / length, v(-u.y, u.x);
        glm::dvec2 low(INFINITY), high(-INFINITY);
        for (const glm::dvec2& p : hull) {
            const glm::dvec2 q(glm::dot(p, u), glm::dot(p, v));
            low = glm::min(low, q), high = glm::max(high, q);
        }
        const double area = (high.x - low.x) * (high.y - low.y);
        if (!(area < least)) continue;
        least = area;
        best = {glm::vec2(low.x * u + low.y * v), glm::vec2(high.x * u + low.y * v),
                glm::vec2(low.x * u + high.y * v), glm::vec2(high.x * u + high.y * v)};
    }
    return best;
}

}  // namespace

std::optional<CappedSolid> CappedSolid::at(const DrawableScene& scene, std::uint32_t first,
                                           std::uint32_t end) {
    const CurvedPiece& side = scene.pieces[first];
    if (side.solid >= scene.solids.size() || !is_round(scene.solids[side.solid].kind))
        return std::nullopt;
    const auto cutters = conjunction(scene, side);
    if (!cutters || cutters->size() > 2) return std::nullopt;
    CappedSolid result;
    result.side = side.solid, result.side_piece = first, result.pieces = 1;
    for (std::size_t i = 0; i < cutters->size(); ++i) {
        if (scene.solids[(*cutters)[i]].kind != Solid::Kind::half_space) return std::nullopt;
        result.planes[i] = (*cutters)[i];
    }
    while (first + result.pieces < end) {
        const CurvedPiece& cap = scene.pieces[first + result.pieces];
        const auto which = std::find(result.planes.begin(), result.planes.end(), cap.solid);
        if (which == result.planes.end()) break;
        const auto i = static_cast<std::size_t>(which - result.planes.begin());
        const auto around = conjunction(scene, cap);
        if (result.cap_pieces[i] != none || !around) break;
        const std::uint32_t other = result.planes[1 - i];
        const auto asks = [&](std::uint32_t solid) {
            return std::find(around->begin(), around->end(), solid) != around->end();
        };
        if (!asks(side.solid) || !std::all_of(around->begin(), around->end(), [&](std::uint32_t s) {
                return s == side.solid || s == other;
            }))
            break;
        result.cap_pieces[i] = first + result.pieces++;
        result.cut_by_other[i] = asks(other);
    }
    return result;
}

std::optional<std::array<glm::dvec3, 8>> CappedSolid::box(const DrawableScene& scene) const {
    const Solid& solid = scene.solids[side];
    const CanonicalSolid frame(solid, glm::dvec3(0), 1);
    double low = -INFINITY, high = INFINITY;
    if (solid.kind == Solid::Kind::sphere) low = -1, high = 1;
    for (const std::uint32_t number : planes) {
        if (number == none) continue;
        const CanonicalSolid half_space(scene.solids[number], glm::dvec3(0), 1);
        const glm::dvec4 plane = plane_in(half_space, frame);
        // Square to the axis, as far as doubles tell.
        if (std::hypot(plane.x, plane.y) > 1e-9 * std::fabs(plane.z)) continue;
        const double end = -plane.w / plane.z;
        (plane.z > 0 ? high : low) = plane.z > 0 ? std::min(high, end) : std::max(low, end);
    }
    if (!std::isfinite(low + high) || low > high) return std::nullopt;
    const double radius =
        solid.kind == Solid::Kind::cone ? std::max(std::fabs(low), std::fabs(high)) : 1;
    const glm::dmat3 back = glm::inverse(linear_part_of(solid.to_frame));
    std::array<glm::dvec3, 8> corners;
    for (std::size_t i = 0; i < 8; ++i)
        corners[i] = back * (glm::dvec3(i & 1 ? radius : -radius, i & 2 ? radius : -radius,
                                        i & 4 ? high : low) -
                             solid.to_frame[3]);
    return corners;
}

bool CappedSolid::list(const DrawableScene& scene, const Bounds& bounds, const PixelRays& rays,
                       DrawLists& lists) const {
    const int width = scene.polygons.width, height = scene.polygons.height;
    Bounds around = bounds;
    std::vector<glm::dvec2> outline;
    if (const auto corners = box(scene)) {
        around = {(*corners)[0], (*corners)[0]};
        for (const glm::dvec3& p : *corners)
            around = {glm::min(around.low, p), glm::max(around.high, p)};
        if (!is_finite(around)) return false;
        outline = outline_of(rays, *corners, width, height);
    } else {
        outline = outline_of(rays, bounds, width, height);
    }
    const LocalFrame local(rays, around, width, height);
    const CanonicalSolid frame(scene.solids[side], local.centre, local.size);
    if (!local.valid() || !frame.valid()) return false;
    CappedInstance instance;
    for (std::size_t i = 0; i < 2; ++i) {
        instance.planes[i] = glm::vec4(0, 0, 0, -1);
        if (planes[i] == none) continue;
        const CanonicalSolid plane(scene.solids[planes[i]], local.centre, local.size);
        const glm::dvec4 f = plane_in(plane, frame);
        const double size = glm::length(glm::dvec3(f));
        if (!std::isfinite(size + f.w) || !(size > 0)) return false;
        instance.planes[i] = glm::vec4(f / size);
    }
    if (outline.size() < 3) return true;  // outside of the image

    const std::array<glm::vec2, 4> rectangle = rectangle_around(outline);
    instance.corners_low = {rectangle[0], rectangle[1]};
    instance.corners_high = {rectangle[2], rectangle[3]};
    const auto to_frame = [&](const glm::dvec3& v) { return frame.linear_part * v; };
    instance.reference = glm::vec4(local.reference, local.depth, local.size);
    instance.base = glm::vec4(to_frame(local.base) + frame.offset, local.base_factor);
    instance.direction = glm::vec4(to_frame(local.direction), local.direction_factor);
    instance.across = to_frame(rays.across), instance.down = to_frame(rays.down);
    instance.signs = glm::vec4(frame.signs, frame.constant);
    const auto label = [&](std::uint32_t piece) {
        if (piece == none) return 0u;
        const std::uint32_t texel = lists.records.next();
        lists.records.push_bits(scene.pieces[piece].surface, look_of(scene.pieces[piece].material),
                                0, 0);
        return texel;
    };
    instance.items = {label(side_piece), label(cap_pieces[0]), label(cap_pieces[1]),
                      (cut_by_other[0] ? 1u : 0u) | (cut_by_other[1] ? 2u : 0u)};
    lists.capped.push_back(instance);
    return true;
}

}  // namespace povpreview::items
