// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/end_to_end/geometry_agreement.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <random>
#include <unordered_set>

#include "core/error.h"

namespace povpreview {

/// The two planes (px w - x = 0, py w - y = 0) that meet in the ray of a position.
Ray ray_through(const StraightCamera& camera, const glm::dvec2& position) {
    const auto row = [&](int i) {
        return glm::dvec4(camera.to_pixels[0][i], camera.to_pixels[1][i], camera.to_pixels[2][i],
                          camera.to_pixels[3][i]);
    };
    const glm::dvec4 a = row(0) - position.x * row(2), b = row(1) - position.y * row(2);
    glm::dvec3 direction = glm::normalize(glm::cross(glm::dvec3(a), glm::dvec3(b)));
    if (glm::dot(direction, glm::dvec3(camera.depth)) < 0) direction = -direction;
    if (camera.eye.w != 0) return {glm::dvec3(camera.eye) / camera.eye.w, direction};
    const glm::dmat3 planes =
        glm::transpose(glm::dmat3(glm::dvec3(a), glm::dvec3(b), glm::dvec3(camera.depth)));
    return {glm::inverse(planes) * -glm::dvec3(a.w, b.w, camera.depth.w), direction};
}

namespace {

std::vector<glm::dvec3> corners_of(const PolygonScene& scene, const Face& face) {
    std::vector<glm::dvec3> corners;
    for (std::size_t i = 0; i < face.count; ++i) corners.push_back(scene.corner(face, i));
    return corners;
}

glm::dvec3 area_of(const std::vector<glm::dvec3>& corners) {
    glm::dvec3 area(0);
    for (std::size_t i = 2; i < corners.size(); ++i)
        area += glm::cross(corners[i - 1] - corners[0], corners[i] - corners[0]);
    return area;
}

/// Depth of the hit along the ray, negative if there is none. Edges belong to the face.
double hit(const Ray& ray, const std::vector<glm::dvec3>& corners, const glm::dvec3& normal) {
    const double slope = glm::dot(normal, ray.direction);
    if (slope == 0) return -1;
    const double depth = glm::dot(normal, corners[0] - ray.origin) / slope;
    bool left = false, right = false;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const glm::dvec3 a = corners[i] - ray.origin,
                         b = corners[(i + 1) % corners.size()] - ray.origin;
        const double side = glm::dot(glm::cross(a, b), ray.direction);
        left = left || side > 0;
        right = right || side < 0;
    }
    return left && right ? -1 : depth;
}

struct ImageBounds {
    glm::dvec2 low{0}, high{0};
};

/// Of the image of a face; all of the image if the face reaches behind the eye.
ImageBounds bounds_of(const PolygonScene& scene, const std::vector<glm::dvec3>& corners) {
    ImageBounds all{{0, 0}, {scene.width, scene.height}};
    ImageBounds result{all.high, all.low};
    bool before = false, behind = false;
    for (const glm::dvec3& corner : corners) {
        const glm::dvec3 p = scene.camera.to_pixels * glm::dvec4(corner, 1);
        const double depth = glm::dot(scene.camera.depth, glm::dvec4(corner, 1));
        (depth > 1e-9 ? before : behind) = true;
        result.low = glm::min(result.low, glm::dvec2(p) / p.z);
        result.high = glm::max(result.high, glm::dvec2(p) / p.z);
    }
    if (!before) return {{0, 0}, {-1, -1}};
    return behind ? all : result;
}

/// Distance of a position to the outline of a face in the image, pixels; a lot if the face reaches
/// behind the eye.
double distance_to_outline(const PolygonScene& scene, const std::vector<glm::dvec3>& corners,
                           const glm::dvec2& position) {
    std::vector<glm::dvec2> outline;
    for (const glm::dvec3& corner : corners) {
        const glm::dvec3 p = scene.camera.to_pixels * glm::dvec4(corner, 1);
        if (glm::dot(scene.camera.depth, glm::dvec4(corner, 1)) <= 0) return 1e9;
        outline.push_back(glm::dvec2(p) / p.z);
    }
    double nearest = 1e9;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const glm::dvec2 a = outline[i], ab = outline[(i + 1) % outline.size()] - a;
        const double length2 = glm::dot(ab, ab);
        const double t = length2 > 0 ? glm::dot(position - a, ab) / length2 : 0;
        nearest = std::min(nearest, glm::length(position - a - std::clamp(t, 0., 1.) * ab));
    }
    return nearest;
}

