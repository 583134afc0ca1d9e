// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/core/polygonal/brute_force.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace povpreview {
namespace {

constexpr Real contact = 1e-6L;     ///< of the line of sight's length: what touches hides nothing
constexpr Real edge_on = 3e-3L;     ///< the same of a line of sight: the face is but a line
constexpr Real graze = 1e-7L;       ///< sine of an angle at which light runs along a face
constexpr Real near_plane = 2e-6L;  ///< of the distance: so near to a plane, it may touch

Real dot4(const glm::dvec4& plane, const Vec3& p) {
    return Real(plane.x) * p.x + Real(plane.y) * p.y + Real(plane.z) * p.z + Real(plane.w);
}

}  // namespace

BruteForce::BruteForce(const PolygonScene& scene, int mirror_depth)
    : scene_(scene), mirror_depth_(mirror_depth) {
    for (std::uint32_t f = 0; f < scene.faces.size(); ++f) {
        Vec3 normal(0), centre(0);
        const std::uint32_t n = scene.faces[f].count;
        for (std::uint32_t i = 0; i < n; ++i) centre += corner(f, i) / Real(n);
        for (std::uint32_t i = 0; i < n; ++i)
            normal += glm::cross(corner(f, i) - centre, corner(f, (i + 1) % n) - centre);
        const Real length = glm::length(normal);
        const bool sound = n >= 3 && length > 0 && std::isfinite(length);
        if (sound) normal /= length;
        Real radius2 = 0;
        for (std::uint32_t i = 0; i < n; ++i) {
            const Vec3 out = corner(f, i) - centre;
            radius2 = std::max(radius2, glm::dot(out, out));
        }
        planes_.push_back({normal, glm::dot(normal, centre), sound, centre, 1.001L * radius2});
    }
}

Vec3 BruteForce::corner(std::uint32_t face, std::uint32_t i) const {
    return Vec3(scene_.corner(scene_.faces[face], i));
}

Real BruteForce::height(const Vec3& point, std::uint32_t face) const {
    return glm::dot(planes_[face].normal, point) - planes_[face].offset;
}

bool BruteForce::coplanar(std::uint32_t face, std::uint32_t other) const {
    const Plane& plane = planes_[other];
    if (glm::length(glm::cross(planes_[face].normal, plane.normal)) > 1e-9L) return false;
    const Vec3 a = corner(face, 0), b = corner(other, 0);
    return std::abs(glm::dot(plane.normal, a - b)) <=
           1e-9L * std::max(glm::length(a), glm::length(b));
}

Ray BruteForce::ray_through(glm::dvec2 pixel) const {
    const StraightCamera& camera = scene_.camera;
    const auto& m = camera.to_pixels;
    const auto entry = [&](int row, int column) { return Real(m[column][row]); };
    using Mat3 = glm::mat<3, 3, Real>;
    // Unknown: a point P of the line of sight. Two planes through the eye hold it,
    // row 0 - px row 2 and row 1 - py row 2; the third says how deep.
    Vec3 rows[3];
    Real right[3];
    for (int axis = 0; axis < 2; ++axis) {
        const Real p = axis == 0 ? pixel.x : pixel.y;
        for (int c = 0; c < 3; ++c) rows[axis][c] = entry(axis, c) - p * entry(2, c);
        right[axis] = -(entry(axis, 3) - p * entry(2, 3));
    }
    rows[2] = Vec3(glm::dvec3(camera.depth));
    right[2] = -Real(camera.depth.w);
    const Mat3 system = glm::transpose(Mat3(rows[0], rows[1], rows[2]));
    const Mat3 inverse = glm::inverse(system);
    const Vec3 direction = inverse * Vec3(0, 0, 1);  // deeper by 1
    const Vec3 origin = camera.eye.w == 0 ? inverse * Vec3(right[0], right[1], right[2])
                                          : Vec3(glm::dvec3(camera.eye)) / Real(camera.eye.w);
    return {origin, direction, 0};
}

