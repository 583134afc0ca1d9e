// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/polygonal/view.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/polygonal/sides.h"

namespace povpreview {
namespace {

/// A parallel view begins at the camera's plane, a perspective one at the eye.
std::optional<NearPlane> camera_plane(const StraightCamera& camera) {
    if (camera.eye.w != 0) return std::nullopt;
    const glm::dvec3 normal(camera.depth);
    const double length = glm::length(normal);
    return NearPlane{normal / length, -normal * (camera.depth.w / (length * length))};
}

NearPlane seen_side(const View& before, const FlatFaces& faces, std::size_t mirror) {
    return {faces[mirror].normal * double(before.volumes().facing(mirror)), faces[mirror].on};
}

glm::dvec4 reflected(const glm::dvec4& viewpoint, const NearPlane& mirror) {
    return viewpoint - glm::dvec4(2 * mirror.height(viewpoint) * mirror.normal, 0);
}

}  // namespace

View::View(const PolygonScene& scene, const FlatFaces& faces, const FaceHierarchy& hierarchy)
    : scene_(scene),
      faces_(faces),
      hierarchy_(hierarchy),
      volumes_(faces, hierarchy, scene.camera.eye, Viewer::eye, camera_plane(scene.camera)) {}

View::View(const View& before, std::size_t mirror)
    : scene_(before.scene_),
      faces_(before.faces_),
      hierarchy_(before.hierarchy_),
      before_(&before),
      mirror_(mirror),
      strength_(before.strength_ * faces_.face(mirror).mirror),
      volumes_(faces_, hierarchy_,
               reflected(before.volumes_.viewpoint(), seen_side(before, faces_, mirror)),
               Viewer::mirror, seen_side(before, faces_, mirror)) {}

std::size_t View::window_planes() const { return before_ ? 1 + faces_.corners(mirror_).size() : 5; }

double View::inside(std::size_t plane, const glm::dvec3& p) const {
    if (before_) {
        if (plane > 0) return volumes_.side_of(mirror_, static_cast<std::uint32_t>(plane - 1), p);
        return volumes_.near()->height(p) - contact * faces_.scale(p);
    }
    const glm::dvec4 h(p, 1);
    const glm::dvec3 pixel = scene_.camera.to_pixels * h;
    switch (plane) {
        case 0:
            return glm::dot(scene_.camera.depth, h);
        case 1:
            return pixel.x;
        case 2:
            return scene_.width * pixel.z - pixel.x;
        case 3:
            return pixel.y;
        default:
            return scene_.height * pixel.z - pixel.y;
    }
}

bool View::clip_to_window(const SpaceSegment& segment, Interval& part) const {
    for (std::size_t plane = 0; plane < window_planes(); ++plane)
        if (!clip(part, inside(plane, segment.a), inside(plane, segment.b))) return false;
    return true;
}

/// Where the line of sight to a point passes through the mirror.
glm::dvec3 View::on_mirror(const glm::dvec3& p) const {
    const glm::dvec4& v = volumes_.viewpoint();
    const NearPlane& near = *volumes_.near();
    const double height = near.height(p), beyond = near.height(v);
    if (v.w == 0) return p - glm::dvec3(v) * (height / beyond);
    return p + (glm::dvec3(v) - p) * (height / (height - beyond));
}

glm::dvec2 View::to_image(const glm::dvec3& p) const {
    if (before_) return before_->to_image(on_mirror(p));
    const glm::dvec3 h = scene_.camera.to_pixels * glm::dvec4(p, 1);
    return glm::clamp(glm::dvec2(h.x / h.z, h.y / h.z), glm::dvec2(0),
                      glm::dvec2(scene_.width, scene_.height));
}

void View::hide(const SpaceSegment& segment, IntervalSet& left) const {
    Interval part;
    if (!clip_to_window(segment, part)) return left.subtract({0, 1});
    left.subtract({0, part.from});
    left.subtract({part.to, 1});
    volumes_.hide(segment, left);
}

void View::show(const glm::dvec3& a, const glm::dvec3& b,
                const std::function<void(glm::dvec2, glm::dvec2)>& shown) const {
    if (!before_) return shown(to_image(a), to_image(b));
    const SpaceSegment segment{on_mirror(a), on_mirror(b)};
    IntervalSet left;
    left.assign({});
    before_->hide(segment, left);
    for (const Interval& part : left.intervals())
        before_->show(segment.at(part.from), segment.at(part.to), shown);
}

/// Clips the face by the window's planes, one after the other (Sutherland and Hodgman 1974).
double View::image_area(std::size_t face) const {
    std::vector<glm::dvec3> polygon, clipped;
    for (const std::uint32_t corner : faces_.corners(face)) polygon.push_back(faces_.point(corner));
    for (std::size_t plane = 0; plane < window_planes(); ++plane) {
        clipped.clear();
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const glm::dvec3 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
            const double at_p = inside(plane, p), at_q = inside(plane, q);
            if (at_p > 0) clipped.push_back(p);
            if ((at_p > 0) != (at_q > 0)) clipped.push_back(p + (q - p) * (at_p / (at_p - at_q)));
        }
        polygon.swap(clipped);
    }
    double twice = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec2 p = to_image(polygon[i]), q = to_image(polygon[(i + 1) % polygon.size()]);
        twice += p.x * q.y - p.y * q.x;
    }
    return std::abs(twice) / 2;
}

}  // namespace povpreview