/// What faces were found along the ray of a probe, or within a hair of it.
struct Found {
    bool matching = false, nearly_matching = false;
    bool in_front = false, surely_in_front = false;
    std::uint32_t nearest = 0;
    double depth = 1e30;  ///< of the nearest
};

/// Probes by the pixel that they are in.
class PixelBins {
   public:
    PixelBins(const PolygonScene& scene, std::span<const Sample> probes)
        : width_(scene.width), height_(scene.height), bins_(std::size_t(width_) * height_) {
        for (std::size_t i = 0; i < probes.size(); ++i)
            bins_[bin(int(probes[i].position.x), int(probes[i].position.y))].push_back(i);
    }
    template <class See>
    void for_each_in(const ImageBounds& bounds, See see) const {
        const int y_end = std::min(height_ - 1, int(std::min(bounds.high.y + 1, 1e6))),
                  x_end = std::min(width_ - 1, int(std::min(bounds.high.x + 1, 1e6)));
        for (int y = int(std::max(0., bounds.low.y - 1)); y <= y_end; ++y)
            for (int x = int(std::max(0., bounds.low.x - 1)); x <= x_end; ++x)
                for (const std::size_t i : bins_[bin(x, y)]) see(i);
    }

   private:
    std::size_t bin(int x, int y) const {
        return std::size_t(std::clamp(y, 0, height_ - 1)) * width_ + std::clamp(x, 0, width_ - 1);
    }
    int width_, height_;
    std::vector<std::vector<std::size_t>> bins_;
};

/// POV-Ray keeps meshes in single precision and answers with single precision depths; both count
/// the more, the more the ray grazes the face.
double tolerance(double depth, const glm::dvec3& at, double cosine) {
    return 1e-5 * (depth + glm::length(at)) / std::max(std::fabs(cosine), 1e-3);
}

}  // namespace

namespace {

/// One face against the probes whose positions are near its image.
void see_face(const PolygonScene& scene, const Face& face, std::span<const Sample> probes,
              const std::vector<Ray>& rays, const PixelBins& bins, std::vector<Found>& found) {
    const std::vector<glm::dvec3> corners = corners_of(scene, face);
    const glm::dvec3 area = area_of(corners);
    if (!(glm::length(area) > 0)) return;
    const glm::dvec3 normal = glm::normalize(area);
    bins.for_each_in(bounds_of(scene, corners), [&](std::size_t i) {
        const Sample& probe = probes[i];
        const auto by_a_hair = [&] {
            return distance_to_outline(scene, corners, probe.position) < hair;
        };
        Found& seen = found[i];
        if (probe.surface == face.surface && !seen.nearly_matching)
            seen.nearly_matching = by_a_hair();
        const double depth = hit(rays[i], corners, normal);
        if (depth < too_near || depth > too_far) return;
        const double slack = tolerance(depth, rays[i].origin + depth * rays[i].direction,
                                       glm::dot(normal, rays[i].direction));
        if (depth < seen.depth) {
            seen.depth = depth;
            seen.nearest = face.surface;
        }
        if (probe.surface == 0 || depth < probe.depth - slack) {
            seen.in_front = true;
            seen.surely_in_front = seen.surely_in_front || !by_a_hair();
        } else if (probe.surface == face.surface && depth < probe.depth + slack) {
            seen.matching = true;
        }
    });
}

}  // namespace

