// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/mesh.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "core/colour.h"
#include "core/detail/edge_detail.h"
#include "core/edge_weight.h"

namespace povpreview {

using Spoke = Triangulation::Spoke;

Mesh::Mesh(int width, int height)
    : width_(width),
      height_(height),
      triangulation_({0, 0}, {width, height}),
      first_(triangulation_.vertex_ids()),
      sides_index_(triangulation_.vertex_ids(), none) {}

Triangulation::Insertion Mesh::insert(glm::dvec2 position, VertexId near) {
    const auto insertion = triangulation_.insert(position, near);
    update_sides(triangulation_.touched());
    return insertion;
}

void Mesh::constrain(VertexId a, VertexId b, ConstraintLabel label) {
    triangulation_.constrain(a, b, label);
    update_sides(triangulation_.touched());
}

Triangulation::Insertion Mesh::split(VertexId a, VertexId b, glm::dvec2 p) {
    const auto insertion = triangulation_.split(a, b, p);
    update_sides(triangulation_.touched());
    return insertion;
}

void Mesh::remove(VertexId vertex) { triangulation_.remove(vertex); }

void Mesh::release_sides(std::span<const VertexId> touched) {
    sides_held_ = false;
    update_sides(touched);
}

void Mesh::update_sides(std::span<const VertexId> touched) {
    first_.resize(triangulation_.vertex_ids());
    sides_index_.resize(triangulation_.vertex_ids(), none);
    if (sides_held_) return;
    for (VertexId v : touched)
        if (triangulation_.on_constraint(v)) update_sides(v);
}

void Mesh::update_sides(VertexId vertex) {
    std::uint32_t& index = sides_index_[vertex.value];
    if (index == none) {
        index = static_cast<std::uint32_t>(sides_.size());
        sides_.emplace_back();
    }
    std::vector<Spoke> fan;
    std::vector<Sector> sectors;
    triangulation_.fan(vertex, fan);
    find_sectors(fan, sectors);
    sides_[index].clear();
    for (const Sector& sector : sectors) {
        const Wedge w = wedge(vertex, fan, sector);
        const auto bound = [&](std::size_t spoke) {
            return fan[spoke].constrained ? fan[spoke].to : VertexId{};
        };
        sides_[index].push_back({w, bound(sector.first),
                                 bound((sector.first + sector.faces) % fan.size()),
                                 in_wedge(vertex, w)});
    }
}

SampleId Mesh::promise(VertexId vertex, glm::dvec2 position) {
    const SampleId id{static_cast<std::uint32_t>(samples_.size())};
    VertexSample sample;
    sample.position = position;
    sample.next = first_[vertex.value];
    samples_.push_back(sample);
    first_[vertex.value] = id;
    if (triangulation_.on_constraint(vertex)) update_sides(vertex);
    return id;
}

void Mesh::answer(SampleId id, const Sample& answer, std::uint32_t item, bool shaded) {
    VertexSample& sample = samples_[id.value];
    sample.colour = answer.colour;
    sample.encoded = display_encoded(answer.colour);
    sample.surface = answer.surface;
    sample.reflected_surface = answer.reflected_surface;
    sample.item = item;
    sample.state = VertexSample::State::known;
    sample.shaded = shaded;
    sample.albedo = answer.albedo;
    sample.illumination = answer.illumination;
    sample.remainder = answer.remainder;
    sum_ += glm::dvec3(answer.colour);
    ++count_;
}

void Mesh::number_again(const std::function<std::uint32_t(const VertexSample&)>& item) {
    for (VertexSample& sample : samples_)
        if (sample.item != DetailMap::unknown) sample.item = item(sample);
}

bool Mesh::relight(SampleId id, const RungLight& light) {
    VertexSample& sample = samples_[id.value];
    if (sample.state != VertexSample::State::known) return false;
    const glm::vec3 encoded = display_encoded(light.colour);
    const bool seen = colour_distance(sample.encoded, encoded) > even_distance;
    sum_ += glm::dvec3(light.colour) - glm::dvec3(sample.colour);
    sample.colour = light.colour;
    sample.encoded = encoded;
    sample.shaded = light.shaded;
    sample.albedo = light.albedo;
    sample.illumination = light.illumination;
    sample.remainder = light.remainder;
    return seen;
}

void Mesh::fail(SampleId id) { samples_[id.value].state = VertexSample::State::failed; }

const VertexSample* Mesh::known(SampleId id) const {
    if (!id.valid()) return nullptr;
    const VertexSample& sample = samples_[id.value];
    return sample.state == VertexSample::State::known ? &sample : nullptr;
}

Wedge Mesh::wedge(VertexId vertex, const std::vector<Spoke>& fan, const Sector& sector) const {
    return {triangulation_.position(vertex), triangulation_.position(fan[sector.first].to),
            triangulation_.position(fan[(sector.first + sector.faces) % fan.size()].to),
            sector.whole};
}

/// Constraints bend when they are split, so that the sample of a thin sector may come to lie in the
/// sector beside it, close to its border: the clearest one counts, of equal ones the latest.
SampleId Mesh::in_wedge(VertexId vertex, const Wedge& wedge) const {
    SampleId best;
    double clearance = -1;
    for (SampleId id = first_[vertex.value]; id.valid(); id = samples_[id.value].next) {
        const glm::dvec2 p = samples_[id.value].position;
        if (!wedge.contains(p)) continue;
        if (const double c = wedge.clearance(p); c > clearance) {
            best = id;
            clearance = c;
        }
    }
    return best;
}

std::size_t Mesh::sides(VertexId vertex) const {
    const std::uint32_t index = sides_index_[vertex.value];
    return index == none ? 1 : sides_[index].size();
}

std::optional<std::size_t> Mesh::side_at(VertexId at, VertexId to, bool left) const {
    const std::uint32_t index = sides_index_[at.value];
    if (index == none) return 0;
    const std::vector<Side>& sides = sides_[index];
    if (sides.size() == 1 && sides[0].wedge.whole) return 0;
    // An edge along a sector's own constraint belongs to it on one side only.
    bool bounds = false;
    for (std::size_t i = 0; i < sides.size(); ++i) {
        if ((left ? sides[i].start : sides[i].end) == to) return i;
        bounds = bounds || (left ? sides[i].end : sides[i].start) == to;
    }
    if (bounds) return std::nullopt;
    const glm::dvec2 p = triangulation_.position(to);
    const bool border = triangulation_.on_border(at);
    for (std::size_t i = 0; i < sides.size(); ++i) {
        const Wedge& w = sides[i].wedge;
        if (w.contains(p) || (border && w.along(left ? w.start : w.end, p))) return i;
    }
    return std::nullopt;
}

SampleId Mesh::side_sample(VertexId vertex, std::size_t side) const {
    const std::uint32_t index = sides_index_[vertex.value];
    return index == none ? first_[vertex.value] : sides_[index][side].sample;
}

SampleId Mesh::corner(VertexId at, VertexId to, bool left) const {
    const auto side = side_at(at, to, left);
    return side ? side_sample(at, *side) : SampleId{};
}

std::optional<float> Mesh::contrast(VertexId a, VertexId b) const {
    std::optional<float> greatest;
    // Only where both ends are on constraints may the edge itself be one, or lie on the border.
    const bool both_sides = triangulation_.on_constraint(a) && triangulation_.on_constraint(b);
    const auto side = [&](bool left) {
        const auto at_a = side_at(a, b, left), at_b = side_at(b, a, !left);
        if (!at_a || !at_b) return;
        const SampleId p = side_sample(a, *at_a), q = side_sample(b, *at_b);
        for (const auto& [vertex, id] : {std::pair{a, p}, std::pair{b, q}}) {
            // A vertex off the constraints is there because of its sample.
            if (!id.valid() && !triangulation_.on_constraint(vertex)) return;
            if (id.valid() && sample(id).state == VertexSample::State::promised) return;
        }
        // A failed sample says nothing; it must not keep its surroundings from being refined.
        float distance = 0;
        if (known(p) && known(q))
            distance = this->distance(sample(p), sample(q));
        else if (!p.valid() && !q.valid() && !triangulation_.labels().find(a, b))
            distance = unknown_distance;
        greatest = std::max(greatest.value_or(0), distance);
    };
    side(true);
    if (!greatest || both_sides) side(false);
    if (greatest && *greatest < unknown_distance && detail_ && stray_pixel(a, b))
        return unknown_distance;
    return greatest;
}

/// How different the picture may be expected to be between two samples, as drawn.
float Mesh::distance(const VertexSample& p, const VertexSample& q) const {
    const float colours = colour_distance(p.encoded, q.encoded);
    if (!detail_) return colours;
    return detailed_distance(*detail_, p, q, colours);
}

std::optional<Pixel> Mesh::stray_pixel(VertexId a, VertexId b) const {
    std::array<std::uint32_t, 4> ends;
    ends.fill(DetailMap::unknown);
    auto end = ends.begin();
    for (const auto& [at, to] : {std::pair{a, b}, std::pair{b, a}})
        for (bool left : {true, false})
            if (const VertexSample* sample = known(corner(at, to, left))) *end++ = sample->item;
    return povpreview::stray_pixel(*detail_, triangulation_.position(a), triangulation_.position(b),
                                   {ends.begin(), end});
}

bool Mesh::seen(VertexId a, VertexId b) const {
    bool even = false;
    for (const auto& [v, w] : {std::pair{a, b}, std::pair{b, a}}) {
        const VertexSample *left = known(corner(v, w, true)), *right = known(corner(v, w, false));
        if (!left || !right) continue;
        if (colour_distance(left->encoded, right->encoded) > even_distance) return true;
        even = true;
    }
    return !even;
}

void Mesh::missing_sides(VertexId vertex, std::vector<MissingSide>& missing) const {
    missing.clear();
    const std::uint32_t index = sides_index_[vertex.value];
    if (index == none) return;
    const std::vector<Side>& sides = sides_[index];
    const auto is_missing = [](const Side& s) { return !s.sample.valid() && !s.thin; };
    if (std::none_of(sides.begin(), sides.end(), is_missing)) return;
    thread_local std::vector<Spoke> fan;
    thread_local std::vector<Sector> sectors;
    triangulation_.fan(vertex, fan);
    find_sectors(fan, sectors);
    const glm::dvec2 v = triangulation_.position(vertex);
    for (const Sector& sector : sectors) {
        const auto side = side_at(vertex, fan[sector.first].to, true);
        if (!side || !is_missing(sides[*side])) continue;
        MissingSide entry{*side, 0, std::nullopt};
        const VertexSample* first = nullptr;
        glm::dvec2 before{};
        for (std::size_t i = 0; i <= sector.faces; ++i) {
            const VertexId neighbour = fan[(sector.first + i) % fan.size()].to;
            const glm::dvec2 u = triangulation_.position(neighbour) - v;
            if (i > 0) entry.area += (before.x * u.y - before.y * u.x) / 2;
            before = u;
            // Of each neighbour, the corner in this sector: to the left as seen from the last one.
            const VertexSample* sample = known(corner(neighbour, vertex, i == sector.faces));
            if (!sample) continue;
            if (!first) first = sample;
            entry.spread = std::max(entry.spread.value_or(0),
                                    colour_distance(first->encoded, sample->encoded));
        }
        missing.push_back(entry);
    }
}

std::optional<SampleId> Mesh::promise_side(VertexId vertex, std::size_t side) {
    std::vector<Spoke> fan;
    std::vector<Sector> sectors;
    triangulation_.fan(vertex, fan);
    find_sectors(fan, sectors);
    for (const Sector& sector : sectors) {
        if (side_at(vertex, fan[sector.first].to, true) != side) continue;
        if (const auto position = side_position(vertex, fan, sector))
            return promise(vertex, *position);
    }
    sides_[sides_index_[vertex.value]][side].thin = true;
    return std::nullopt;
}

/// Along the bisector, so far that the clearance is kept from both sides:
///
///            /            d sin(angle / 2) = clearance
///           /  . p
///          / .            but not beyond the limit, and no more than half way to a constraint or
///         v --------      to the border ahead.
std::optional<glm::dvec2> Mesh::side_position(VertexId vertex, const std::vector<Spoke>& fan,
                                              const Sector& sector) const {
    const Wedge w = wedge(vertex, fan, sector);
    const double half = std::min(w.angle() / 2, std::numbers::pi / 2);
    const glm::dvec2 direction = w.bisector();
    double offset = std::min(side_clearance / std::sin(half), side_offset_limit);
    for (std::size_t i = 0; i < sector.faces; ++i) {
        const VertexId p = fan[(sector.first + i) % fan.size()].to;
        const VertexId q = fan[(sector.first + i + 1) % fan.size()].to;
        Triangulation::Edge ahead{};
        if (!triangulation_.find_edge(p, q, ahead)) continue;
        if (!ahead.constrained && ahead.left.valid() && ahead.right.valid()) continue;
        // The ray centre + t direction meets p + s (q - p).
        const glm::dvec2 u = triangulation_.position(p) - w.centre;
        const glm::dvec2 along = triangulation_.position(q) - triangulation_.position(p);
        const double det = direction.x * along.y - direction.y * along.x;
        if (det == 0) continue;
        const double t = (u.x * along.y - u.y * along.x) / det;
        const double s = (u.x * direction.y - u.y * direction.x) / det;
        if (t > 0 && s >= 0 && s <= 1) offset = std::min(offset, t / 2);
    }
    const glm::dvec2 p = w.centre + offset * direction;
    if (!w.contains(p) || p.x < 0 || p.y < 0 || p.x > width_ || p.y > height_) return std::nullopt;
    return p;
}

void Mesh::draw_edges(Picture& picture, bool constraints_only) const {
    triangulation_.for_each_edge([&](VertexId a, VertexId b, bool constrained) {
        if (!constrained && constraints_only) return;
        const auto label = triangulation_.labels().find(a, b).value_or(ConstraintLabel{});
        picture.lines.push_back({glm::vec2(triangulation_.position(a)),
                                 glm::vec2(triangulation_.position(b)), constrained, label.kind,
                                 label.light});
    });
}

}  // namespace povpreview
