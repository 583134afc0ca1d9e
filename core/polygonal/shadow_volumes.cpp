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

/// A parallel view is looked into from so far before a point, as a multiple of FlatFaces::scale.
constexpr double far_off = 1e4;

double largest(const glm::dvec3& v) {
    const glm::dvec3 a = glm::abs(v);
    return std::max({a.x, a.y, a.z});
}

/// A ray up to some distance, as what a box may miss (slabs).
struct Ray {
    Ray(const glm::dvec3& origin, const glm::dvec3& unit, double length)
        : from(origin), inverse(1. / unit), end(length) {}

    bool misses(const FaceBox& box) const {
        const glm::dvec3 c = (glm::dvec3(box.centre) - from) * inverse;
        const glm::dvec3 h = glm::dvec3(box.half) * glm::abs(inverse);
        // Written so that NaN, from a direction along a slab's face, misses nothing.
        const double enter = std::max({c.x - h.x, c.y - h.y, c.z - h.z, 0.});
        const double leave = std::min({c.x + h.x, c.y + h.y, c.z + h.z, end});
        return enter > leave;
    }

    glm::dvec3 from, inverse;
    double end;
};

}  // namespace

/// The part of the plane through the viewpoint and a segment that lies before the segment, or
/// behind it.
///
///      viewpoint ------------ a
///               \            /|      before: the triangle
///                `-.        / |
///                   `-----b   |      behind: what its sides enclose beyond a-b
///                           \ |
struct ShadowVolumes::Sheet {
    enum class Part { before, behind };

    Sheet(const ShadowVolumes& volumes, const SpaceSegment& segment, Part part) {
        const glm::dvec4& v = volumes.viewpoint_;
        const glm::dvec3 to_a = sight_line(v, segment.a), to_b = sight_line(v, segment.b);
        const glm::dvec3 along = segment.b - segment.a, normal = glm::cross(to_a, along);
        degenerate = !(glm::dot(normal, normal) > 0);
        region.add(normal, segment.a);
        region.add(-normal, segment.a);
        add_side(glm::cross(normal, to_a), segment.a, along);
        add_side(glm::cross(normal, to_b), segment.b, -along);
        away = glm::dvec3(glm::normalize(to_a + to_b));
        add_side(glm::cross(normal, along), segment.a, part == Part::before ? -away : away);
        if (part == Part::behind) region.add_movable(-away);
        if (volumes.near_) region.add(volumes.near_->normal, volumes.near_->on);
    }

    void add_side(const glm::dvec3& normal, const glm::dvec3& on, const glm::dvec3& inward) {
        region.add(glm::dot(normal, inward) < 0 ? -normal : normal, on);
    }

    /// The segment is seen end on: a point, before and behind which there is no sheet.
    bool degenerate;
    Region region;
    glm::dvec3 away;  ///< from the viewpoint to the segment, of unit length
};

ShadowVolumes::ShadowVolumes(const FlatFaces& faces, const FaceHierarchy& hierarchy,
                             const glm::dvec4& viewpoint, Viewer viewer,
                             const std::optional<NearPlane>& near)
    : faces_(faces), hierarchy_(hierarchy), viewpoint_(viewpoint), viewer_(viewer), near_(near) {
    volumes_.reserve(faces.size());
    for (std::size_t i = 0; i < faces.size(); ++i) {
        const int facing = faces.facing(i, viewpoint);
        const bool there = facing != 0 && is_there(faces.face(i));
        volumes_.push_back(
            {static_cast<std::uint32_t>(sides_.size()), static_cast<std::int8_t>(facing), there,
             there && !faces.face(i).transparent, std::abs(faces.height(i, viewpoint))});
        if (facing != 0) add_sides(i);
    }
}