std::optional<glm::dvec2> BruteForce::project(const Vec3& point) const {
    if (!(dot4(scene_.camera.depth, point) > 0)) return std::nullopt;
    const auto& m = scene_.camera.to_pixels;
    Real h[3];
    for (int r = 0; r < 3; ++r)
        h[r] = Real(m[0][r]) * point.x + Real(m[1][r]) * point.y + Real(m[2][r]) * point.z +
               Real(m[3][r]);
    return glm::dvec2(double(h[0] / h[2]), double(h[1] / h[2]));
}

std::optional<Real> BruteForce::meet(const Ray& ray, std::uint32_t face) const {
    const Plane& plane = planes_[face];
    if (!plane.sound) return std::nullopt;
    const Vec3 past = glm::cross(ray.direction, plane.centre - ray.origin);
    if (glm::dot(past, past) > plane.radius2 * glm::dot(ray.direction, ray.direction))
        return std::nullopt;
    const Real slope = glm::dot(plane.normal, ray.direction);
    if (slope == 0) return std::nullopt;
    const Real t = (plane.offset - glm::dot(plane.normal, ray.origin)) / slope;
    if (!(t > ray.start)) return std::nullopt;
    // The line passes each side of the polygon on the same hand. The sign of a side's determinant
    // is the same for both faces that share it, so no line slips between them.
    int hand = 0;
    const std::uint32_t n = scene_.faces[face].count;
    for (std::uint32_t i = 0; i < n; ++i) {
        std::uint32_t a = i, b = (i + 1) % n;
        Vec3 from = corner(face, a) - ray.origin, to = corner(face, b) - ray.origin;
        const Real side = glm::dot(ray.direction, glm::cross(from, to));
        if (side == 0) continue;
        const int sign = side > 0 ? 1 : -1;
        if (hand != 0 && sign != hand) return std::nullopt;
        hand = sign;
    }
    return hand == 0 ? std::nullopt : std::optional<Real>(t);
}

Sight BruteForce::look(glm::dvec2 pixel) const {
    Sight sight;
    follow(ray_through(pixel), {}, sight);
    return sight;
}

/// Where a line meets two faces, one is within reach of touching the other; where they share a
/// corner, all points near it are, and nothing is in doubt.
bool BruteForce::hardly_apart(const Ray& ray, Real at, std::uint32_t face, Real beyond,
                              std::uint32_t other) const {
    const Real reach = near_plane * at * glm::length(ray.direction);
    if (std::abs(height(ray.origin + beyond * ray.direction, face)) > reach &&
        std::abs(height(ray.origin + at * ray.direction, other)) > reach)
        return false;
    const Face &a = scene_.faces[face], &b = scene_.faces[other];
    for (std::uint32_t i = 0; i < a.count; ++i)
        for (std::uint32_t j = 0; j < b.count; ++j)
            if (scene_.corner(a, i) == scene_.corner(b, j)) return false;
    return true;
}

