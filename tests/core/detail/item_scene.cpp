// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/core/detail/item_scene.h"

#include <cmath>

namespace povpreview::test {

namespace {

glm::dmat4x3 turned_around(const glm::dmat4x3& frame) {
    const glm::dmat3 linear(frame[0], frame[1], frame[2]);
    const glm::dmat3 back = glm::inverse(linear);
    return {back[0], back[1], back[2], -back * frame[3]};
}

Bounds around(const glm::dvec3& a, const glm::dvec3& b, double radius) {
    return {glm::min(a, b) - radius, glm::max(a, b) + radius};
}

}  // namespace

ItemScene::ItemScene(const CameraPose& camera_pose, int width, int height) : pose(camera_pose) {
    scene.polygons.camera = pose.straight(width, height);
    scene.polygons.width = width;
    scene.polygons.height = height;
    scene.looks.push_back({Look::Kind::plain, {}});
}

glm::dmat4x3 frame_along(const glm::dvec3& axis, const glm::dvec3& origin, double across,
                         double along) {
    const glm::dvec3 z = glm::normalize(axis);
    const glm::dvec3 other = std::fabs(z.x) < .6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 x = glm::normalize(glm::cross(other, z)), y = glm::cross(z, x);
    return {across * x, across * y, along * z, origin};
}

std::uint32_t ItemScene::solid(Solid::Kind kind, const glm::dmat4x3& frame,
                               const std::array<double, 10>& coefficients) {
    scene.solids.push_back({kind, turned_around(frame), coefficients});
    return static_cast<std::uint32_t>(scene.solids.size() - 1);
}

std::uint32_t ItemScene::listed_solid(Solid::Kind kind, const glm::dmat4x3& frame,
                                      const std::vector<double>& numbers) {
    const std::uint32_t made = solid(kind, frame);
    scene.solids[made].first_number = static_cast<std::uint32_t>(scene.numbers.size());
    scene.solids[made].numbers = static_cast<std::uint32_t>(numbers.size());
    scene.numbers.insert(scene.numbers.end(), numbers.begin(), numbers.end());
    return made;
}

std::uint32_t ItemScene::sphere_solid(const glm::dvec3& centre, double radius) {
    return solid(Solid::Kind::sphere, frame_along({0, 0, 1}, centre, radius, radius));
}

std::uint32_t ItemScene::half_space(const glm::dvec3& outward, const glm::dvec3& through) {
    return solid(Solid::Kind::half_space, frame_along(outward, through, 1, 1));
}

std::uint32_t ItemScene::cylinder_solid(const glm::dvec3& a, const glm::dvec3& b, double radius) {
    return solid(Solid::Kind::cylinder, frame_along(b - a, a, radius, glm::length(b - a)));
}

void ItemScene::piece(std::uint32_t of_solid, std::vector<ConditionStep> condition) {
    scene.pieces.push_back({of_solid, ++surface_, material,
                            static_cast<std::uint32_t>(scene.conditions.size()),
                            static_cast<std::uint32_t>(condition.size())});
    scene.conditions.insert(scene.conditions.end(), condition.begin(), condition.end());
}

void ItemScene::object(const Bounds& bounds) {
    const auto end = static_cast<std::uint32_t>(scene.pieces.size());
    scene.objects.push_back({bounds, first_piece_, end - first_piece_});
    first_piece_ = end;
}

void ItemScene::sphere(const glm::dvec3& centre, double radius) {
    piece(sphere_solid(centre, radius));
    object(around(centre, centre, radius));
}

void ItemScene::ellipsoid(const glm::dmat4x3& frame) {
    piece(solid(Solid::Kind::sphere, frame));
    glm::dvec3 reach;
    for (int i = 0; i < 3; ++i)
        reach[i] = glm::length(glm::dvec3(frame[0][i], frame[1][i], frame[2][i]));
    object({frame[3] - reach, frame[3] + reach});
}

void ItemScene::cylinder(const glm::dvec3& a, const glm::dvec3& b, double radius) {
    const auto side = static_cast<int>(cylinder_solid(a, b, radius));
    const auto low = static_cast<int>(half_space(a - b, a)),
               high = static_cast<int>(half_space(b - a, b));
    piece(static_cast<std::uint32_t>(side), {low, high, condition_and});
    piece(static_cast<std::uint32_t>(low), {side});
    piece(static_cast<std::uint32_t>(high), {side});
    object(around(a, b, radius));
}

void ItemScene::cone(const glm::dvec3& a, double radius_a, const glm::dvec3& b, double radius_b) {
    // The apex is where the radius, linear along the axis, is 0.
    const glm::dvec3 axis = b - a;
    const double share = radius_a / (radius_a - radius_b);
    const glm::dvec3 apex = a + share * axis;
    const double slope = std::fabs(radius_b - radius_a) / glm::length(axis);
    const auto side = static_cast<int>(solid(Solid::Kind::cone, frame_along(axis, apex, slope, 1)));
    const auto low = static_cast<int>(half_space(-axis, a)),
               high = static_cast<int>(half_space(axis, b));
    piece(static_cast<std::uint32_t>(side), {low, high, condition_and});
    piece(static_cast<std::uint32_t>(low), {side});
    piece(static_cast<std::uint32_t>(high), {side});
    object(around(a, b, std::max(radius_a, radius_b)));
}

void ItemScene::torus(const glm::dvec3& centre, const glm::dvec3& axis, double major,
                      double minor) {
    const glm::dmat4x3 along = frame_along(axis, centre, major, major);
    piece(solid(Solid::Kind::torus, {along[0], along[2], along[1], centre}, {minor / major}));
    object(around(centre, centre, major + minor));
}

void ItemScene::plane(const glm::dvec3& normal, const glm::dvec3& through) {
    piece(half_space(normal, through));
    object(everywhere);
}

void ItemScene::face(const std::vector<glm::dvec3>& corners, const std::vector<glm::vec2>& uvs) {
    PolygonScene& polygons = scene.polygons;
    Face face;
    face.first = static_cast<std::uint32_t>(polygons.corners.size());
    face.count = static_cast<std::uint32_t>(corners.size());
    face.surface = ++surface_;
    face.material = material;
    for (const glm::dvec3& p : corners) {
        polygons.corners.push_back(static_cast<std::uint32_t>(polygons.points.size()));
        polygons.points.push_back(p);
    }
    polygons.faces.push_back(face);
    if (uvs.empty() && scene.corner_uvs.empty()) return;
    scene.corner_uvs.resize(face.first);
    scene.corner_uvs.insert(scene.corner_uvs.end(), uvs.begin(), uvs.end());
    scene.corner_uvs.resize(polygons.corners.size());
}

void ItemScene::box(const glm::dvec3& low, const glm::dvec3& high) {
    for (int axis = 0; axis < 3; ++axis) {
        const int next = (axis + 1) % 3, last = (axis + 2) % 3;
        for (const glm::dvec3& end : {low, high}) {
            std::vector<glm::dvec3> corners(4, end);
            corners[0][next] = corners[3][next] = low[next];
            corners[1][next] = corners[2][next] = high[next];
            corners[0][last] = corners[1][last] = low[last];
            corners[2][last] = corners[3][last] = high[last];
            face(corners);
        }
    }
}

}  // namespace povpreview::test
