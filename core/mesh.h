// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/detail/detail_map.h"
#include "core/ids.h"
#include "core/picture.h"
#include "core/rung_shift.h"
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
    std::uint32_t surface = 0, reflected_surface = 0;
    std::uint32_t item = DetailMap::unknown;  ///< number of that surface
    State state = State::promised;
    bool shaded = false;  ///< the rest is there: colour = albedo * illumination + remainder
    glm::vec3 albedo{}, illumination{}, remainder{};
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
    /// `item`: the number of its surface, if those are numbered; `shaded`: its shading was asked
    /// for and is sound.
    void answer(SampleId sample, const Sample& answer, std::uint32_t item = DetailMap::unknown,
                bool shaded = false);
    void fail(SampleId sample);
    /// Gives all samples whose surfaces are numbered other numbers.
    void number_again(const std::function<std::uint32_t(const VertexSample&)>& item);
    /// Shows a known sample in another light than it was answered with. Returns whether that can
    /// be seen; without effect on samples that are not known.
    bool relight(SampleId sample, const RungLight& light);
    /// Asks for a promised sample elsewhere.
    void move(SampleId sample, glm::dvec2 position) { samples_[sample.value].position = position; }
    const VertexSample& sample(SampleId id) const { return samples_[id.value]; }
    SampleId first_sample(VertexId vertex) const { return first_[vertex.value]; }
    std::size_t samples() const { return samples_.size(); }

    /// A sector of a vertex on a constraint for which no sample was ever asked: its corners take
    /// their colour from their neighbours on this side.
    struct MissingSide {
        std::size_t side;
        double area;  ///< of the sector's faces, square pixels
        /// The greatest colour_distance() from one neighbour on this side to the others; nothing
        /// where none of them is known.
        std::optional<float> spread;
    };
    void missing_sides(VertexId vertex, std::vector<MissingSide>& missing) const;
    /// Asks for a missing side's sample, truly inside the sector; nothing where it is too thin to
    /// hold a point, which ends its missing.
    std::optional<SampleId> promise_side(VertexId vertex, std::size_t side);

    /// A vertex's corners that share a colour are a side: one for each sector, or a single one
    /// where the vertex is off the constraints.
    std::size_t sides(VertexId vertex) const;
    /// The side of the corner at `at` of the face to the left (right) of the edge at-to; nothing
    /// outside the image.
    std::optional<std::size_t> side_at(VertexId at, VertexId to, bool left) const;
    /// A side's sample; invalid where there is none.
    SampleId side_sample(VertexId vertex, std::size_t side) const;
    /// The sample for the corner at `at` of the face to the left (right) of the edge at-to; invalid
    /// where that sector has none.
    SampleId corner(VertexId at, VertexId to, bool left) const;

    /// The largest colour_distance() between the ends of an edge, over its two sides where it is
    /// constrained. An end that is not known and not asked for says nothing: between two of them
    /// off the constraints it is unknown_distance, else 0. Nothing where no side can tell before an
    /// answer comes.
    std::optional<float> contrast(VertexId a, VertexId b) const;
    /// What is expected between colours of which nothing is known: two surfaces side by side. Best
    /// of .005 to .08 on images of cards.
    static constexpr float unknown_distance = .08f;

    /// What is known of the pixels between the samples; null: nothing. Must outlive its use.
    void show_detail(const DetailMap* detail) { detail_ = detail; }
    /// A pixel on the edge of which nothing is known but its item: of none of the samples at the
    /// edge's ends, and in the midst of as long a stretch as there is.
    std::optional<Pixel> stray_pixel(VertexId a, VertexId b) const;

    /// Whether a constraint is seen: false where both sides are known at an end or both, and of one
    /// colour there (colour_distance() up to even_distance).
    bool seen(VertexId a, VertexId b) const;
    /// Two steps of 256 in every channel.
    static constexpr float even_distance = 6e-5f;

    /// The mean of all known samples, linear.
    glm::vec3 mean_colour() const {
        return count_ ? glm::vec3(sum_ / static_cast<double>(count_)) : glm::vec3(0);
    }

    /// Appends the faces' corners to the picture.
    void draw(Picture& picture) const;
    /// Appends what else the corners know, and for each item a choice of its samples.
    void draw_lights(Picture& picture) const;
    void draw_anchors(Picture& picture, std::size_t items, std::uint32_t most) const;
    /// Appends all edges, or the constrained ones alone.
    void draw_edges(Picture& picture, bool constraints_only) const;

    /// The first invariant that does not hold, as a sentence; empty where all is well.
    std::string validate() const;

   private:
    /// A sector of a vertex on a constraint, kept because fans there are long and asked for often.
    struct Side {
        Wedge wedge;
        VertexId start, end;  ///< the constraints it lies between; invalid: the border
        SampleId sample;      ///< invalid where there is none
        bool thin = false;    ///< too thin to hold a sample
    };
    void update_sides(VertexId vertex);
    void update_sides(std::span<const VertexId> touched);
    const VertexSample* known(SampleId id) const;
    float distance(const VertexSample& p, const VertexSample& q) const;
    SampleId in_wedge(VertexId vertex, const Wedge& wedge) const;
    Wedge wedge(VertexId vertex, const std::vector<Triangulation::Spoke>& fan,
                const Sector& sector) const;
    std::optional<glm::dvec2> side_position(VertexId vertex,
                                            const std::vector<Triangulation::Spoke>& fan,
                                            const Sector& sector) const;

    int width_, height_;
    Triangulation triangulation_;
    std::vector<VertexSample> samples_;
    std::vector<SampleId> first_;             // by vertex
    std::vector<std::uint32_t> sides_index_;  // by vertex, into sides_; none: off the constraints
    std::vector<std::vector<Side>> sides_;    // counter-clockwise
    bool sides_held_ = false;
    glm::dvec3 sum_{};  // of all known colours, the last resort
    std::size_t count_ = 0;
    const DetailMap* detail_ = nullptr;
    static constexpr std::uint32_t none = 0xffffffff;
};

}  // namespace povpreview
