// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/polygonal/shadow_volumes.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/polygonal/backdrop.h"
#include "core/polygonal/sides.h"

namespace povpreview {
namespace {

/// A determinant of three differences is uncertain by this times the product of their largest
/// coordinates: each of its six products is rounded five times, and their sum as often.
constexpr double determinant_error = 1e-14;

double largest(const glm::dvec3& v) {
    const glm::dvec3 a = glm::abs(v);
    return std::max({a.x, a.y, a.z});
}

/// Whether a box lies off a segment (separating axes).
struct SegmentMisses {
    SegmentMisses(const glm::dvec3& a, const glm::dvec3& b)
        : middle((a + b) / 2.), half((b - a) / 2.), reach(glm::abs(half)) {}

    bool operator()(const FaceBox& box) const {
        const glm::dvec3 h(box.half), to = glm::dvec3(box.centre) - middle;
        for (int k = 0; k < 3; ++k)
            if (std::abs(to[k]) > h[k] + reach[k]) return true;
        const glm::dvec3 c = glm::abs(glm::cross(half, to));
        return c.x > h.y * reach.z + h.z * reach.y || c.y > h.x * reach.z + h.z * reach.x ||
               c.z > h.x * reach.y + h.y * reach.x;
    }

    glm::dvec3 middle, half, reach;
};

}  // namespace

/// The part of the plane through the viewpoint and a segment that lies before the segment, or
/// behind it, as what a box may miss.
///
///      viewpoint ------------ a
///               \            /|      before: the triangle
///                `-.        / |
///                   `-----b   |      behind: what its sides enclose beyond a-b
///                           \ |
struct ShadowVolumes::Sheet {
    enum class Part { before, behind };

    Sheet(const ShadowVolumes& volumes, const SpaceSegment& segment, Part part)
        : through(normal_of(volumes.viewpoint_, segment), segment.a),
          beside_a(beside(volumes.viewpoint_, segment.a, segment.b - segment.a)),
          beside_b(beside(volumes.viewpoint_, segment.b, segment.a - segment.b)),
          cut(across(volumes.viewpoint_, segment, part)) {
        if (volumes.near_) near.emplace(volumes.near_->normal, volumes.near_->on);
    }

    /// The segment is seen end on: a point, before and behind which there is no sheet.
    bool degenerate() const { return !(glm::dot(through.normal, through.normal) > 0); }

    bool operator()(const FaceBox& box) const {
        const double distance = glm::dot(through.normal, glm::dvec3(box.centre)) + through.offset;
        return std::abs(distance) > glm::dot(through.absolute, glm::dvec3(box.half)) ||
               cut.misses(box) || beside_a.misses(box) || beside_b.misses(box) ||
               (near && near->misses(box));
    }

    HalfSpace through, beside_a, beside_b, cut;
    std::optional<HalfSpace> near;

   private:
    static glm::dvec3 normal_of(const glm::dvec4& v, const SpaceSegment& s) {
        return glm::cross(sight_line(v, s.a), s.b - s.a);
    }
    HalfSpace beside(const glm::dvec4& v, const glm::dvec3& p, const glm::dvec3& inward) const {
        glm::dvec3 n = glm::cross(through.normal, sight_line(v, p));
        if (glm::dot(n, inward) < 0) n = -n;
        return {n, p};
    }
    HalfSpace across(const glm::dvec4& v, const SpaceSegment& s, Part part) const {
        glm::dvec3 n = glm::cross(through.normal, s.b - s.a);
        const bool beyond = glm::dot(n, sight_line(v, s.a)) > 0;
        if (beyond != (part == Part::behind)) n = -n;
        return {n, s.a};
    }
};

ShadowVolumes::ShadowVolumes(const FlatFaces& faces, const FaceHierarchy& hierarchy,
                             const glm::dvec4& viewpoint, Viewer viewer,
                             const std::optional<NearPlane>& near)
    : faces_(faces), hierarchy_(hierarchy), viewpoint_(viewpoint), viewer_(viewer), near_(near) {
    volumes_.reserve(faces.size());
    for (std::size_t i = 0; i < faces.size(); ++i) {
        const int facing = faces.facing(i, viewpoint);
        volumes_.push_back({static_cast<std::uint32_t>(sides_.size()),
                            static_cast<std::int8_t>(facing), facing != 0 && blocks(faces.face(i)),
                            std::abs(faces.height(i, viewpoint))});
        if (facing != 0) add_sides(i);
    }
}

bool ShadowVolumes::blocks(const Face& face) const {
    if (face.transparent) return false;
    switch (viewer_) {
        case Viewer::eye:
            return face.visible;
        case Viewer::light:
            return face.casts_shadow;
        case Viewer::mirror:
            return face.reflected;
    }
    return false;
}

void ShadowVolumes::add_sides(std::size_t face) {
    const auto corners = faces_.corners(face);
    const double inward = -volumes_[face].facing;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const glm::dvec3& a = faces_.point(corners[i]);
        const glm::dvec3& b = faces_.point(corners[(i + 1) % corners.size()]);
        const glm::dvec3 u = sight_line(viewpoint_, a);
        const glm::dvec3 v = viewpoint_.w != 0 ? sight_line(viewpoint_, b) : b - a;
        sides_.push_back({inward * glm::cross(u, v), determinant_error * largest(u) * largest(v)});
    }
}

