// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/image_edge.h"
#include "core/polygonal/polygon_scene.h"
#include "tests/core/polygonal/brute_force.h"
#include "tests/core/polygonal/random_scenes.h"
#include "tests/core/polygonal/sight_change.h"

namespace povpreview {

/// What became of the questions that a law asked of the pieces found.
struct Tally {
    int asked = 0;
    int ties = 0;    ///< not asked: too close a decision
    int broken = 0;  ///< answered wrongly
    int idle = 0;    ///< pieces without contrast where yet some visible edge runs
    std::vector<std::string> examples;

    void note(const std::string& example);
    Tally& operator+=(const Tally& other);
    std::string text() const;
};

/// The pieces that were found for a scene, and brute force beside them.
class EdgeLaws {
   public:
    EdgeLaws(const PolygonScene& scene, int mirror_depth);

    /// Between neighbours of a grid of positions that show different things runs, within
    /// `tolerance` of the spot, a piece of the kind that tells them apart. At most `limit` pairs
    /// are looked into.
    Tally neighbours_are_parted(Dice& dice, int limit) const;
    /// On random points of the sides of faces, of the shadows' borders that they cast, and of the
    /// mirror images of both: where the picture changes there, a piece runs through.
    Tally points_lie_on_pieces(Dice& dice, int points) const;
    /// Random points of the pieces have different things to their two sides.
    Tally pieces_part_the_picture(Dice& dice, EdgeKind kind) const;

    const std::vector<ImageEdge>& pieces() const { return pieces_; }

    /// How far from the spot a piece may be, pixels; where faces are seen edge on, one of a face's
    /// sides stands for both.
    static constexpr double tolerance = .01, edge_on_tolerance = .05;

   private:
    bool asks_for_piece(const Sight& a, const Sight& b, const std::optional<Change>& change,
                        Tally& tally) const;
    bool served(glm::dvec2 spot, const Change& change, bool edge_on) const;
    std::string describe(glm::dvec2 spot, const Change& change) const;
    void ask_across(glm::dvec2 spot, glm::dvec2 along, const std::string& origin,
                    Tally& tally) const;
    bool visible_edge_at(glm::dvec2 spot) const;
    void ask_of_point(const Vec3& point, const Vec3& along, Tally& tally) const;

    const PolygonScene& scene_;
    BruteForce brute_;
    std::vector<ImageEdge> pieces_;
    std::vector<glm::dvec2> grid_;          ///< grid_size x grid_size positions
    std::vector<Sight> sights_;             ///< there
    std::map<std::uint64_t, int> seen_in_;  ///< Hit::path -> how often in the grid
};

}  // namespace povpreview
