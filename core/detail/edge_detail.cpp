// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/detail/edge_detail.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/colour.h"
#include "core/edge_weight.h"
#include "core/mesh.h"

namespace povpreview {

namespace {

/// Share of the distance left across the border of two items that both are known; .02 to 1 serve
/// alike on rendered scenes.
constexpr float border_share = .1f;

/// Shortest stretch of an item worth a sample of its own, in pixels.
constexpr double shortest_stretch = 3;

}  // namespace

float detailed_distance(const DetailMap& detail, const VertexSample& p, const VertexSample& q,
                        float colours) {
    if (p.item == DetailMap::unknown || q.item == DetailMap::unknown) return colours;
    if (p.item != q.item) {
        const bool both = detail.item(detail.pixel_at(p.position)) == p.item &&
                          detail.item(detail.pixel_at(q.position)) == q.item;
        return both ? border_share * colours : colours;
    }
    if (!p.shaded || !q.shaded) return colours;
    const Pixel middle = detail.pixel_at((p.position + q.position) / 2.);
    if (detail.albedo_state(middle) != DetailMap::Albedo::known) return colours;
    return light_distance(p, q);
}

float light_distance(const VertexSample& p, const VertexSample& q) {
    const glm::vec3 albedo = (p.albedo + q.albedo) / 2.f;
    return colour_distance(roughly_encoded(albedo * p.illumination + p.remainder),
                           roughly_encoded(albedo * q.illumination + q.remainder));
}

std::optional<Pixel> stray_pixel(const DetailMap& detail, glm::dvec2 p, glm::dvec2 q,
                                 std::span<const std::uint32_t> ends) {
    const double length = glm::distance(p, q);
    if (length < 2 * shortest_stretch) return std::nullopt;
    const int steps = std::clamp(static_cast<int>(length), 1, 24);
    const auto is_stray = [&](std::uint32_t item) {
        return item != DetailMap::unknown &&
               std::find(ends.begin(), ends.end(), item) == ends.end();
    };
    int longest = 0, end = 0, run = 0;
    for (int i = 1; i < steps; ++i) {
        const Pixel pixel = detail.pixel_at(p + (q - p) * (double(i) / steps));
        run = is_stray(detail.item(pixel)) ? run + 1 : 0;
        if (run > longest) {
            longest = run;
            end = i;
        }
    }
    if (longest * length / steps < shortest_stretch) return std::nullopt;
    return detail.pixel_at(p + (q - p) * ((end - (longest - 1) / 2.) / steps));
}

}  // namespace povpreview
