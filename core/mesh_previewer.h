// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <deque>
#include <initializer_list>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/adaptive_lattice.h"
#include "core/bf_squares.h"
#include "core/chain_insertion.h"
#include "core/cost_plan.h"
#include "core/detail/albedo_fetch.h"
#include "core/edge_weight.h"
#include "core/mesh.h"
#include "core/outline_search.h"
#include "core/previewer.h"
#include "core/refinement_heap.h"

namespace povpreview {

struct MeshOptions {
    /// Without constraints it is Painter and Sloan's plain Delaunay triangulation.
    bool constraints = true;
    /// Use what is known of each pixel: the paper's DetailMap.
    bool detail = true;
    /// Plan by what the first samples cost; else as where that is not known.
    bool by_cost = true;
    /// Of the tracer's threads, those that work side by side.
    int threads = 2;
    /// Where samples are cheaper than vertices, go on with a lattice instead.
    bool lattice = true;
    WeightKind weight = WeightKind::area;
    /// An outline is traced where an edge of the mesh jumps by more than this (square root of the
    /// paper's colour distance, on encoded colour) ...
    float outline_jump = .08f;
    /// ... and jump x length in pixels exceeds this: below it, a few samples do as well.
    double outline_weight = 4;
    /// Rays spent on outlines (probes and the first one-sided samples), as a share of all full
    /// samples so far, and how many may be spent in advance, as a share of the pixels. Measured:
    /// outlines make edges crisp, but their rays mend no more of the mean error than samples do,
    /// and waiting for them costs time; so they get little.
    double outline_share = .05, outline_floor = .0005;
    /// No more outlines once this share of the pixels is sampled: edges are sharp by then.
    double outline_until = .1;
    /// Vertices of exactly known chains in the mesh, at most, for each full sample asked for. More
    /// take more time of our own; on crowded images 4 shows up to a third less error than 2 in the
    /// first half per cent of the samples, and none less after one per cent.
    double chain_share = 2;
    /// Side of a cell of the first, regular grid, as a share of the larger image side.
    double grid_cell = 1. / 20;
    /// A square with more than this share of its pixels sampled is filled: with a sample to every
    /// fourth pixel, edges are some two pixels long and interpolation has nothing left to bridge.
    /// Over 12 rendered scenes, geometric means of the error from 2, 5 and 10 % of the pixels:
    ///     .0625 .0187 .0138 .0095    .125 .0171 .0116 .0077    .25 .0169 .0110 .0071
    ///     .5    .0169 .0111 .0073    never .0169 .0111 .0075
    double dense = .25;
};

/// The paper's previewer (Pighin, Lischinski, Salesin 1997): a constrained Delaunay triangulation
/// of the samples, refined in the middle of its heaviest edge, with BF-squares where samples get
/// dense, until every pixel is traced.
///
/// Vertices lie on pixel centres, so that a pixel's sample is traced once; those of the outermost
/// pixels are drawn out to the image's border, so that the triangles cover it. Samples that failed
/// or are not finite never become vertices.
class MeshPreviewer : public Previewer {
   public:
    /// REQUIRES: width and height at least 1.
    MeshPreviewer(int width, int height, const MeshOptions& options = {},
                  const Ladder& ladder = {});

    std::string_view name() const override;
    Parts parts() const override;
    std::optional<Request> next() override;
    void accept(const Sample& sample) override;
    bool wants_edges() const override {
        return options_.constraints && refining_ && (plan_.edges || !detail_);
    }
    void accept_edges(std::vector<EdgeChain>&& chains) override;
    bool wants_items() const override { return options_.detail && (refining_ || lattice_); }
    void accept_items(const DrawnDetail& drawn) override;
    void accept_ready(Rung rung) override;
    bool waits() const override { return pending_.empty() && !climb_.at_target(); }
    bool done() const override;
    Picture picture(Overlay overlay) const override;
    Statistics statistics() const override;
    std::vector<Stage> stages() const override;

    const Mesh& mesh() const { return mesh_; }
    /// Full samples of the first, regular grid.
    std::size_t first_samples() const { return grid_.size(); }
    /// The first invariant that does not hold, as a sentence, of the mesh or between mesh, heap and
    /// pixels; empty where all is well.
    std::string validate() const;