std::vector<NearestFace> nearest_faces(const PolygonScene& scene,
                                       std::span<const glm::dvec2> positions) {
    std::vector<Ray> rays;
    std::vector<Sample> at;
    for (const glm::dvec2& position : positions) {
        rays.push_back(ray_through(scene.camera, position));
        at.push_back({.position = position});
    }
    const PixelBins bins(scene, at);
    std::vector<NearestFace> nearest(positions.size());
    for (const Face& face : scene.faces) {
        if (!face.visible || face.count < 3) continue;
        const std::vector<glm::dvec3> corners = corners_of(scene, face);
        const glm::dvec3 area = area_of(corners);
        if (!(glm::length(area) > 0)) continue;
        const glm::dvec3 normal = glm::normalize(area);
        bins.for_each_in(bounds_of(scene, corners), [&](std::size_t i) {
            const double depth = hit(rays[i], corners, normal);
            if (depth < too_near || depth > too_far) return;
            NearestFace& known = nearest[i];
            const double slack = 1e-6 * (1 + depth);
            if (depth < known.depth - slack)
                known = {face.surface, depth, &face, {}};
            else if (depth < known.depth + slack)
                known.others.push_back(face.surface);
        });
    }
    return nearest;
}

GeometryAgreement compare_geometry(const PolygonScene& scene, std::span<const Sample> probes) {
    std::vector<Ray> rays;
    for (const Sample& probe : probes) rays.push_back(ray_through(scene.camera, probe.position));
    const PixelBins bins(scene, probes);
    std::vector<Found> found(probes.size());
    std::unordered_set<std::uint32_t> surfaces;
    for (const Face& face : scene.faces) {
        if (!face.visible || face.count < 3) continue;
        surfaces.insert(face.surface);
        see_face(scene, face, probes, rays, bins, found);
    }
    GeometryAgreement result;
    for (std::size_t i = 0; i < probes.size(); ++i) {
        if (probes[i].failed) continue;
        const Found& seen = found[i];
        const bool on_face = surfaces.count(probes[i].surface) > 0;
        const bool missing = on_face && !seen.matching && !seen.in_front && !seen.nearly_matching;
        const bool agrees = !seen.in_front && (seen.matching || !on_face);
        ++result.probes;
        result.on_faces += on_face;
        result.missing += missing;
        result.in_front += seen.surely_in_front;
        result.at_edges += !agrees && !missing && !seen.surely_in_front;
        if ((missing || seen.surely_in_front) && result.examples.size() < 20)
            result.examples.push_back({i, seen.nearest, seen.depth});
    }
    return result;
}

std::vector<glm::dvec2> probing_positions(const PolygonScene& scene, std::size_t limit,
                                          unsigned seed) {
    std::mt19937 random(seed);
    std::vector<std::size_t> order(scene.faces.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::shuffle(order.begin(), order.end(), random);
    std::vector<glm::dvec2> positions;
    for (const std::size_t f : order) {
        if (positions.size() >= limit) break;
        glm::dvec3 inside(0);
        double sum = 0;
        for (const glm::dvec3& corner : corners_of(scene, scene.faces[f])) {
            const double weight = .05 + std::uniform_real_distribution<>(0, 1)(random);
            inside += weight * corner;
            sum += weight;
        }
        const glm::dvec4 at(inside / sum, 1);
        const glm::dvec3 p = scene.camera.to_pixels * at;
        const glm::dvec2 pixel = glm::dvec2(p) / p.z;
        if (glm::dot(scene.camera.depth, at) > 0 && pixel.x > 0 && pixel.y > 0 &&
            pixel.x < scene.width && pixel.y < scene.height)
            positions.push_back(pixel);
    }
    for (int y = 0; y < scene.height; ++y)
        for (int x = 0; x < scene.width; ++x) positions.push_back({x + .5, y + .5});
    return positions;
}

std::vector<Sample> probe(PovrayOracle& oracle, std::span<const glm::dvec2> positions) {
    std::vector<Request> requests;
    for (const glm::dvec2& position : positions) requests.push_back({position, RayKind::probe});
    oracle.submit(requests, Parts::surface);
    std::vector<Sample> samples;
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(300);
    while (samples.size() < positions.size()) {
        oracle.collect(samples, std::chrono::milliseconds(20));
        if (std::chrono::steady_clock::now() > deadline)
            throw Error(Exit::tracer, "samples stay out", "", "");
    }
    return samples;
}

}  // namespace povpreview
