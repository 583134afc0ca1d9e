// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/items/object_list.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <map>
#include <optional>

#include "display/items/canonical_solid.h"
#include "display/items/capped_solid.h"
#include "display/items/condition_tests.h"
#include "display/items/face_list.h"
#include "display/items/local_frame.h"

namespace povpreview::items {

namespace {

constexpr std::uint32_t no_tests = 0xffffffffu, torus_code = 0xffffffffu;
/// Unknown boxes are taken this much larger, of their size and distance: POV-Ray's own bounds are
/// of 32-bit floats.
constexpr double box_slack = 1e-6;

std::uint32_t sign_code(const CanonicalSolid& solid) {
    if (solid.torus) return torus_code;
    std::uint32_t code = 0;
    for (int i = 0; i < 3; ++i) code |= static_cast<std::uint32_t>(solid.signs[i] + 1) << 2 * i;
    return code;
}

class ObjectLister {
   public:
    ObjectLister(const DrawableScene& scene, const PixelRays& rays, DrawLists& lists)
        : scene_(scene),
          rays_(rays),
          lists_(lists),
          width_(scene.polygons.width),
          height_(scene.polygons.height) {}

    void add(const CurvedObject& object) {
        if (object.pieces == 0) return;
        if (!in_range(object.first_piece, object.pieces, scene_.pieces.size())) {
            add_unknown(object.bounds);
            return;
        }
        // Conditions tell each piece where it ends, so the pieces may be drawn apart.
        rest_.clear();
        const std::uint32_t end = object.first_piece + object.pieces;
        for (std::uint32_t i = object.first_piece; i < end;) {
            if (is_sphere(scene_.pieces[i]) && add_sphere(scene_.pieces[i])) {
                ++i;
                continue;
            }
            const auto capped = CappedSolid::at(scene_, i, end);
            if (capped && capped->list(scene_, object.bounds, rays_, lists_))
                i += capped->pieces;
            else
                rest_.push_back(i++);
        }
        if (rest_.empty()) return;
        const std::vector<glm::dvec2> outline = outline_of(rays_, object.bounds, width_, height_);
        if (outline.size() < 3) return;
        const std::uint32_t before = lists_.records.next();
        if (add_record(object, outline)) return;
        lists_.records.texels().resize(before);
        add_unknown(object.bounds);
    }

    void add_unknown(const Bounds& given) {
        Bounds bounds = given;
        for (int i = 0; i < 3; ++i) {
            if (std::isnan(bounds.low[i])) bounds.low[i] = -INFINITY;
            if (std::isnan(bounds.high[i])) bounds.high[i] = INFINITY;
            const double reach = std::max(std::fabs(bounds.low[i] - rays_.origin[i]),
                                          std::fabs(bounds.high[i] - rays_.origin[i]));
            const double slack = std::isfinite(reach) ? box_slack * reach : 0;
            bounds.low[i] -= slack, bounds.high[i] += slack;
        }
        const std::vector<glm::dvec2> outline = outline_of(rays_, bounds, width_, height_);
        const LocalFrame frame(rays_, bounds, width_, height_);
        if (outline.size() < 3 || !frame.valid()) return;
        const std::uint32_t record = lists_.records.next();
        push_frame(frame);
        lists_.records.push((bounds.low - frame.centre) / frame.size, 0u);
        lists_.records.push((bounds.high - frame.centre) / frame.size, 0u);
        push_fan(lists_.unknown, outline, record);
    }

   private:
    static bool in_range(std::size_t first, std::size_t count, std::size_t size) {
        return first <= size && count <= size - first;
    }

    bool is_sphere(const CurvedPiece& piece) const {
        return piece.conditions == 0 && piece.solid < scene_.solids.size() &&
               scene_.solids[piece.solid].kind == Solid::Kind::sphere;
    }

