// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/core/polygonal/scene_builder.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

namespace povpreview {
namespace {

struct Frame {
    glm::dvec3 right, up, forward;
};

Frame frame(glm::dvec3 from, glm::dvec3 to) {
    const glm::dvec3 forward = glm::normalize(to - from);
    const glm::dvec3 aside = std::abs(forward.y) > .99 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 right = glm::normalize(glm::cross(aside, forward));
    return {right, glm::cross(forward, right), forward};
}

}  // namespace

std::uint32_t SceneBuilder::point(glm::dvec3 at) {
    scene.points.push_back(at);
    return std::uint32_t(scene.points.size() - 1);
}

void SceneBuilder::face(const std::vector<std::uint32_t>& corners, std::uint32_t surface) {
    Face made = style;
    made.first = std::uint32_t(scene.corners.size());
    made.count = std::uint32_t(corners.size());
    made.surface = surface;
    scene.corners.insert(scene.corners.end(), corners.begin(), corners.end());
    scene.faces.push_back(made);
}

void SceneBuilder::polygon(const std::vector<glm::dvec3>& corners) {
    std::vector<std::uint32_t> indices;
    for (const glm::dvec3& at : corners) indices.push_back(point(at));
    face(indices, next_surface_++);
}

void SceneBuilder::mesh(const std::vector<glm::dvec3>& points,
                        const std::vector<std::vector<std::uint32_t>>& faces, bool one_surface) {
    std::vector<std::uint32_t> shared;
    if (share_points_)
        for (const glm::dvec3& at : points) shared.push_back(point(at));
    for (const auto& corners : faces) {
        std::vector<std::uint32_t> indices;
        for (const std::uint32_t c : corners)
            indices.push_back(share_points_ ? shared[c] : point(points[c]));
        face(indices, next_surface_);
        if (!one_surface) ++next_surface_;
    }
    if (one_surface) ++next_surface_;
}

void SceneBuilder::box(glm::dvec3 centre, glm::dvec3 half, const glm::dmat3& turn) {
    std::vector<glm::dvec3> points;
    for (int i = 0; i < 8; ++i)
        points.push_back(centre + turn * glm::dvec3(i & 1 ? half.x : -half.x,
                                                    i & 2 ? half.y : -half.y,
                                                    i & 4 ? half.z : -half.z));
    mesh(points,
         {{0, 2, 6, 4}, {1, 5, 7, 3}, {0, 4, 5, 1}, {2, 3, 7, 6}, {0, 1, 3, 2}, {4, 6, 7, 5}},
         false);
}

void SceneBuilder::ball(glm::dvec3 centre, double radius, int slices, int stacks, bool smooth,
                        bool triangles) {
    std::vector<glm::dvec3> points{centre + glm::dvec3(0, radius, 0)};
    for (int i = 1; i < stacks; ++i)
        for (int j = 0; j < slices; ++j) {
            const double down = std::numbers::pi * i / stacks;
            const double round = 2 * std::numbers::pi * j / slices;
            points.push_back(centre + radius * glm::dvec3(std::sin(down) * std::cos(round),
                                                          std::cos(down),
                                                          std::sin(down) * std::sin(round)));
        }
    points.push_back(centre - glm::dvec3(0, radius, 0));
    std::vector<std::vector<std::uint32_t>> faces;
    const auto at = [&](int stack, int slice) {
        if (stack == 0) return 0U;
        if (stack == stacks) return std::uint32_t(points.size() - 1);
        return std::uint32_t(1 + (stack - 1) * slices + slice % slices);
    };
    for (int i = 0; i < stacks; ++i)
        for (int j = 0; j < slices; ++j) {
            const std::uint32_t a = at(i, j), b = at(i, j + 1), c = at(i + 1, j + 1),
                                d = at(i + 1, j);
            if (i == 0)
                faces.push_back({a, c, d});
            else if (i == stacks - 1)
                faces.push_back({a, b, d});
            else if (triangles) {
                faces.push_back({a, b, c});
                faces.push_back({a, c, d});
            } else
                faces.push_back({a, b, c, d});
        }
    const std::uint32_t before = style.smooth;
    style.smooth = smooth ? next_smooth_++ : 0;
    mesh(points, faces, true);
    style.smooth = before;
}

void SceneBuilder::terrain(double half, int cells, double height, bool smooth) {
    std::vector<glm::dvec3> points;
    for (int i = 0; i <= cells; ++i)
        for (int j = 0; j <= cells; ++j) {
            const double x = half * (2. * j / cells - 1), z = half * (2. * i / cells - 1);
            const double u = 9 * x / half, v = 9 * z / half;
            const double y = std::sin(u) * std::cos(.8 * v) + .5 * std::sin(2.3 * u + 1.7 * v) +
                             .25 * std::sin(5.1 * v - 3.3 * u);
            points.push_back({x, height * y, z});
        }
    std::vector<std::vector<std::uint32_t>> faces;
    for (int i = 0; i < cells; ++i)
        for (int j = 0; j < cells; ++j) {
            const auto a = std::uint32_t(i * (cells + 1) + j), b = a + std::uint32_t(cells) + 1;
            faces.push_back({a, a + 1, b + 1});
            faces.push_back({a, b + 1, b});
        }
    const std::uint32_t before = style.smooth;
    style.smooth = smooth ? next_smooth_++ : 0;
    mesh(points, faces, true);
    style.smooth = before;
}

void SceneBuilder::floor(double y, double half) {
    polygon({{-half, y, -half}, {half, y, -half}, {half, y, half}, {-half, y, half}});
}

void SceneBuilder::light(glm::dvec3 position, float brightness) {
    scene.lights.push_back(
        {glm::dvec4(position, 1), brightness, std::uint32_t(scene.lights.size())});
}

void SceneBuilder::parallel_light(glm::dvec3 towards, float brightness) {
    scene.lights.push_back(
        {glm::dvec4(towards, 0), brightness, std::uint32_t(scene.lights.size())});
}

void SceneBuilder::look(glm::dvec3 eye, glm::dvec3 target, double angle, int width, int height) {
    const Frame axes = frame(eye, target);
    const double scale = width / 2. / std::tan(angle / 2);
    // Rows of (x, y, z, 1) -> (w px, w py, w); w is the depth, y of the image runs down.
    const glm::dvec3 rows[3] = {scale * axes.right + width / 2. * axes.forward,
                                -scale * axes.up + height / 2. * axes.forward, axes.forward};
    StraightCamera& camera = scene.camera;
    for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 3; ++c) camera.to_pixels[c][r] = rows[r][c];
        camera.to_pixels[3][r] = -glm::dot(rows[r], eye);
    }
    camera.eye = glm::dvec4(eye, 1);
    camera.depth = glm::dvec4(axes.forward, -glm::dot(axes.forward, eye));
    scene.width = width;
    scene.height = height;
}

void SceneBuilder::look_parallel(glm::dvec3 location, glm::dvec3 target, double extent, int width,
                                 int height) {
    const Frame axes = frame(location, target);
    const double scale = width / extent;
    const glm::dvec3 rows[2] = {scale * axes.right, -scale * axes.up};
    const double middle[2] = {width / 2., height / 2.};
    StraightCamera& camera = scene.camera;
    for (int r = 0; r < 2; ++r) {
        for (int c = 0; c < 3; ++c) camera.to_pixels[c][r] = rows[r][c];
        camera.to_pixels[3][r] = middle[r] - glm::dot(rows[r], location);
    }
    for (int c = 0; c < 3; ++c) camera.to_pixels[c][2] = 0;
    camera.to_pixels[3][2] = 1;
    camera.eye = glm::dvec4(-axes.forward, 0);
    camera.depth = glm::dvec4(axes.forward, -glm::dot(axes.forward, location));
    scene.width = width;
    scene.height = height;
}

glm::dmat3 turn_about(glm::dvec3 axis, double angle) {
    return glm::dmat3(glm::rotate(glm::dmat4(1), angle, axis));
}

}  // namespace povpreview