/// `from`: where the line comes from, a mirror or (all zero) the eye.
void BruteForce::follow(const Ray& ray, const Hit& from, Sight& sight) const {
    struct Met {
        Real t;
        std::uint32_t face;
    };
    std::vector<Met> met;
    for (std::uint32_t f = 0; f < scene_.faces.size(); ++f) {
        const Face& face = scene_.faces[f];
        if (!(from.mirrors == 0 ? face.visible : face.reflected)) continue;
        if (const auto t = meet(ray, f)) met.push_back({*t, f});
    }
    std::sort(met.begin(), met.end(),
              [](const Met& a, const Met& b) { return a.t != b.t ? a.t < b.t : a.face < b.face; });
    const Real length = glm::length(ray.direction);
    for (std::size_t i = 0; i < met.size(); ++i) {
        const Face& face = scene_.faces[met[i].face];
        for (std::size_t j = i + 1; j < met.size(); ++j) {
            if (met[j].t > 1.1L * met[i].t) break;
            if (hardly_apart(ray, met[i].t, met[i].face, met[j].t, met[j].face)) sight.tie = true;
        }
        Hit hit{.face = met[i].face,
                .point = ray.origin + met[i].t * ray.direction,
                .distance = from.distance + met[i].t * length,
                .from_mirror = met[i].t * length,
                .mirrors = from.mirrors,
                .path = from.path};
        const Real slope = glm::dot(planes_[hit.face].normal, ray.direction) / length;
        if (std::abs(slope) < edge_on) sight.edge_on = true;
        light(hit, -ray.direction, sight);
        sight.hits.push_back(hit);
        if (face.mirror > 0 && int(from.mirrors) < mirror_depth_) {
            const Vec3 normal = planes_[hit.face].normal;
            const Vec3 turned = ray.direction - 2 * glm::dot(ray.direction, normal) * normal;
            Hit mirror = hit;
            ++mirror.mirrors;
            mirror.path = hit.path * 1000003 + hit.face + 1;
            // Starts past what touches the mirror where it is seen.
            follow({hit.point, turned, contact * hit.distance / length}, mirror, sight);
        }
        if (!face.transparent) break;
    }
}

void BruteForce::light(Hit& hit, const Vec3& towards_eye, Sight& sight) const {
    const Real facing = glm::dot(planes_[hit.face].normal, towards_eye);
    for (std::size_t l = 0; l < scene_.lights.size(); ++l) {
        const glm::dvec4& at = scene_.lights[l].position;
        const bool parallel = at.w == 0;
        const Vec3 towards =
            parallel ? Vec3(glm::dvec3(at)) : Vec3(glm::dvec3(at)) / Real(at.w) - hit.point;
        const Real reach = glm::length(towards);
        const Real slope = glm::dot(planes_[hit.face].normal, towards) / reach;
        if (std::abs(slope) < graze) sight.tie = true;
        if (slope * facing < 0 && !scene_.faces[hit.face].lit_from_behind) continue;
        const Real skip = parallel ? contact * hit.distance / reach : contact;
        bool dark = false, filtered = false;
        for (std::uint32_t f = 0; f < scene_.faces.size() && !dark; ++f) {
            if (f == hit.face || !scene_.faces[f].casts_shadow) continue;
            const auto t = meet({hit.point, towards, skip}, f);
            if (!t || (!parallel && *t > 1 - contact)) continue;
            (scene_.faces[f].transparent ? filtered : dark) = true;
        }
        if (!dark) hit.lit |= 1U << l;
        if (!dark && filtered) hit.filtered |= 1U << l;
    }
}

bool BruteForce::eye_sees(const Vec3& point) const {
    const auto pixel = project(point);
    if (!pixel) return false;
    const Real depth = dot4(scene_.camera.depth, point);
    const Ray ray = ray_through(*pixel);
    const Vec3 origin = scene_.camera.eye.w == 0 ? point - depth * ray.direction : ray.origin;
    for (std::uint32_t f = 0; f < scene_.faces.size(); ++f) {
        const Face& face = scene_.faces[f];
        if (!face.visible || face.transparent) continue;
        const auto t = meet({origin, point - origin, 0}, f);
        if (t && *t < 1 - contact) return false;
    }
    return true;
}

std::vector<Vec3> BruteForce::beyond(const Vec3& from, const Vec3& through, bool parallel) const {
    const Vec3 direction = parallel ? -from : through - from;
    const Ray ray{parallel ? through : from, direction, 0};
    const Real past = parallel ? contact : 1 + contact;
    std::vector<Vec3> points;
    for (std::uint32_t f = 0; f < scene_.faces.size(); ++f)
        if (const auto t = meet(ray, f); t && *t > past)
            points.push_back(ray.origin + *t * direction);
    return points;
}

Vec3 BruteForce::mirrored(const Vec3& point, std::uint32_t face) const {
    return point - 2 * height(point, face) * planes_[face].normal;
}

}  // namespace povpreview