    /// False where the eye is in its midst or it is degenerate.
    bool add_sphere(const CurvedPiece& piece);
    bool add_record(const CurvedObject& object, const std::vector<glm::dvec2>& outline);
    bool add_tests(const CurvedPiece& piece, const LocalFrame& frame, std::uint32_t piece_texel);
    std::optional<std::uint32_t> solid_record(std::uint32_t solid, const LocalFrame& frame);

    void push_frame(const LocalFrame& frame) {
        lists_.records.push(glm::dvec3(frame.reference, frame.depth), Records::bits(frame.size));
        lists_.records.push(frame.base, Records::bits(frame.base_factor));
        lists_.records.push(frame.direction, Records::bits(frame.direction_factor));
    }
    static void push_fan(std::vector<ItemCorner>& corners, const std::vector<glm::dvec2>& outline,
                         std::uint32_t record) {
        for (std::size_t i = 2; i < outline.size(); ++i)
            for (const std::size_t corner : {std::size_t{0}, i - 1, i})
                corners.push_back({glm::vec2(outline[corner]), record});
    }

    const DrawableScene& scene_;
    const PixelRays& rays_;
    DrawLists& lists_;
    int width_, height_;
    // Of the object at work.
    std::vector<std::uint32_t> rest_;  // its pieces that are not drawn apart
    std::map<std::uint32_t, std::uint32_t> solid_texels_;
    bool tori_ = false, conditions_ = false;
};

//  The ellipsoid's points are centre + sum of axes_i u_i, |u| = 1. In pixels from its centre's
//  projection, X = sum of x_i u_i, W = w + sum of w_i u_i, and X / W is extreme where
//
//      X - e W = 0 touches the unit sphere:  |x - e w_i|^2 = (e w)^2
bool ObjectLister::add_sphere(const CurvedPiece& piece) {
    const Solid& solid = scene_.solids[piece.solid];
    const glm::dmat3 linear(solid.to_frame[0], solid.to_frame[1], solid.to_frame[2]);
    const glm::dmat3 axes = glm::inverse(linear);
    const glm::dvec3 centre = -axes * solid.to_frame[3];
    const Projected projected = rays_.project(centre);
    if (!(projected.depth > 0)) return false;

    glm::dvec2 low, high;
    for (int side = 0; side < 2; ++side) {
        const double middle = projected.pixel()[side];
        double xx = 0, xw = 0, ww = -projected.w * projected.w;
        for (int i = 0; i < 3; ++i) {
            const Projected end = rays_.project(centre + axes[i]);
            const double w = end.w - projected.w;
            const double x = (side == 0 ? end.x : end.y) - middle * end.w;
            xx += x * x, xw += x * w, ww += w * w;
        }
        if (!(ww < -.01 * projected.w * projected.w)) return false;
        const double root = std::sqrt(xw * xw - xx * ww);
        low[side] = middle + (xw + root) / ww;
        high[side] = middle + (xw - root) / ww;
    }
    constexpr double slack = .02;  // pixels
    low -= slack, high += slack;
    if (!std::isfinite(low.x + low.y + high.x + high.y)) return false;
    const glm::dvec2 image(width_, height_);
    low = glm::max(low, glm::dvec2(0)), high = glm::min(high, image);
    if (!(low.x < high.x && low.y < high.y)) return true;  // outside of the image

    const double radius =
        std::max({glm::length(axes[0]), glm::length(axes[1]), glm::length(axes[2])});
    const glm::dvec3 reach(radius / std::sqrt(3.));
    const LocalFrame frame(rays_, {centre - reach, centre + reach}, width_, height_);
    const CanonicalSolid sphere(solid, frame.centre, frame.size);
    if (!frame.valid() || !sphere.valid()) return false;
    const auto to_sphere = [&](const glm::dvec3& v) { return sphere.linear_part * v; };
    lists_.spheres.push_back({glm::vec4(low, high),
                              glm::vec4(frame.reference, frame.depth, frame.size),
                              glm::vec4(to_sphere(frame.base) + sphere.offset, frame.base_factor),
                              glm::vec4(to_sphere(frame.direction), frame.direction_factor),
                              glm::vec3(to_sphere(rays_.across)), glm::vec3(to_sphere(rays_.down)),
                              lists_.records.next()});
    lists_.records.push_bits(piece.surface, look_of(piece.material), 0, 0);
    return true;
}

bool ObjectLister::add_record(const CurvedObject& object, const std::vector<glm::dvec2>& outline) {
    const LocalFrame frame(rays_, object.bounds, width_, height_);
    if (!frame.valid()) return false;
    solid_texels_.clear();
    tori_ = conditions_ = false;
    const std::uint32_t record = lists_.records.next();
    push_frame(frame);
    lists_.records.push_bits(record + 4, static_cast<std::uint32_t>(rest_.size()), 0, 0);
    for (const std::uint32_t i : rest_)
        lists_.records.push_bits(scene_.pieces[i].surface, look_of(scene_.pieces[i].material), 0,
                                 no_tests);
    std::uint32_t texel = record + 4;
    for (const std::uint32_t i : rest_) {
        const CurvedPiece& piece = scene_.pieces[i];
        const auto solid = solid_record(piece.solid, frame);
        if (!solid) return false;
        lists_.records.at(texel).z = *solid;
        if (piece.conditions > 0 && !add_tests(piece, frame, texel)) return false;
        ++texel;
    }
    push_fan(tori_         ? lists_.torus_objects
             : conditions_ ? lists_.objects
                           : lists_.simple_objects,
             outline, record);
    return true;
}

bool ObjectLister::add_tests(const CurvedPiece& piece, const LocalFrame& frame,
                             std::uint32_t piece_texel) {
    if (!in_range(piece.first_condition, piece.conditions, scene_.conditions.size())) return false;
    const auto tests = condition_tests(
        std::span(scene_.conditions).subspan(piece.first_condition, piece.conditions),
        scene_.solids.size());
    if (!tests) return false;
    conditions_ = true;
    std::vector<std::uint32_t> solids;
    for (const ConditionTest& test : *tests) {
        const auto solid = solid_record(test.solid, frame);
        if (!solid) return false;
        solids.push_back(*solid);
    }
    const std::uint32_t first = lists_.records.next();
    const auto texel_of = [&](std::uint32_t next) {
        return next >= ConditionTest::fails ? next : first + next;
    };
    lists_.records.at(piece_texel).w = first;
    for (std::size_t i = 0; i < tests->size(); ++i) {
        const ConditionTest& test = (*tests)[i];
        lists_.records.push_bits(solids[i], test.inverted, texel_of(test.if_inside),
                                 texel_of(test.if_outside));
    }
    return true;
}

std::optional<std::uint32_t> ObjectLister::solid_record(std::uint32_t solid,
                                                        const LocalFrame& frame) {
    if (solid >= scene_.solids.size()) return std::nullopt;
    if (const auto known = solid_texels_.find(solid); known != solid_texels_.end())
        return known->second;
    const CanonicalSolid canonical(scene_.solids[solid], frame.centre, frame.size);
    if (!canonical.valid()) return std::nullopt;
    tori_ = tori_ || canonical.torus;
    const std::uint32_t texel = lists_.records.next();
    const glm::dmat3 rows = glm::transpose(canonical.linear_part);
    for (int i = 0; i < 3; ++i) lists_.records.push(rows[i], Records::bits(canonical.offset[i]));
    lists_.records.push_bits(sign_code(canonical), Records::bits(canonical.slope),
                             Records::bits(canonical.constant), 0);
    solid_texels_.emplace(solid, texel);
    return texel;
}

}  // namespace

void list_objects(const DrawableScene& scene, const PixelRays& rays, DrawLists& lists) {
    ObjectLister lister(scene, rays, lists);
    for (const CurvedObject& object : scene.objects) lister.add(object);
    for (const Bounds& bounds : scene.unknown) lister.add_unknown(bounds);
}

}  // namespace povpreview::items
