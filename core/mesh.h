// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/ids.h"
#include "core/picture.h"
#include "core/sector.h"
#include "core/triangulation.h"

namespace povpreview {

/// What a vertex knows of the image, at the vertex or in one of its sectors.
struct VertexSample {
    enum class State : std::uint8_t {
        promised,  ///< asked for
        known,
        failed  ///< came without a value, or was not believed
    };
    glm::dvec2 position;  ///< where it was traced
    glm::vec3 colour{};   ///< linear light
    glm::vec3 encoded{};  ///< the same, display-encoded in [0, 1]
    std::uint32_t surface = 0;
    State state = State::promised;
    SampleId next{};  ///< the vertex's next sample
};

/// The triangulation of the image together with the samples at its vertices: the interpolant.
///
/// A vertex off the constraints has one sample. At a vertex on a constraint, each corner of a face
/// takes the sample whose own position lies in the corner's sector.
class Mesh {
   public:
    Mesh(int width, int height);

    const Triangulation& triangulation() const { return triangulation_; }

    // The operations of Triangulation; afterwards `triangulation().touched()` tells what changed.
    Triangulation::Insertion insert(glm::dvec2 position, VertexId near);
    void constrain(VertexId a, VertexId b, ConstraintLabel label = {});
    Triangulation::Insertion split(VertexId a, VertexId b, glm::dvec2 p);
    void remove(VertexId vertex);

    /// Between the two, the operations above do not keep up the corners at vertices on constraints,
    /// which is half of their work: nothing may be asked about those. `touched`: the live vertices
    /// among all those that were touched.
    void hold_sides() { sides_held_ = true; }
    void release_sides(std::span<const VertexId> touched);

    /// Adds a sample that is asked for at `position`, to be filled in by `answer`.
    SampleId promise(VertexId vertex, glm::dvec2 position);
    void answer(SampleId sample, const glm::vec3& colour, std::uint32_t surface);
    void fail(SampleId sample);
    /// Asks for a promised sample elsewhere.
    void move(SampleId sample, glm::dvec2 position) { samples_[sample.value].position = position; }
    const VertexSample& sample(SampleId id) const { return samples_[id.value]; }
    SampleId first_sample(VertexId vertex) const { return first_[vertex.value]; }
    std::size_t samples() const { return samples_.size(); }

    /// Where samples are to be asked for at a vertex on a constraint: one position in each sector
    /// that has none, truly inside it, `scale` times as far off the constraints as usual. A sector
    /// too thin to hold a point is left out.
    void missing_positions(VertexId vertex, std::vector<glm::dvec2>& positions,
                           double scale = 1) const;

    /// The sample for the corner at `at` of the face to the left (right) of the edge at-to; invalid
    /// where that sector has none.
    SampleId corner(VertexId at, VertexId to, bool left) const;

    /// The largest colour_distance() between the ends of an edge, over its two sides where it is
    /// constrained; nothing where an end is not known on any side.
    std::optional<float> contrast(VertexId a, VertexId b) const;

    /// Linear colour of the corner at `at` in the face to the left of at-to; where its sector knows
    /// none, a mean of the nearest that are known on this side of the constraints.
    glm::vec3 corner_colour(VertexId at, VertexId to) const;

    /// Appends the faces' corners to the picture.
    void draw(Picture& picture) const;
    /// Appends all edges, or the constrained ones alone.
    void draw_edges(Picture& picture, bool constraints_only) const;

    /// The first invariant that does not hold, as a sentence; empty where all is well.
    std::string validate() const;

   private:
    /// A sector of a vertex on a constraint, kept because fans there are long and asked for often.
    struct Side {
        Wedge wedge;
        SampleId sample;  ///< invalid where there is none
    };
    void update_sides(VertexId vertex);
    void update_sides(std::span<const VertexId> touched);
    const VertexSample* known(SampleId id) const;
    SampleId in_wedge(VertexId vertex, const Wedge& wedge) const;
    Wedge wedge(VertexId vertex, const std::vector<Triangulation::Spoke>& fan,
                const Sector& sector) const;
    bool mean_nearby(VertexId at, VertexId to, int depth, glm::vec3& mean) const;
    std::optional<glm::dvec2> side_position(VertexId vertex,
                                            const std::vector<Triangulation::Spoke>& fan,
                                            const Sector& sector, double scale) const;

    int width_, height_;
    Triangulation triangulation_;
    std::vector<VertexSample> samples_;
    std::vector<SampleId> first_;             // by vertex
    std::vector<std::uint32_t> sides_index_;  // by vertex, into sides_; none: off the constraints
    std::vector<std::vector<Side>> sides_;    // counter-clockwise
    bool sides_held_ = false;
    glm::dvec3 sum_{};  // of all known colours, the last resort
    std::size_t count_ = 0;
    static constexpr std::uint32_t none = 0xffffffff;
};

}  // namespace povpreview