double ShadowVolumes::side_of(std::size_t face, std::uint32_t edge, const glm::dvec3& p,
                              std::uint32_t point) const {
    const auto corners = faces_.corners(face);
    const std::uint32_t a = corners[edge];
    const Side& side = sides_[volumes_[face].first + edge];
    const glm::dvec3 from = viewpoint_.w != 0 ? sight_line(viewpoint_, p) : p - faces_.point(a);
    const double value = glm::dot(side.normal, from);
    if (point == SpaceSegment::constructed) return value;
    const double uncertainty = side.uncertainty * largest(from);
    if (std::abs(value) > uncertainty) return value;
    const std::uint32_t b = corners[edge + 1 < corners.size() ? edge + 1 : 0];
    if (point == a || point == b) return 0;
    const int sign =
        -volumes_[face].facing * exact_side(viewpoint_, faces_.point(a), faces_.point(b), p);
    return sign * std::max(std::abs(value), std::numeric_limits<double>::min());
}

bool ShadowVolumes::clip_to_sides(const SpaceSegment& segment, std::size_t face,
                                  Interval& part) const {
    const auto count = static_cast<std::uint32_t>(faces_.corners(face).size());
    for (std::uint32_t i = 0; i < count; ++i)
        if (!clip(part, side_of(face, i, segment.a, segment.point_a),
                  side_of(face, i, segment.b, segment.point_b)))
            return false;
    return true;
}

/// Of a segment's ends over a face, positive on the side that the viewpoint sees.
ShadowVolumes::Ends ShadowVolumes::heights(const SpaceSegment& segment, std::size_t face) const {
    const double facing = volumes_[face].facing;
    return {facing * faces_.height(face, segment.a), facing * faces_.height(face, segment.b)};
}

ShadowVolumes::Ends ShadowVolumes::tolerances(const SpaceSegment& segment) const {
    return {contact * sight_distance(viewpoint_, segment.a, faces_.extent()),
            contact * sight_distance(viewpoint_, segment.b, faces_.extent())};
}

/// Cuts `part` down to where the face, as it lies before the segment, is in front of the near
/// plane.
///
///     The line of sight to p meets the face at x = v + (p - v) H / (H - h), where H and h are the
///     heights of v and p over the face; so the near plane's height of x has the sign of
///     H near(p) - h near(v), which is linear in p.
bool ShadowVolumes::clip_to_near(const SpaceSegment& segment, std::size_t face, const Ends& heights,
                                 Interval& part) const {
    if (!near_) return true;
    const Volume& volume = volumes_[face];
    const double beyond = near_->height(viewpoint_);
    const double a = volume.height * near_->height(segment.a) - heights.a * beyond;
    const double b = volume.height * near_->height(segment.b) - heights.b * beyond;
    const Ends tolerance = tolerances(segment);
    return clip(part, a - volume.height * tolerance.a, b - volume.height * tolerance.b);
}

void ShadowVolumes::hide(const SpaceSegment& segment, IntervalSet& left) const {
    const Sheet sheet(*this, segment, Sheet::Part::before);
    if (sheet.degenerate()) return left.subtract({0, 1});
    const Ends tolerance = tolerances(segment);
    hierarchy_.search(sheet, [&](std::uint32_t face) {
        if (!volumes_[face].blocks) return true;
        const Ends height = heights(segment, face);
        Interval part;
        if (clip(part, -height.a - tolerance.a, -height.b - tolerance.b) &&
            clip_to_sides(segment, face, part) && clip_to_near(segment, face, height, part))
            left.subtract(part);
        return !left.empty();
    });
}

void ShadowVolumes::cast(const SpaceSegment& segment, std::vector<Backdrop>& backdrops) const {
    backdrops.clear();
    const Sheet sheet(*this, segment, Sheet::Part::behind);
    if (sheet.degenerate()) return;
    const Ends tolerance = tolerances(segment);
    std::vector<Backdrop> through;  // faces that let light pass
    hierarchy_.search(sheet, [&](std::uint32_t face) {
        const Volume& volume = volumes_[face];
        if (volume.facing == 0) return true;
        const Ends height = heights(segment, face);
        Interval part;
        if (!clip(part, height.a - tolerance.a, height.b - tolerance.b) ||
            !clip_to_sides(segment, face, part))
            return true;
        const auto nearness = [&](double t) {
            return viewpoint_.w - (height.a + t * (height.b - height.a)) / volume.height;
        };
        const Backdrop backdrop{part, nearness(part.from), nearness(part.to), face};
        if (volume.blocks)
            put_in_front(backdrop, backdrops);
        else
            through.push_back(backdrop);
        return true;
    });
    const std::size_t blocking = backdrops.size();
    for (const Backdrop& backdrop : through)
        parts_in_front(backdrop, std::span(backdrops).first(blocking), backdrops);
}

glm::dvec3 ShadowVolumes::behind(const SpaceSegment& segment, double t, double nearness) const {
    const glm::dvec3 p = segment.at(t), v(viewpoint_);
    return viewpoint_.w != 0 ? v + (p - v) / nearness : p + nearness * v;
}

bool ShadowVolumes::sees(const glm::dvec3& p) const {
    const glm::dvec3 v(viewpoint_);
    // POV-Ray sees no farther than 1e7.
    const glm::dvec3 from = viewpoint_.w != 0 ? v : p + v * (2e7 / glm::length(v));
    const double tolerance = contact * sight_distance(viewpoint_, p, faces_.extent());
    bool seen = true;
    hierarchy_.search(SegmentMisses(from, p), [&](std::uint32_t face) {
        const Volume& volume = volumes_[face];
        if (!volume.blocks || -volume.facing * faces_.height(face, p) <= tolerance) return true;
        const auto count = static_cast<std::uint32_t>(faces_.corners(face).size());
        for (std::uint32_t i = 0; i < count; ++i)
            if (side_of(face, i, p) <= 0) return true;
        seen = false;
        return false;
    });
    return seen;
}

}  // namespace povpreview
