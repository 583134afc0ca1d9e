// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/mesh_previewer.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/colour.h"
#include "core/filling_order.h"

namespace povpreview {

using Spoke = Triangulation::Spoke;

namespace {

/// Weights are compared with what the heap remembers; they differ by rounding when an edge is seen
/// from its other end.
constexpr float weight_rounding = 1e-4f;

/// Requests outstanding while outlines are traced, for each of them: with fewer the ray tracer
/// would wait for us, with more each probe would wait behind samples for those that come before it.
constexpr std::size_t window_per_outline = 16;

/// Requests outstanding until it is known what a higher rung costs: where that is little, what is
/// traced below it is traced in vain.
constexpr std::size_t undecided_window = 64;

/// Constrained edges are not split below this length in pixels: the outline itself is not known
/// better, and one-sided samples are traced on top of the pixels' own.
constexpr double shortest_constraint = 4;

/// Where the vertices of a pixel lie along one axis: in its middle, but the outermost pixels reach
/// to the border, and the only pixel of a row or column to both sides.
std::vector<double> drawn_out(double centre, int pixels) {
    if (pixels == 1) return {0, 1};
    if (centre < 1) return {0};
    if (centre > pixels - 1) return {double(pixels)};
    return {centre};
}

}  // namespace

MeshPreviewer::MeshPreviewer(int width, int height, const MeshOptions& options,
                             const Ladder& ladder)
    : width_(width),
      height_(height),
      options_(options),
      squares_(width, height),
      mesh_(width, height),
      grid_(first_grid()),
      albedo_fetch_(squares_),
      search_({width, height}),
      climb_(ladder, squares_.pixels(), grid_.size()),
      shifts_(ladder.rungs.size() - 1, RungShift(std::max(width, height))),
      refresh_(std::max(width, height)) {
    assert(width >= 1 && height >= 1);
}

std::string_view MeshPreviewer::name() const {
    if (!options_.constraints) return "delaunay";
    return options_.detail ? "mesh" : "constrained";
}

/// Surfaces tell where outlines are, which is of no use any more once pixels are only filled. What
/// is traced at several rungs is compared in all its parts.
Parts MeshPreviewer::parts() const {
    if (lattice_) return lattice_parts();
    if (!climb_.at_target() || low_left_ > 0) return Parts::surface | Parts::shading;
    if (!refining_) return Parts::colour;
    const bool outlines = options_.constraints && (plan_.outlines || !cost_known());
    Parts parts = outlines || options_.detail ? Parts::surface : Parts::colour;
    if (options_.detail && (textured_ || !cost_known())) parts = parts | Parts::shading;
    return parts;
}

bool MeshPreviewer::is_dense(std::size_t square) const {
    return squares_.count(square) > options_.dense * squares_.area(square);
}

std::optional<Request> MeshPreviewer::request(Pending pending) {
    pending_.push_back(pending);
    retrace_turn_ = true;
    if (pending.use == Pending::Use::side) {
        ++vertices_pending_;
        return Request{mesh_.sample(pending.sample).position, RayKind::full, climb_.current()};
    }
    squares_.request(pending.pixel);
    albedo_fetch_.full_asked();
    if (pending.use == Pending::Use::vertex) {
        ++vertices_pending_;
        const std::size_t square = squares_.square_of(pending.pixel);
        if (climb_.at_target() && is_dense(square)) squares_.fill(square);
    }
    return Request{squares_.centre(pending.pixel), RayKind::full, climb_.current()};
}

std::optional<Request> MeshPreviewer::next() {
    insert_chains();
    if (grid_asked_ < grid_.size()) {
        if (auto albedo = next_trial()) return albedo;
        // If samples are cheap, waiting costs nothing.
        if (options_.lattice && options_.by_cost && grid_asked_ == early_samples_ &&
            grid_costs_.size() < grid_asked_ && (grid_costs_.empty() || seem_cheap()))
            return std::nullopt;
        if (auto trial = next_trial_above()) return trial;
        if (is_undecided() && !climb_.seems_dear()) return std::nullopt;
        return request({Pending::Use::vertex, grid_[grid_asked_++], recent_});
    }
    if (lattice_) return next_in_lattice();
    if (auto trial = next_trial_above()) return trial;
    if (is_undecided()) return std::nullopt;
    if (retrace_turn_) {
        retrace_turn_ = false;  // new samples take turns with old ones
        if (auto again = next_retrace(climb_.current())) return again;
    }
    if (auto albedo = next_albedo()) return albedo;
    if (auto seed = next_seed()) return seed;
    if (!retries_.empty()) {
        const Pending side = retries_.front();
        retries_.pop_front();
        return request(side);
    }
    start_outlines();
    if (search_.active() > 0 && !outlines_overdrawn()) {
        if (auto probe = next_probe()) return probe;
        // Answers come in the order of requests: a long queue would hold up every probe.
        if (dear_pending() >= window_per_outline * (1 + search_.active())) return std::nullopt;
    }
    for (;;) {
        if (const auto pixel = squares_.next_to_fill())
            return request({Pending::Use::fill, *pixel});
        if (refining_) {
            if (auto wanted = refine()) return wanted;
            if (refining_) return std::nullopt;  // answers may bring more edges
        }
        if (fill_order_.empty()) return next_retrace(climb_.current());
        squares_.fill(fill_order_.back());
        fill_order_.pop_back();
    }
}

/// Whether so much has been asked for that the tracer is busy until it is known what a higher rung
/// costs.
bool MeshPreviewer::is_undecided() const {
    return climb_.undecided() && dear_pending() >= undecided_window;
}

std::optional<Request> MeshPreviewer::next_in_lattice() {
    if (auto seed = next_seed()) return seed;
    if (auto again = next_retrace(climb_.current())) return again;  // few, see reach_target()
    const auto pixel = lattice_->next(detail_.get());
    if (!pixel) return std::nullopt;
    return request({Pending::Use::fill, *pixel});
}

/// Asks for the middle of the heaviest edge; ends refinement where there is none.
std::optional<Request> MeshPreviewer::refine() {
    const Triangulation& t = mesh_.triangulation();
    const auto budget =
        static_cast<std::size_t>(plan_.vertex_budget * static_cast<double>(squares_.pixels()));
    while (t.vertices() < std::max<std::size_t>(budget, grid_.size())) {
        const auto entry = heap_.pop();
        if (!entry) {
            // At first answers bring edges faster than they are asked for. Where few are still to
            // come, waiting for each of them would leave the tracer idle.
            if (4 * vertices_pending_ > t.vertices()) return std::nullopt;
            break;
        }
        if (auto wanted = entry->a == entry->b ? refine_side(*entry) : refine(*entry))
            return wanted;
    }
    // Only what is traced at the target is worth filling.
    if (!climb_.at_target()) {
        if (auto again = next_retrace(climb_.current())) return again;
        if (!pending_.empty() || !climb(true)) return std::nullopt;
        if (!climb_.at_target()) return next_retrace(climb_.current());
    }
    start_filling();
    return std::nullopt;
}

std::optional<Request> MeshPreviewer::refine(const RefinementHeap::Entry& entry) {
    const auto [old_weight, a, b] = entry;
    const Triangulation& t = mesh_.triangulation();
    Triangulation::Edge edge{};
    if (!t.find_edge(a, b, edge) || !refinable(a, b, edge.constrained)) return std::nullopt;
    const auto now = weight(a, b);
    if (!now) return std::nullopt;  // comes back when its samples do
    if (*now < old_weight * (1 - weight_rounding)) {
        heap_.push(a, b, *now);
        return std::nullopt;
    }
    consider_outline(a, b);
    consider_albedos(a, b);
    if (edge.constrained) return split_constraint(a, b);
    Pixel pixel = squares_.pixel_at((t.position(a) + t.position(b)) / 2.);
    if (detail_)
        if (const auto stray = mesh_.stray_pixel(a, b))
            if (squares_.state(*stray) == BfSquares::State::unsampled && *stray != pixel) {
                pixel = *stray;
                // The edge may outlive a vertex beside it; its turn comes again after its halves.
                heap_.push(a, b, *now / 4);
            }
    return request({Pending::Use::vertex, pixel, a});
}

/// A vertex's missing sides stand in the heap as an edge from the vertex to itself.
std::optional<Request> MeshPreviewer::refine_side(const RefinementHeap::Entry& entry) {
    const auto [old_weight, v, same] = entry;
    if (!mesh_.triangulation().alive(v)) return std::nullopt;
    const auto side = heaviest_side(v);
    if (!side) return std::nullopt;
    if (side->weight < old_weight * (1 - weight_rounding)) {
        heap_.push(v, v, side->weight);
        return std::nullopt;
    }
    const auto wanted = ask_side(v, side->side, Pending::any);
    queue_side(v);  // the others
    return wanted;
}

/// Whether an edge leaves anything to sample: the pixel in its middle is not asked for yet. A
/// constraint that is not seen is none worth samples of its own.
bool MeshPreviewer::refinable(VertexId a, VertexId b, bool constrained) const {
    const Triangulation& t = mesh_.triangulation();
    const glm::dvec2 p = t.position(a), q = t.position(b);
    const Pixel pixel = squares_.pixel_at((p + q) / 2.);
    if (squares_.filling(squares_.square_of(pixel))) return false;
    if (constrained) return glm::distance(p, q) >= shortest_constraint && mesh_.seen(a, b);
    return squares_.state(pixel) == BfSquares::State::unsampled;
}

std::optional<float> MeshPreviewer::weight(VertexId a, VertexId b) const {
    const auto contrast = mesh_.contrast(a, b);
    if (!contrast) return std::nullopt;
    const Triangulation& t = mesh_.triangulation();
    const double length = glm::distance(t.position(a), t.position(b));
    return edge_weight(options_.weight, static_cast<float>(length / std::max(width_, height_)),
                       *contrast);
}

void MeshPreviewer::accept(const Sample& sample) {
    assert(!pending_.empty());
    const Pending pending = pending_.front();
    pending_.pop_front();
    account(pending.use, sample);
    const bool usable = !sample.failed && finite(sample.colour);
    if (pending.use == Pending::Use::probe) {
        search_.accept(pending.surface, sample);
        take_outlines();
        return;
    }
    if (pending.use == Pending::Use::albedo) return accept_albedo(pending.pixel, sample);
    climb_.learn(sample);
    if (pending.use == Pending::Use::retrace) return accept_retrace(pending, sample, usable);
    learn_cost(sample);
    climb();
    if (pending.use == Pending::Use::side)
        accept_side(pending, sample, usable);
    else
        accept_pixel(pending, sample, usable);
}

void MeshPreviewer::accept_pixel(const Pending& pending, const Sample& sample, bool usable) {
    if (usable)
        squares_.answer(pending.pixel, sample.colour);
    else
        squares_.fail(pending.pixel);
    if (pending.use == Pending::Use::vertex) --vertices_pending_;
    LowSample* low = keep_low(sample, usable, pending.pixel);
    if (lattice_) {
        item_seen(sample);
        return lattice_->accept(pending.pixel, light_of(sample, shaded(sample)));
    }
    if (pending.use == Pending::Use::fill) return;
    const glm::dvec2 centre = squares_.centre(pending.pixel);
    bool meshed = false;
    for (double x : drawn_out(centre.x, width_))
        for (double y : drawn_out(centre.y, height_))
            meshed = add_vertex({x, y}, pending.vertex, sample, usable, low) || meshed;
    if (usable) squares_.set_meshed(pending.pixel, meshed);
}

/// Only a corner of the image takes a failed sample, since it is a vertex anyhow.
bool MeshPreviewer::add_vertex(glm::dvec2 position, VertexId near, const Sample& sample,
                               bool usable, LowSample* low) {
    near = live(near);
    const bool corner =
        (position.x <= 0 || position.x >= width_) && (position.y <= 0 || position.y >= height_);
    if (!corner && (!usable || too_near_constraint(mesh_.triangulation(), position, near)))
        return false;
    const VertexId vertex = mesh_.insert(position, near).vertex;
    if (!mesh_.first_sample(vertex).valid()) {
        const SampleId id = mesh_.promise(vertex, sample.position);
        if (usable)
            mesh_.answer(id, sample, item_seen(sample), shaded(sample));
        else
            mesh_.fail(id);
        if (low) low->show_at(id, vertex);
    }
    recent_ = vertex;
    queue_around(vertex);
    return true;
}

/// A vertex to start a search from: removed ones may still be named by old requests.
VertexId MeshPreviewer::live(VertexId near) const {
    if (mesh_.triangulation().alive(near)) return near;
    return mesh_.triangulation().alive(recent_) ? recent_ : VertexId{0};
}

void MeshPreviewer::queue_edges(VertexId vertex, VertexId except) {
    if (!refining_) return;
    thread_local std::vector<Spoke> fan;
    mesh_.triangulation().fan(vertex, fan);
    for (const Spoke& spoke : fan)
        if (spoke.to != except) queue_edge(vertex, spoke);
}

void MeshPreviewer::queue_edge(VertexId vertex, const Spoke& spoke) {
    if (!refinable(vertex, spoke.to, spoke.constrained)) return;
    if (const auto w = weight(vertex, spoke.to)) heap_.push(vertex, spoke.to, *w);
}

/// An edge that is new ends at a new vertex, or at two vertices around which something changed; at
/// a vertex on a constraint even old edges may see other samples than before.
void MeshPreviewer::queue_changed(std::vector<VertexId> touched, std::size_t vertices_before) {
    if (!refining_) return;
    const Triangulation& t = mesh_.triangulation();
    std::sort(touched.begin(), touched.end());
    const auto all_of = [&](VertexId v) {
        return v.value >= vertices_before || t.on_constraint(v);
    };
    thread_local std::vector<Spoke> fan;
    for (VertexId v : touched) {
        t.fan(v, fan);
        for (const Spoke& spoke : fan) {
            const bool both = std::binary_search(touched.begin(), touched.end(), spoke.to);
            if (both ? v < spoke.to : all_of(v)) queue_edge(v, spoke);
        }
        queue_side(v);
    }
}

void MeshPreviewer::queue_around(VertexId vertex) {
    queue_edges(vertex);
    queue_side(vertex);
}

void MeshPreviewer::queue_side(VertexId vertex) {
    if (const auto side = heaviest_side(vertex)) heap_.push(vertex, vertex, side->weight);
}

void MeshPreviewer::start_filling() {
    refining_ = false;
    heap_.clear();
    chains_ = {};
    seeds_ = {};
    albedo_fetch_.clear();
    fill_order_ = filling_order(mesh_, squares_);
}

/// What was asked for before as vertices comes as pixels.
void MeshPreviewer::start_lattice() {
    refining_ = false;
    heap_.clear();
    chains_ = {};
    retries_.clear();
    albedo_fetch_.clear();
    grid_.resize(grid_asked_);  // the lattice has samples of its own
    lattice_.emplace(squares_, width_, height_, lattice_side());
    if (detail_) lattice_->accept_detail(*detail_);
}

bool MeshPreviewer::done() const {
    return pending_.empty() && squares_.answered() == squares_.pixels() && low_left_ == 0;
}

Picture MeshPreviewer::picture(Overlay overlay) const {
    Picture picture;
    picture.width = width_;
    picture.height = height_;
    mesh_.draw(picture);
    draw_detail(picture);
    squares_.draw(picture);
    if (lattice_) lattice_->draw(picture, detail_.get(), anchors_);
    if (overlay == Overlay::mesh || overlay == Overlay::edges)
        mesh_.draw_edges(picture, overlay == Overlay::edges);
    if (overlay == Overlay::samples)
        for (Pixel pixel = 0; pixel < squares_.pixels(); ++pixel)
            if (squares_.has_colour(pixel))
                picture.samples.push_back(glm::vec2(squares_.centre(pixel)));
    return picture;
}

Statistics MeshPreviewer::statistics() const {
    Statistics statistics;
    statistics.vertices = mesh_.triangulation().vertices();
    statistics.constraints = mesh_.triangulation().constraints();
    statistics.filled = squares_.known();
    statistics.constraints_by_kind = mesh_.triangulation().labels().counts();
    if (climb_.has_rungs()) statistics.rungs = climb_.standings();
    statistics.below_target = low_left_;
    if (detail_) {
        statistics.items = detail_->known();
        statistics.albedos = detail_->albedos();
        statistics.contradicted = detail_->contradicted();
    }
    return statistics;
}

std::string MeshPreviewer::validate() const {
    if (std::string fault = mesh_.validate(); !fault.empty()) return fault;
    if (!refining_) return {};
    std::vector<std::pair<std::pair<VertexId, VertexId>, float>> entries;
    for (const auto& entry : heap_.entries()) entries.push_back({{entry.a, entry.b}, entry.weight});
    std::sort(entries.begin(), entries.end());
    std::string fault;
    const auto require = [&](VertexId a, VertexId b, float now) {
        const std::pair<VertexId, VertexId> edge{std::min(a, b), std::max(a, b)};
        auto it = std::upper_bound(entries.begin(), entries.end(), std::pair{edge, INFINITY});
        if (it == entries.begin() || (--it)->first != edge ||
            it->second < now * (1 - weight_rounding))
            fault =
                "the heap misses edge " + std::to_string(a.value) + "-" + std::to_string(b.value);
    };
    const Triangulation& t = mesh_.triangulation();
    t.for_each_edge([&](VertexId a, VertexId b, bool constrained) {
        if (!fault.empty() || !refinable(a, b, constrained)) return;
        // What is known of pixels changes as well; that is looked up when the edge's turn comes.
        // So does what samples of several rungs show.
        const bool changes = detail_ || climb_.has_rungs();
        if (const auto now = weight(a, b)) require(a, b, changes ? 0 : *now);
    });
    // What sides weigh changes with all that becomes known around them; it is looked up again when
    // their turn comes.
    for (std::uint32_t i = 0; i < t.vertex_ids() && fault.empty(); ++i)
        if (t.alive(VertexId{i}) && heaviest_side(VertexId{i}))
            require(VertexId{i}, VertexId{i}, 0);
    return fault;
}

}  // namespace povpreview