   private:
    /// What an outstanding request is for.
    struct Pending {
        enum class Use : std::uint8_t { fill, vertex, side, probe, albedo, retrace } use;
        Pixel pixel = 0;              ///< fill, vertex, albedo
        VertexId vertex{};            ///< vertex: one nearby; side: the one it belongs to
        SampleId sample{};            ///< side
        std::uint32_t surface = any;  ///< side: what should be there; probe: the tracer's number
        bool retried = false;         ///< side: this is the second try
        std::size_t low = 0;          ///< retrace: which of low_

        static constexpr std::uint32_t any = 0xffffffff;
    };

    // What is done for a scene, and what it took (mesh_stages.cpp).
    struct Account {
        std::size_t rays = 0;
        std::uint64_t nanoseconds = 0;
    };
    void account(Pending::Use use, const Sample& sample);
    Stage stage(std::string name, bool runs, std::string why,
                std::initializer_list<Pending::Use> uses) const;
    Stage triangulation_stage() const;
    Stage outline_stage() const;
    Stage edge_stage() const;
    Stage albedo_stage() const;
    Stage filling_stage() const;
    Stage rising_stage() const;
    double vertex_share() const;

    // The first samples (mesh_first_samples.cpp).
    std::vector<Pixel> first_grid();
    std::vector<int> grid_lines(int pixels) const;
    int lattice_side() const;
    void learn_cost(const Sample& sample);
    CostPlan plan_at(double full_ns) const;
    double albedo_price_at(double full_ns) const;
    bool seem_cheap() const;
    bool suit_lattice() const;
    bool cost_known() const { return grid_costs_.size() == grid_.size(); }

    // What is asked for after them.
    bool is_dense(std::size_t square) const;
    std::optional<Request> request(Pending pending);
    /// Requests outstanding that keep the tracer busy: it answers albedo rays in no time.
    std::size_t dear_pending() const { return pending_.size() - albedos_pending_; }
    bool is_undecided() const;
    std::optional<Request> next_in_lattice();
    std::optional<Request> refine();
    std::optional<Request> refine(const RefinementHeap::Entry& entry);
    std::optional<Request> refine_side(const RefinementHeap::Entry& entry);

    // One-sided samples (mesh_sides.cpp).
    struct WeighedSide {
        std::size_t side;
        float weight;
    };
    std::optional<WeighedSide> heaviest_side(VertexId vertex) const;
    std::optional<Request> ask_side(VertexId vertex, std::size_t side, std::uint32_t surface);
    std::optional<Request> split_constraint(VertexId a, VertexId b);
    void accept_side(Pending side, const Sample& sample, bool usable);
    std::uint32_t surface_beside(VertexId a, VertexId b, bool left) const;

    // Chains of constraints (mesh_chains.cpp).
    bool is_superfluous(const EdgeChain& chain) const;
    bool items_known_along(glm::dvec2 from, glm::dvec2 to) const;
    void insert_chains();
    ChainInsertion begin_insertion();
    void finish_insertion(ChainInsertion& insertion);

    // Outlines (mesh_outlines.cpp).
    void consider_outline(VertexId a, VertexId b);
    bool outlines_overdrawn() const;
    void start_outlines();
    std::optional<Request> next_probe();
    void take_outlines();
    void insert(const Outline& outline);
    void start_filling();
    void start_lattice();

    // What is known of each pixel (mesh_detail.cpp).
    DetailMap& detail_to_change();
    void number_items_as(const DrawnDetail& drawn);
    void plan_seeds(const std::vector<DetailMap::Extent>& extents);
    std::uint32_t item_seen(const Sample& sample);
    bool shaded(const Sample& sample) const;
    Parts lattice_parts() const;
    std::optional<Request> next_seed();
    void consider_albedos(VertexId a, VertexId b);
    std::optional<Request> next_trial();
    std::optional<Request> next_albedo();
    Request request_albedo(Pixel pixel);
    void accept_albedo(Pixel pixel, const Sample& sample);
    void draw_detail(Picture& picture) const;

    // The ladder of accuracy (mesh_rungs.cpp).
    /// A sample traced below the target, to be traced again higher up.
    struct LowSample {
        glm::dvec2 position;
        std::optional<Pixel> pixel;  ///< none: one-sided
        /// Where the mesh shows it; up to four where the image is one pixel wide.
        std::array<SampleId, 4> samples{};
        std::array<VertexId, 4> vertices{};
        std::uint32_t surface = 0;
        RungLight light;     ///< as it was traced
        bool known = false;  ///< else it failed
        Rung rung = 0;
        bool asked = false;  ///< for a higher rung, or anew
        bool stale = false;  ///< its rung has become better since

