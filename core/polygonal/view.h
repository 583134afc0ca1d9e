// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>
#include <glm/vec2.hpp>
#include <vector>

#include "core/polygonal/shadow_volumes.h"

namespace povpreview {

/// A view of the scene that ends in the image: by the eye itself, or by the eye reflected at a
/// mirror, through the mirror as a window; mirrors seen in mirrors make chains of them.
///
///        eye \      | mirror      p
///             \     |           .'         The mirrored eye sees p through q; where the view
///              \    |         .'           before sees q on the mirror, the image shows p.
///               `-. |       .'
///                  `q.    .'
///                   | `-.'
///       mirrored eye  (behind the mirror: the view's viewpoint)
class View {
   public:
    /// The eye's own view.
    View(const PolygonScene& scene, const FlatFaces& faces, const FaceHierarchy& hierarchy);
    /// What `before` sees in a face of the scene. REQUIRES: before.volumes().facing(mirror) != 0.
    View(const View& before, std::size_t mirror);
    View(const View&) = delete;
    View& operator=(const View&) = delete;

    const ShadowVolumes& volumes() const { return volumes_; }
    bool mirrored() const { return before_ != nullptr; }
    /// Share of the light seen in this view that reaches the eye.
    float strength() const { return strength_; }
    /// Whether faces of this kind are there in this view.
    bool shows(const Face& face) const { return before_ ? face.reflected : face.visible; }

    /// Whether any of a segment is inside the window, hidden or not; cuts `part` down to that.
    bool clip_to_window(const SpaceSegment& segment, Interval& part) const;

    /// Takes off `left`, a part of a segment, what is not seen in this view.
    void hide(const SpaceSegment& segment, IntervalSet& left) const;
    /// Calls shown(from, to), in pixels, for what the image shows of a segment that is seen in this
    /// view.
    void show(const glm::dvec3& a, const glm::dvec3& b,
              const std::function<void(glm::dvec2, glm::dvec2)>& shown) const;

    /// Area in the image of a face, in square pixels, were it not hidden.
    double image_area(std::size_t face) const;

   private:
    // The window as planes, and a measure of how far inside of one of them a point lies.
    std::size_t window_planes() const;
    double inside(std::size_t plane, const glm::dvec3& p) const;

    glm::dvec3 on_mirror(const glm::dvec3& p) const;
    glm::dvec2 to_image(const glm::dvec3& p) const;

    const PolygonScene& scene_;
    const FlatFaces& faces_;
    const FaceHierarchy& hierarchy_;
    const View* before_ = nullptr;
    std::size_t mirror_ = 0;
    float strength_ = 1;
    ShadowVolumes volumes_;
};

}  // namespace povpreview
