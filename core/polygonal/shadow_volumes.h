// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <vector>

#include "core/polygonal/face_hierarchy.h"
#include "core/polygonal/flat_faces.h"
#include "core/polygonal/interval_set.h"

namespace povpreview {

/// A straight piece of an edge in space.
struct SpaceSegment {
    static constexpr std::uint32_t constructed = 0xffffffff;

    glm::dvec3 a{0}, b{0};
    /// Which points of the scene its ends are; sides of constructed ends are decided as well as
    /// their own rounding allows, those of points exactly.
    std::uint32_t point_a = constructed, point_b = constructed;

    glm::dvec3 at(double t) const { return a + t * (b - a); }
};

/// Who looks: decides which faces are there.
enum class Viewer : std::uint8_t { eye, light, mirror };

/// A plane that a view begins at: what is behind it is not there. A mirror, seen from behind.
struct NearPlane {
    glm::dvec3 normal, on;  ///< the normal shows to where things are

    double height(const glm::dvec3& p) const { return glm::dot(normal, p - on); }
    /// Of a viewpoint; far away, the cosine.
    double height(const glm::dvec4& v) const { return glm::dot(normal, glm::dvec3(v) - v.w * on); }
};

/// The shadow volumes of all faces as seen from one viewpoint (paper, section 3; Chin and Feiner
/// 1989): what lies in one of them is hidden.
///
///            ____ face
///        .  /   /.        the volume: inside the planes through the viewpoint and the face's
///     v    /___/    .     edges, behind the face
///        .           .
///
/// Chin and Feiner keep their union as a BSP tree, into which faces go from front to back, split by
/// each other's planes. Here each volume stays whole, in a hierarchy of boxes: a segment is tested
/// against those that reach into the triangle between it and the viewpoint. So every side test is
/// one of the scene's own points against a plane through its own points, which can be decided
/// exactly, and no error is handed down from split to split. Not for several threads at a time.
class ShadowVolumes {
   public:
    /// All arguments must outlive it.
    ShadowVolumes(const FlatFaces& faces, const FaceHierarchy& hierarchy,
                  const glm::dvec4& viewpoint, Viewer viewer,
                  const std::optional<NearPlane>& near = std::nullopt);

    const glm::dvec4& viewpoint() const { return viewpoint_; }
    const std::optional<NearPlane>& near() const { return near_; }
    /// +1 or -1: which side of the face is seen; 0: its edge only.
    int facing(std::size_t face) const { return volumes_[face].facing; }

    /// Takes off `left` what is hidden of the segment.
    void hide(const SpaceSegment& segment, IntervalSet& left) const;

    /// The first face behind a part of a segment, seen from the viewpoint.
    struct Backdrop {
        Interval part;
        /// For each end of the part, linear in between: 1 / (how many times as far as the segment
        /// the face is); from far away, -(distance behind the segment).
        double nearness_from, nearness_to;
        std::uint32_t face;
    };
    /// Where the shadow of a segment falls: every face that is met first behind it, and those
    /// before it that let light through.
    void cast(const SpaceSegment& segment, std::vector<Backdrop>& backdrops) const;
    /// The place behind the segment's point at t.
    glm::dvec3 behind(const SpaceSegment& segment, double t, double nearness) const {
        return behind(segment.at(t), nearness);
    }

    /// Positive where a point is on the inner side of the plane through the viewpoint and an edge
    /// of a face, from its corner `edge` to the next; the sign is exact for points of the scene.
    /// REQUIRES: facing(face) != 0.
    double side_of(std::size_t face, std::uint32_t edge, const glm::dvec3& p,
                   std::uint32_t point = SpaceSegment::constructed) const;

    /// What is met first on the line of sight through a point, transparent or not.
    struct Sight {
        std::uint32_t face;
        double nearness;  ///< as Backdrop's: 1 at the point itself, from far away 0
    };
    std::optional<Sight> first_face(const glm::dvec3& through) const;
    glm::dvec3 behind(const glm::dvec3& p, double nearness) const;

   private:
    struct Volume {
        std::uint32_t first;  ///< of its planes in sides_, one for each edge of the face
        std::int8_t facing;
        bool there;     ///< for this viewer
        bool blocks;    ///< and lets nothing through
        double height;  ///< of the viewpoint over the face, on the side it sees: positive
    };
    /// A plane through the viewpoint and an edge of a face, positive inside the volume.
    struct Side {
        glm::dvec3 normal;
        double uncertainty;  ///< times the distance of the point tested
    };
    struct Ends {
        double a, b;
    };
    struct Sheet;

    bool is_there(const Face& face) const;
    void add_sides(std::size_t face);
    bool clip_to_sides(const SpaceSegment& segment, std::size_t face, Interval& part) const;
    Ends heights(const SpaceSegment& segment, std::size_t face) const;
    Ends tolerances(const SpaceSegment& segment) const;
    void hide_by(std::size_t face, const SpaceSegment& segment, const Ends& tolerance,
                 IntervalSet& left) const;
    bool cast_on(std::uint32_t face, const SpaceSegment& segment, const Ends& tolerance,
                 Backdrop& backdrop) const;
    glm::dvec3 farthest(const SpaceSegment& segment, const std::vector<Backdrop>& backdrops,
                        const glm::dvec3& direction) const;
    bool inside_sides(std::uint32_t face, const glm::dvec3& p) const;
    bool in_front(const NearPlane& near, const glm::dvec3& p) const;
    bool clip_to_near(const SpaceSegment& segment, std::size_t face, const Ends& heights,
                      Interval& part) const;

    const FlatFaces& faces_;
    const FaceHierarchy& hierarchy_;
    glm::dvec4 viewpoint_;
    Viewer viewer_;
    std::optional<NearPlane> near_;
    std::vector<Volume> volumes_;
    std::vector<Side> sides_;
    mutable std::uint32_t last_hider_ = 0xffffffff;  // of a whole segment
};

}  // namespace povpreview
