// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "core/polygonal/polygon_scene.h"

namespace povpreview {

/// How near to a face a point counts as lying on it, as a share of its distance from the eye (in a
/// parallel view, of the view's width): a thousandth of a pixel or so, which nobody sees. Faces
/// that people mean to touch differ by rounding: POV-Ray keeps the vertices of meshes in single
/// precision (6e-8), and transforms add their own.
inline constexpr double contact = 1e-6;

/// Faces that meet at a smaller angle (.1 degrees) are coplanar: their shading differs by no more
/// than a step of 8-bit colour.
inline constexpr double coplanar_sine = .0017;
inline bool coplanar(const glm::dvec3& normal, const glm::dvec3& other) {
    return glm::length(glm::cross(normal, other)) < coplanar_sine;
}

/// The usable faces of a scene: finite, of at least three distinct corners, not a line. Points at
/// the very same position are one.
class FlatFaces {
   public:
    explicit FlatFaces(const PolygonScene& scene);

    struct Flat {
        std::uint32_t first, count;             ///< corners, as numbers of points
        std::array<std::uint32_t, 3> triangle;  ///< three corners well apart, in order around
        glm::dvec3 normal;     ///< of unit length; from its tip the corners run counter-clockwise
        glm::dvec3 on;         ///< a corner
        std::uint32_t source;  ///< number of the face in the scene
    };

    std::size_t size() const { return flats_.size(); }
    const Flat& operator[](std::size_t i) const { return flats_[i]; }
    const Face& face(std::size_t i) const { return scene_.faces[flats_[i].source]; }
    std::span<const std::uint32_t> corners(std::size_t i) const {
        return std::span(corners_).subspan(flats_[i].first, flats_[i].count);
    }
    const glm::dvec3& point(std::uint32_t number) const { return points_[number]; }
    std::size_t points() const { return points_.size(); }
    /// How large things look at a point: its distance from the eye, or the width of a parallel
    /// view.
    double scale(const glm::dvec3& p) const {
        const glm::dvec4& eye = scene_.camera.eye;
        return eye.w != 0 ? glm::length(p - glm::dvec3(eye)) : width_;
    }

    /// Signed distance from the face's plane; of a viewpoint far away, the cosine to its normal.
    double height(std::size_t i, const glm::dvec3& p) const {
        return glm::dot(flats_[i].normal, p - flats_[i].on);
    }
    double height(std::size_t i, const glm::dvec4& viewpoint) const {
        return glm::dot(flats_[i].normal, glm::dvec3(viewpoint) - viewpoint.w * flats_[i].on);
    }
    /// +1 where the viewpoint is on the side that the normal shows to, exactly; 0 in the plane.
    int facing(std::size_t i, const glm::dvec4& viewpoint) const;

   private:
    void weld();
    bool add(std::uint32_t source);

    const PolygonScene& scene_;
    std::vector<std::uint32_t> welded_;  ///< point of the scene -> point here
    std::vector<glm::dvec3> points_;
    std::vector<std::uint32_t> corners_;
    std::vector<Flat> flats_;
    double width_;  ///< of a parallel view, in units of the scene
};

}  // namespace povpreview
