// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/corner_colours.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace povpreview {

namespace {
/// A corner farther than so many edges from any known one takes the mean of all: the picture is
/// blank there for want of samples.
constexpr int farthest = 16;
}  // namespace

CornerColours::CornerColours(const Mesh& mesh) : mesh_(mesh) {
    gather_known();
    gather_neighbours();
    for (bool across : {false, true})
        for (int step = 0; step < farthest && spread(across);) ++step;
    for (const Unknown& u : unknown_)
        if (!known_[u.place]) colours_[u.place] = mesh_.mean_colour();
}

void CornerColours::gather_known() {
    const Triangulation& t = mesh_.triangulation();
    first_.resize(t.vertex_ids() + 1);
    std::uint32_t place = 0;
    for (std::uint32_t i = 0; i < t.vertex_ids(); ++i) {
        first_[i] = place;
        if (t.alive(VertexId{i})) place += static_cast<std::uint32_t>(mesh_.sides(VertexId{i}));
    }
    first_.back() = place;
    colours_.resize(place);
    known_.resize(place);
    for (std::uint32_t i = 0; i < t.vertex_ids(); ++i)
        for (std::uint32_t p = first_[i]; p < first_[i + 1]; ++p) {
            const SampleId id = mesh_.side_sample(VertexId{i}, p - first_[i]);
            known_[p] = id.valid() && mesh_.sample(id).state == VertexSample::State::known;
            if (known_[p])
                colours_[p] = mesh_.sample(id).colour;
            else
                unknown_.push_back({VertexId{i}, p, 0, 0});
        }
}

/// Of an unknown side, the corners that share a face with it.
void CornerColours::gather_neighbours() {
    const Triangulation& t = mesh_.triangulation();
    std::vector<Triangulation::Spoke> fan;
    VertexId last{};
    for (Unknown& u : unknown_) {
        if (u.vertex != last) t.fan(last = u.vertex, fan);
        u.first = static_cast<std::uint32_t>(neighbours_.size());
        const glm::dvec2 centre = t.position(u.vertex);
        for (std::size_t i = 0; i < fan.size(); ++i) {
            if (!fan[i].face) continue;
            const auto side = mesh_.side_at(u.vertex, fan[i].to, true);
            if (!side || first_[u.vertex.value] + *side != u.place) continue;
            // The face u, p, q: of p the corner to the right of p-u, of q that to the left of q-u.
            const VertexId p = fan[i].to, q = fan[(i + 1) % fan.size()].to;
            const auto add = [&](VertexId v, bool left) {
                const auto at = mesh_.side_at(v, u.vertex, left);
                if (!at) return;
                const double distance = glm::distance(t.position(v), centre);
                neighbours_.push_back({v, first_[v.value] + static_cast<std::uint32_t>(*at),
                                       static_cast<float>(1 / (1e-6 + distance))});
            };
            add(p, false);
            add(q, true);
        }
        u.count = static_cast<std::uint32_t>(neighbours_.size()) - u.first;
    }
}

bool CornerColours::mean(const Unknown& u, bool across, glm::vec3& colour) const {
    glm::vec3 sum(0);
    float weights = 0;
    const auto add = [&](std::uint32_t place, float weight) {
        if (!known_[place]) return;
        sum += weight * colours_[place];
        weights += weight;
    };
    for (std::uint32_t i = u.first; i < u.first + u.count; ++i) {
        const Neighbour& n = neighbours_[i];
        if (!across) {
            add(n.place, n.weight);
            continue;
        }
        for (std::uint32_t p = first_[n.vertex.value]; p < first_[n.vertex.value + 1]; ++p)
            add(p, n.weight);
    }
    if (weights > 0) colour = sum / weights;
    return weights > 0;
}

/// One step outwards from what is known; returns whether there was anything to do.
bool CornerColours::spread(bool across) {
    std::vector<std::pair<std::uint32_t, glm::vec3>> found;
    for (const Unknown& u : unknown_) {
        glm::vec3 colour;
        if (!known_[u.place] && mean(u, across, colour)) found.emplace_back(u.place, colour);
    }
    for (const auto& [place, colour] : found) {
        colours_[place] = colour;
        known_[place] = true;
    }
    return !found.empty();
}

glm::vec3 CornerColours::at(VertexId at, VertexId to) const {
    const auto side = mesh_.side_at(at, to, true);
    return side ? colours_[first_[at.value] + *side] : mesh_.mean_colour();
}

void Mesh::draw(Picture& picture) const {
    picture.corners.reserve(picture.corners.size() + 3 * triangulation_.faces());
    const CornerColours colours(*this);
    const auto add = [&](VertexId at, VertexId to) {
        picture.corners.push_back({glm::vec2(triangulation_.position(at)), colours.at(at, to)});
    };
    triangulation_.for_each_face([&](VertexId a, VertexId b, VertexId c) {
        add(a, b);
        add(b, c);
        add(c, a);
    });
}

}  // namespace povpreview
