// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/mesh.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "core/colour.h"
#include "core/edge_weight.h"

namespace povpreview {

using Spoke = Triangulation::Spoke;

namespace {

/// The sector that holds the face after spoke `spoke`.
const Sector& sector_of(const std::vector<Sector>& sectors, std::size_t spoke, std::size_t spokes) {
    for (const Sector& sector : sectors)
        if ((spoke + spokes - sector.first) % spokes < sector.faces) return sector;
    return sectors.back();
}

std::size_t find_spoke(const std::vector<Spoke>& fan, VertexId to) {
    std::size_t i = 0;
    while (i < fan.size() && fan[i].to != to) ++i;
    return i;
}

}  // namespace

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
        sides_[index].push_back({w, in_wedge(vertex, w)});
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

void Mesh::answer(SampleId id, const glm::vec3& colour, std::uint32_t surface) {
    VertexSample& sample = samples_[id.value];
    sample.colour = colour;
    sample.encoded = display_encoded(colour);
    sample.surface = surface;
    sample.state = VertexSample::State::known;
    sum_ += glm::dvec3(colour);
    ++count_;
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

SampleId Mesh::in_wedge(VertexId vertex, const Wedge& wedge) const {
    for (SampleId id = first_[vertex.value]; id.valid(); id = samples_[id.value].next)
        if (wedge.contains(samples_[id.value].position)) return id;
    return {};
}

SampleId Mesh::corner(VertexId at, VertexId to, bool left) const {
    const std::uint32_t index = sides_index_[at.value];
    if (index == none) return first_[at.value];
    const glm::dvec2 p = triangulation_.position(to);
    for (const Side& side : sides_[index]) {
        const Wedge& w = side.wedge;
        if (w.whole || w.contains(p)) return side.sample;
        // An edge along a sector's own constraint belongs to it on one side only.
        if (w.along(left ? w.start : w.end, p)) return side.sample;
    }
    return {};  // outside the image
}

std::optional<float> Mesh::contrast(VertexId a, VertexId b) const {
    std::optional<float> greatest;
    const auto side = [&](bool left) {
        const SampleId p = corner(a, b, left), q = corner(b, a, !left);
        if (!p.valid() || !q.valid()) return;
        const VertexSample &s = sample(p), &t = sample(q);
        if (s.state == VertexSample::State::promised || t.state == VertexSample::State::promised)
            return;
        // A failed sample says nothing; it must not keep its surroundings from being refined.
        const bool both = known(p) && known(q);
        greatest =
            std::max(greatest.value_or(0), both ? colour_distance(s.encoded, t.encoded) : 0.f);
    };
    side(true);
    // Only where both ends are on constraints may the edge itself be one, or lie on the border.
    if (!greatest || (triangulation_.on_constraint(a) && triangulation_.on_constraint(b)))
        side(false);
    return greatest;
}

bool Mesh::mean_nearby(VertexId at, VertexId to, int depth, glm::vec3& mean) const {
    std::vector<Spoke> fan;
    std::vector<Sector> sectors;
    triangulation_.fan(at, fan);
    if (triangulation_.on_constraint(at))
        find_sectors(fan, sectors);
    else
        sectors.push_back({0, fan.back().face ? fan.size() : fan.size() - 1, true});
    const std::size_t spoke = find_spoke(fan, to);
    if (spoke == fan.size()) return false;
    const Sector sector = sector_of(sectors, spoke, fan.size());
    const glm::dvec2 centre = triangulation_.position(at);
    glm::vec3 sum(0);
    float weights = 0;
    for (std::size_t i = 0; i <= sector.faces; ++i) {
        // Of each neighbour, the corner that lies in this sector: on the last spoke it is the one
        // to the left seen from there, on the others the one to the right.
        const VertexId neighbour = fan[(sector.first + i) % fan.size()].to;
        const bool last = i == sector.faces;
        const VertexSample* sample = known(corner(neighbour, at, last));
        glm::vec3 colour;
        if (sample) {
            colour = sample->colour;
        } else if (depth < 2) {
            const VertexId previous =
                last ? at : fan[(sector.first + i + 1) % fan.size()].to;  // its face's other vertex
            if (!mean_nearby(neighbour, last ? at : previous, depth + 1, colour)) continue;
        } else {
            continue;
        }
        const float weight =
            1 / static_cast<float>(1e-6 + glm::length(triangulation_.position(neighbour) - centre));
        sum += weight * colour;
        weights += weight;
    }
    if (weights <= 0) return false;
    mean = sum / weights;
    return true;
}

glm::vec3 Mesh::corner_colour(VertexId at, VertexId to) const {
    if (const VertexSample* sample = known(corner(at, to, true))) return sample->colour;
    glm::vec3 mean;
    if (mean_nearby(at, to, 1, mean)) return mean;
    for (SampleId id = first_[at.value]; id.valid(); id = samples_[id.value].next)
        if (const VertexSample* sample = known(id)) return sample->colour;
    return count_ ? glm::vec3(sum_ / static_cast<double>(count_)) : glm::vec3(0);
}

void Mesh::missing_positions(VertexId vertex, std::vector<glm::dvec2>& positions,
                             double scale) const {
    std::vector<Spoke> fan;
    std::vector<Sector> sectors;
    triangulation_.fan(vertex, fan);
    find_sectors(fan, sectors);
    positions.clear();
    for (const Sector& sector : sectors)
        if (!in_wedge(vertex, wedge(vertex, fan, sector)).valid())
            if (const auto p = side_position(vertex, fan, sector, scale)) positions.push_back(*p);
}

/// Along the bisector, so far that the clearance is kept from both sides:
///
///            /            d sin(angle / 2) = clearance
///           /  . p
///          / .            but not beyond the limit, and no more than half way to a constraint or
///         v --------      to the border ahead.
std::optional<glm::dvec2> Mesh::side_position(VertexId vertex, const std::vector<Spoke>& fan,
                                              const Sector& sector, double scale) const {
    const Wedge w = wedge(vertex, fan, sector);
    const double half = std::min(w.angle() / 2, std::numbers::pi / 2);
    const glm::dvec2 direction = w.bisector();
    double offset = std::min(scale * side_clearance / std::sin(half), side_offset_limit);
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

void Mesh::draw(Picture& picture) const {
    picture.corners.reserve(picture.corners.size() + 3 * triangulation_.faces());
    // Most corners are those of plain vertices: gathered first, each is one look into memory.
    std::vector<Picture::Corner> plain(first_.size());
    std::vector<std::uint8_t> is_plain(first_.size());
    for (std::uint32_t i = 0; i < first_.size(); ++i) {
        const VertexSample* sample = known(first_[i]);
        is_plain[i] = sample && sides_index_[i] == none;
        if (is_plain[i])
            plain[i] = {glm::vec2(triangulation_.position(VertexId{i})), sample->colour};
    }
    const auto add = [&](VertexId at, VertexId to) {
        if (is_plain[at.value])
            picture.corners.push_back(plain[at.value]);
        else
            picture.corners.push_back(
                {glm::vec2(triangulation_.position(at)), corner_colour(at, to)});
    };
    triangulation_.for_each_face([&](VertexId a, VertexId b, VertexId c) {
        add(a, b);
        add(b, c);
        add(c, a);
    });
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