        void show_at(SampleId sample, VertexId vertex);
    };
    LowSample* keep_low(const Sample& sample, bool usable, std::optional<Pixel> pixel);
    bool climb(bool at_rest = false);
    void reach_target();
    std::optional<Request> next_trial_above();
    std::optional<Request> next_retrace(Rung rung);
    Request ask_retrace(std::size_t low, Rung rung);
    void accept_retrace(const Pending& pending, const Sample& sample, bool usable);
    RungLight shifted(const LowSample& low, Rung rung) const;
    void learn_shift(const LowSample& low, const Sample& sample);
    void show(const LowSample& low, const RungLight& light);
    void shift_all();

    void accept_pixel(const Pending& pending, const Sample& sample, bool usable);
    bool add_vertex(glm::dvec2 position, VertexId near, const Sample& sample, bool usable,
                    LowSample* low);
    VertexId live(VertexId near) const;
    std::optional<float> weight(VertexId a, VertexId b) const;
    bool refinable(VertexId a, VertexId b, bool constrained) const;
    void queue_edges(VertexId vertex, VertexId except = {});
    void queue_edge(VertexId vertex, const Triangulation::Spoke& spoke);
    void queue_changed(std::vector<VertexId> touched, std::size_t vertices_before);
    void queue_side(VertexId vertex);
    void queue_around(VertexId vertex);

    int width_, height_;
    MeshOptions options_;
    BfSquares squares_;
    Mesh mesh_;
    RefinementHeap heap_;
    std::deque<Pending> pending_;  // answers come in this order
    /// So many of the first samples tell whether vertices are worth the time that would be spent on
    /// them until all have come.
    std::size_t early_samples_ = 0;
    std::vector<Pixel> grid_;  // first samples, in order
    std::size_t grid_asked_ = 0;
    std::size_t vertices_pending_ = 0;  // answers outstanding that may bring new edges
    std::size_t albedos_pending_ = 0;
    std::deque<Pending> retries_;          // one-sided samples to ask for again
    std::vector<std::size_t> fill_order_;  // squares left when refinement ended, last first
    std::vector<EdgeChain> chains_;        // known and not yet inserted, lightest first
    std::size_t chain_vertices_ = 0;       // of those inserted
    std::size_t vertices_before_insertion_ = 0;
    std::shared_ptr<DetailMap> detail_;  // null as long as nothing is known; shared with pictures
    std::vector<Pixel> seeds_;           // one for each item without a sample, the largest last
    ItemNumbers items_;
    bool textured_ = false;        // some surface was seen to vary, or is known to
    bool textures_drawn_ = false;  // some albedo that varies was known without tracing it
    AlbedoFetch albedo_fetch_;
    std::size_t trials_ = 0;                  // albedo rays asked for to learn what they cost
    std::vector<std::uint32_t> trial_costs_;  // of those, nanoseconds
    OutlineSearch search_;
    std::size_t outline_rays_ = 0;   // spent on outlines
    std::size_t waiting_since_ = 0;  // full rays when the next round's first edge was taken
    RungClimb climb_;
    std::vector<LowSample> low_;     // in the order of their answers: coarse to fine
    std::size_t low_left_ = 0;       // of them below the target
    std::size_t low_scanned_ = 0;    // of them need no request for the current rung
    std::vector<RungShift> shifts_;  // from each rung to the next
    RungShift refresh_;              // from a rung as it was to what has become of it
    std::size_t shift_learnt_ = 0;   // positions learnt from since there was something new to learn
    std::size_t shift_again_at_ = 0;  // shifts are applied again when so many have been learnt
    bool retrace_turn_ = false;
    std::vector<std::uint32_t> grid_costs_;  // of the first samples, nanoseconds
    CostPlan plan_{0, false, false, true,
                   plan_by_cost(0, 0, options_.threads).vertex_budget};  // until they are known
    std::array<Account, 6> accounts_;                                    // by Pending::Use
    bool refining_ = true;
    std::optional<AdaptiveLattice> lattice_;  // once it has taken the triangulation's place
    std::vector<Pixel> anchors_;              // for the lattice: by item
    VertexId recent_{0};                      // a live vertex
};

}  // namespace povpreview