bool ShadowVolumes::is_there(const Face& face) const {
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
    return {contact * faces_.scale(segment.a), contact * faces_.scale(segment.b)};
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

/// Takes off `left` what one face hides.
void ShadowVolumes::hide_by(std::size_t face, const SpaceSegment& segment, const Ends& tolerance,
                            IntervalSet& left) const {
    const Ends height = heights(segment, face);
    Interval part;
    if (clip(part, -height.a - tolerance.a, -height.b - tolerance.b) &&
        clip_to_sides(segment, face, part) && clip_to_near(segment, face, height, part))
        left.subtract(part);
}

void ShadowVolumes::hide(const SpaceSegment& segment, IntervalSet& left) const {
    if (left.empty()) return;
    const Ends tolerance = tolerances(segment);
    // What hid the segment before is likely to hide its neighbour.
    if (last_hider_ < volumes_.size()) hide_by(last_hider_, segment, tolerance, left);
    if (left.empty()) return;
    const Sheet sheet(*this, segment, Sheet::Part::before);
    if (sheet.degenerate) return left.subtract({0, 1});
    hierarchy_.search([&](const FaceBox& box) { return sheet.region.misses(box); }, -sheet.away,
                      [&](std::uint32_t face) {
                          if (!volumes_[face].blocks) return true;
                          hide_by(face, segment, tolerance, left);
                          if (left.empty()) last_hider_ = face;
                          return !left.empty();
                      });
}

void ShadowVolumes::cast(const SpaceSegment& segment, std::vector<Backdrop>& backdrops) const {
    backdrops.clear();
    Sheet sheet(*this, segment, Sheet::Part::behind);
    if (sheet.degenerate) return;
    const Ends tolerance = tolerances(segment);
    std::vector<Backdrop> through;  // faces that let light pass
    std::size_t since_move = 0;     // so that moving costs no more than what it follows
    hierarchy_.search([&](const FaceBox& box) { return sheet.region.misses(box); }, sheet.away,
                      [&](std::uint32_t face) {
                          Backdrop backdrop;
                          if (!cast_on(face, segment, tolerance, backdrop)) return true;
                          if (!volumes_[face].blocks) {
                              through.push_back(backdrop);
                              return true;
                          }
                          put_in_front(backdrop, backdrops);
                          if (++since_move * 4 < backdrops.size() || !covered(backdrops))
                              return true;
                          since_move = 0;
                          sheet.region.move_to(farthest(segment, backdrops, sheet.away));
                          return true;
                      });
    const std::size_t blocking = backdrops.size();
    std::vector<Backdrop> lit;
    for (const Backdrop& backdrop : through)
        parts_in_front(backdrop, std::span(backdrops).first(blocking), lit);
    backdrops.insert(backdrops.end(), lit.begin(), lit.end());
}

/// The part of a segment behind which a face lies; false where there is none.
bool ShadowVolumes::cast_on(std::uint32_t face, const SpaceSegment& segment, const Ends& tolerance,
                            Backdrop& backdrop) const {
    const Volume& volume = volumes_[face];
    if (volume.facing == 0) return false;
    const Ends height = heights(segment, face);
    Interval part;
    if (!clip(part, height.a - tolerance.a, height.b - tolerance.b) ||
        !clip_to_sides(segment, face, part))
        return false;
    const auto nearness = [&](double t) {
        return viewpoint_.w - (height.a + t * (height.b - height.a)) / volume.height;
    };
    backdrop = {part, nearness(part.from), nearness(part.to), face};
    return true;
}

/// The point of the backdrops that lies farthest in a direction.
glm::dvec3 ShadowVolumes::farthest(const SpaceSegment& segment,
                                   const std::vector<Backdrop>& backdrops,
                                   const glm::dvec3& direction) const {
    glm::dvec3 result(0);
    double most = -std::numeric_limits<double>::infinity();
    const auto consider = [&](double t, double nearness) {
        const glm::dvec3 p = behind(segment, t, nearness);
        if (const double d = glm::dot(p, direction); d > most) most = d, result = p;
    };
    for (const Backdrop& b : backdrops) {
        consider(b.part.from, b.nearness_from);
        consider(b.part.to, b.nearness_to);
    }
    return result;
}

glm::dvec3 ShadowVolumes::behind(const glm::dvec3& p, double nearness) const {
    const glm::dvec3 v(viewpoint_);
    return viewpoint_.w != 0 ? v + (p - v) / nearness : p + nearness * v;
}

bool ShadowVolumes::in_front(const NearPlane& near, const glm::dvec3& p) const {
    return near.height(p) > contact * faces_.scale(p);
}

bool ShadowVolumes::inside_sides(std::uint32_t face, const glm::dvec3& p) const {
    const auto count = static_cast<std::uint32_t>(faces_.corners(face).size());
    for (std::uint32_t i = 0; i < count; ++i)
        if (side_of(face, i, p) <= 0) return false;
    return true;
}

std::optional<ShadowVolumes::Sight> ShadowVolumes::first_face(const glm::dvec3& through) const {
    const glm::dvec3 v(viewpoint_), line = glm::normalize(sight_line(viewpoint_, through));
    const glm::dvec3 from =
        viewpoint_.w != 0 ? v : through - far_off * faces_.scale(through) * line;
    Ray ray(from, line, std::numeric_limits<double>::infinity());
    std::optional<Sight> first;
    hierarchy_.search([&](const FaceBox& box) { return ray.misses(box); }, line,
                      [&](std::uint32_t face) {
                          const Volume& volume = volumes_[face];
                          if (!volume.there || !inside_sides(face, through)) return true;
                          const double height = volume.facing * faces_.height(face, through);
                          const double nearness = viewpoint_.w - height / volume.height;
                          if (first && first->nearness >= nearness) return true;
                          const glm::dvec3 hit = behind(through, nearness);
                          if (near_ && !in_front(*near_, hit)) return true;
                          first = Sight{face, nearness};
                          ray.end = glm::distance(from, hit);
                          return true;
                      });
    return first;
}

}  // namespace povpreview
