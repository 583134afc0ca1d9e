// SPDX-License-Identifier: AGPL-3.0-or-later
//
// What pixels of known detail take from the mesh.
#include <algorithm>

#include "core/mesh.h"

namespace povpreview {

namespace {

Picture::Light light_of(const VertexSample& sample) {
    return {sample.illumination, sample.remainder, sample.item, sample.shaded};
}

}  // namespace

void Mesh::draw_lights(Picture& picture) const {
    picture.lights.reserve(picture.corners.size());
    const auto add = [&](VertexId at, VertexId to) {
        const VertexSample* sample = known(corner(at, to, true));
        picture.lights.push_back(sample ? light_of(*sample) : Picture::Light{});
    };
    triangulation_.for_each_face([&](VertexId a, VertexId b, VertexId c) {
        add(a, b);
        add(b, c);
        add(c, a);
    });
}

/// Of each item, every n-th sample.
void Mesh::draw_anchors(Picture& picture, std::size_t items, std::uint32_t most) const {
    const auto is_anchor = [&](const VertexSample& s) {
        return s.state == VertexSample::State::known && s.item < items;
    };
    std::vector<std::uint32_t> seen(items);
    for (const VertexSample& s : samples_)
        if (is_anchor(s)) ++seen[s.item];
    std::vector<std::uint32_t>& first = picture.first_anchors;
    first.assign(items + 1, 0);
    for (std::size_t i = 0; i < items; ++i) first[i + 1] = first[i] + std::min(seen[i], most);
    picture.anchors.resize(first.back());
    std::vector<std::uint32_t> passed(items);
    for (const VertexSample& s : samples_) {
        if (!is_anchor(s)) continue;
        const std::uint64_t i = passed[s.item]++;
        const std::uint64_t kept = first[s.item + 1] - first[s.item];
        // The i-th of n is kept if it is the first of its share of n / kept.
        const std::uint64_t place = i * kept / seen[s.item];
        if (i > 0 && (i - 1) * kept / seen[s.item] == place) continue;
        picture.anchors[first[s.item] + place] = {{glm::vec2(s.position), s.colour}, light_of(s)};
    }
}

}  // namespace povpreview
