// SPDX-License-Identifier: AGPL-3.0-or-later
//
// The mesh previewer's dealings with the DetailMap: what is known of each pixel beforehand, and
// what samples and pictures make of it.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/detail/edge_detail.h"
#include "core/mesh_previewer.h"
#include "core/sound_shading.h"

namespace povpreview {

namespace {

/// Smallest item that gets a sample before refinement finds it, in pixels, and how many items get
/// one at most, as a share of all pixels.
constexpr std::uint32_t smallest_seed = 12;
constexpr double seed_share = .005;

/// Anchors of an item at most: they are looked through pixel by pixel.
constexpr std::uint32_t most_anchors = 32;

/// Where light differs by less than this share of what colours do, the albedo makes the rest.
constexpr float explained_share = .25f;

}  // namespace

/// Pictures go on showing the detail as it was.
DetailMap& MeshPreviewer::detail_to_change() {
    if (!detail_)
        detail_ = std::make_shared<DetailMap>(width_, height_);
    else if (detail_.use_count() > 1)
        detail_ = std::make_shared<DetailMap>(*detail_);
    mesh_.show_detail(detail_.get());
    return *detail_;
}

void MeshPreviewer::accept_items(const DrawnDetail& drawn) {
    if (!wants_items()) return;
    number_items_as(drawn);
    textured_ = textured_ || drawn.pixels(Look::Kind::plain) < squares_.pixels();
    textures_drawn_ = drawn.pixels(Look::Kind::image) + drawn.pixels(Look::Kind::pattern) > 0;
    plan_seeds(drawn.extents());
    if (lattice_) return lattice_->accept_detail(*detail_);
    // Edges that were light may cross items of which nothing is known.
    const Triangulation& t = mesh_.triangulation();
    for (std::uint32_t v = 0; v < t.vertex_ids(); ++v)
        if (t.alive(VertexId{v})) queue_edges(VertexId{v});
}

/// Takes the numbers with the map; what was numbered before is numbered again.
void MeshPreviewer::number_items_as(const DrawnDetail& drawn) {
    ItemNumbers numbers = drawn.numbers();
    const std::vector<std::uint32_t> now = numbers.add(items_);
    items_ = std::move(numbers);
    mesh_.number_again([&](const VertexSample& sample) {
        return items_.of(sample.surface, sample.reflected_surface);
    });
    albedo_fetch_.number_again(now);
    auto map = std::make_shared<DetailMap>(drawn.map());
    if (detail_) map->accept_told(*detail_, now);
    detail_ = std::move(map);
    mesh_.show_detail(detail_.get());
}

/// The largest items first, as far as they are worth it.
void MeshPreviewer::plan_seeds(const std::vector<DetailMap::Extent>& extents) {
    std::vector<std::uint32_t> order;
    for (std::uint32_t item = 0; item < extents.size(); ++item)
        if (extents[item].pixels >= smallest_seed) order.push_back(item);
    const auto larger = [&](std::uint32_t a, std::uint32_t b) {
        return extents[a].pixels > extents[b].pixels;
    };
    std::stable_sort(order.begin(), order.end(), larger);
    order.resize(std::min(order.size(), static_cast<std::size_t>(
                                            seed_share * static_cast<double>(squares_.pixels()))));
    std::reverse(order.begin(), order.end());
    seeds_.clear();
    for (std::uint32_t item : order) seeds_.push_back(extents[item].middle);
    anchors_.assign(extents.size(), AdaptiveLattice::no_anchor);
    for (std::uint32_t item : order) anchors_[item] = extents[item].middle;
}

std::optional<Request> MeshPreviewer::next_seed() {
    while (!seeds_.empty()) {
        const Pixel pixel = seeds_.back();
        seeds_.pop_back();
        if (squares_.state(pixel) == BfSquares::State::unsampled)
            return request({lattice_ ? Pending::Use::fill : Pending::Use::vertex, pixel, recent_});
    }
    return std::nullopt;
}

/// The number of the surface that a sample met. Where something else was thought to be there, the
/// sample is right.
std::uint32_t MeshPreviewer::item_seen(const Sample& sample) {
    if (!wants_items() || !contains(sample.parts, Parts::surface)) return DetailMap::unknown;
    const std::uint32_t item = items_.of(sample.surface, sample.reflected_surface);
    // A one-sided sample does not lie in the middle of a pixel, for which alone the map speaks.
    const Pixel pixel = squares_.pixel_at(sample.position);
    if (detail_ && sample.position == squares_.centre(pixel) && detail_->contradicts(pixel, item)) {
        detail_to_change().distrust(pixel);
        if (lattice_) lattice_->accept_doubt(pixel, *detail_);
    }
    return item;
}

/// Whether a sample's shading is wanted, came, and is sound.
bool MeshPreviewer::shaded(const Sample& sample) const {
    return contains(parts(), Parts::shading) && has_sound_shading(sample);
}

/// Between the pixels of a lattice, items and albedos are of use as soon as they are known; no
/// albedo is traced for it.
Parts MeshPreviewer::lattice_parts() const {
    if (!detail_ || detail_->known() == 0) return Parts::colour;
    return textures_drawn_ ? Parts::surface | Parts::shading : Parts::surface;
}

/// Some albedo rays, so that their cost is known as well; after the early samples, which make the
/// first picture.
std::optional<Request> MeshPreviewer::next_trial() {
    constexpr std::size_t full_to_a_trial = 8;
    if (!options_.detail || grid_asked_ < early_samples_ ||
        trials_ * full_to_a_trial >= grid_asked_)
        return std::nullopt;
    const Pixel pixel = grid_[trials_++ * full_to_a_trial];
    return request_albedo(pixel);
}

Request MeshPreviewer::request_albedo(Pixel pixel) {
    pending_.push_back({Pending::Use::albedo, pixel});
    ++albedos_pending_;
    return Request{squares_.centre(pixel), RayKind::albedo};
}

/// Has the albedo fetched along an edge that is heavy for want of it.
void MeshPreviewer::consider_albedos(VertexId a, VertexId b) {
    if (!options_.detail || !cost_known()) return;
    const SampleId s = mesh_.corner(a, b, true), t = mesh_.corner(b, a, false);
    if (!s.valid() || !t.valid()) return;
    const VertexSample &p = mesh_.sample(s), &q = mesh_.sample(t);
    if (p.state != VertexSample::State::known || q.state != VertexSample::State::known) return;
    const float jump = colour_distance(p.encoded, q.encoded);
    const bool explained =
        p.item == q.item && p.shaded && q.shaded && light_distance(p, q) < explained_share * jump;
    textured_ = textured_ || explained;
    if (!albedo_fetch_.tells(p.item, q.item, jump, explained)) return;
    const glm::dvec2 from = p.position, way = q.position - p.position;
    const int steps = 1 + static_cast<int>(glm::length(way) / (BfSquares::side / 2.));
    for (int i = 0; i <= steps; ++i)
        albedo_fetch_.want(squares_.square_of(squares_.pixel_at(from + way * (double(i) / steps))));
}

std::optional<Request> MeshPreviewer::next_albedo() {
    const auto pixel = albedo_fetch_.next(detail_.get());
    if (!pixel) return std::nullopt;
    return request_albedo(*pixel);
}

void MeshPreviewer::accept_albedo(Pixel pixel, const Sample& sample) {
    --albedos_pending_;
    // A trial, of a pixel that gets a full sample as well. They come before all others.
    if (trial_costs_.size() < trials_) {
        trial_costs_.push_back(options_.by_cost ? sample.cost_ns : 0);
        return;
    }
    detail_to_change().accept_albedo(pixel, sample, items_);
}

void MeshPreviewer::draw_detail(Picture& picture) const {
    if (!detail_) return;
    picture.detail = detail_;
    mesh_.draw_lights(picture);
    mesh_.draw_anchors(picture, items_.size(), most_anchors);
}

}  // namespace povpreview
