// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>

#include "core/detail/drawable_scene.h"
#include "tests/end_to_end/geometry_agreement.h"

namespace povpreview {

/// How what a DrawableScene says of each probe's ray, in double precision and without haste, agrees
/// with what the probe hit.
struct DrawableAgreement {
    std::size_t probes = 0;
    std::size_t unknown = 0;   ///< something unknown may lie before all that is known
    std::size_t curved = 0;    ///< known, and nearest is a curved piece
    std::size_t agreeing = 0;  ///< known, and the same surface at the same depth, or nothing
    std::size_t tied = 0;  ///< known, and the surface hit lies at the very same depth as another
    /// Known, and right within a hundredth of a pixel: there POV-Ray's tolerances decide.
    std::size_t at_edges = 0;
    std::size_t wrong = 0;
    struct Example {
        glm::dvec2 position;
        std::uint32_t hit, said;
        double hit_depth, said_depth;
    };
    std::vector<Example> examples;  ///< of the wrong ones, the first

    std::size_t known() const { return probes - unknown; }
    double known_share() const { return share(known(), probes); }
    double wrong_share() const { return share(wrong, known()); }
    static double share(std::size_t part, std::size_t all) {
        return all == 0 ? 0 : static_cast<double>(part) / static_cast<double>(all);
    }
};

/// What the scene says of a position.
struct Seen {
    std::uint32_t surface = 0, material = 0;  ///< 0: nothing
    double depth = 1e30;
    glm::dvec3 point{0};
    const Face* face = nullptr;  ///< or a piece
    double unknown_from = 1e30;  ///< depth of the nearest box around something unknown
    bool curved() const { return surface != 0 && face == nullptr; }
    bool known() const { return unknown_from > depth || unknown_from > 1e29; }
    /// The nearest of the faces, and of each piece that shows or may show.
    std::vector<std::pair<double, std::uint32_t>> hits;
    /// Depth of the nearest point where a piece may show or not: in the surface of another solid.
    double undecided_from = 1e30;
};
std::vector<Seen> seen_at(const DrawableScene& scene, std::span<const glm::dvec2> positions);

DrawableAgreement compare_drawable(const DrawableScene& scene, std::span<const Sample> probes);

/// Depths of a ray; empty if low > high.
struct Stretch {
    double low = 0, high = too_far;
};
/// Depths at which a ray meets the surface of a solid, in order, all within the stretch among them;
/// tests of that are tests of tests.
std::vector<double> crossings(const DrawableScene& scene, const Solid& solid, const Ray& ray,
                              const Stretch& within);
enum class Holds : std::uint8_t { no, undecided, yes };
/// Undecided in the surface, up to rounding.
Holds is_inside(const DrawableScene& scene, const Solid& solid, const glm::dvec3& point);
/// Whether a piece's condition holds at a point of its solid's surface.
Holds holds(const DrawableScene& scene, const CurvedPiece& piece, const glm::dvec3& point);

}  // namespace povpreview
