// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "adapter/povray_oracle.h"
#include "core/polygonal/polygon_scene.h"

namespace povpreview {

struct Ray {
    glm::dvec3 origin, direction;  ///< direction of length 1
};
/// The ray of a position in the image.
Ray ray_through(const StraightCamera& camera, const glm::dvec2& position);

/// What is nearest along a ray, from too_near on.
struct NearestFace {
    std::uint32_t surface = 0;  ///< 0: nothing
    double depth = 1e30;
    const Face* face = nullptr;
    std::vector<std::uint32_t> others;  ///< surfaces that coincide with it
};
/// Of the faces that the eye sees, for each position.
std::vector<NearestFace> nearest_faces(const PolygonScene& scene,
                                       std::span<const glm::dvec2> positions);

/// Between them POV-Ray looks for hits: its MIN_ISECT_DEPTH and MAX_DISTANCE, amply.
constexpr double too_near = 1e-3, too_far = 9.9e6;
/// Pixels; see GeometryAgreement::at_edges.
constexpr double hair = .01;

/// How exported faces and traced probes agree, probe by probe. A probe agrees with the faces if
/// none of them lies before what it hit, and if it hit a surface of which there are faces, then one
/// with that identity lies at that depth.
struct GeometryAgreement {
    std::size_t probes = 0;
    std::size_t on_faces = 0;  ///< hit a surface of which there are faces
    std::size_t missing = 0;   ///< of them, those without a face there
    std::size_t in_front = 0;  ///< probes with a face before what they hit
    /// Such as these, but for less than a hundredth of a pixel: POV-Ray keeps meshes in single
    /// precision, and where it sees them edge-on, that makes them a hair thicker or thinner.
    std::size_t at_edges = 0;
    /// A probe that does not agree, and the nearest face along its ray; surface 0: none.
    struct Example {
        std::size_t probe;
        std::uint32_t surface;
        double depth;
    };
    std::vector<Example> examples;  ///< the first ones

    std::size_t disagreeing() const { return missing + in_front; }
    double share() const {
        return probes == 0 ? 0 : static_cast<double>(disagreeing()) / static_cast<double>(probes);
    }
};

/// By intersecting the probe's ray with every face whose image surrounds its position.
GeometryAgreement compare_geometry(const PolygonScene& scene, std::span<const Sample> probes);

/// One position in the image of the inside of each face that has one, up to `limit` of them, by
/// chance; then the centres of all pixels.
std::vector<glm::dvec2> probing_positions(const PolygonScene& scene, std::size_t limit,
                                          unsigned seed);

/// Probes at these positions. Throws Error as PovrayOracle does.
std::vector<Sample> probe(PovrayOracle& oracle, std::span<const glm::dvec2> positions);

}  // namespace povpreview
