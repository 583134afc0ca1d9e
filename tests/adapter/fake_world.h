// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <glm/geometric.hpp>

#include "core/oracle.h"

/// What the fake tracer sees: two discs over a gradient, 64 x 48 pixels. Header only, so that the
/// tests compute the same samples without any process between.
namespace povpreview::fake {

constexpr int width = 64, height = 48;

inline std::uint32_t surface_at(const glm::dvec2& p) {
    if (glm::length(p - glm::dvec2(20, 20)) < 12) return 1;
    if (glm::length(p - glm::dvec2(44, 28)) < 9) return 2;
    return 0;
}

/// The full answer at a position; `cost_ns` is the only part that varies from run to run.
inline Sample sample_at(const glm::dvec2& p) {
    const auto x = static_cast<float>(p.x), y = static_cast<float>(p.y);
    Sample s;
    s.position = p;
    s.surface = surface_at(p);
    s.reflected_surface = s.surface + 5;
    const auto id = static_cast<float>(s.surface);
    s.transmittance = s.surface ? 0.F : 1.F;
    s.albedo = {.25F * id, .5F, 1 - .25F * id};
    s.illumination = {x / width, y / height, 1};
    s.remainder = {0, .125F * id, -.5F};
    s.colour = s.albedo * s.illumination + s.remainder;
    s.depth = s.surface ? 10 + x : 0;
    s.normal = {0, 0, s.surface ? -1.F : 0.F};
    s.signature = {7 * s.surface, s.surface + 1, 3, 1000000007};
    s.cost_ns = 1234;
    return s;
}

/// What the colour is multiplied by on a rung of the ladder; 1 on the target.
inline float rung_scale(Rung rung) {
    return rung == target_rung ? 1.F : .25F * static_cast<float>(rung + 1);
}

/// What is left of it for a ray of this kind.
inline Sample sample_at(const glm::dvec2& p, RayKind kind, Parts parts) {
    const Sample all = sample_at(p);
    const bool full = kind == RayKind::full;
    Sample s;
    s.position = p;
    s.kind = kind;
    s.cost_ns = all.cost_ns;
    if (full) {
        s.colour = all.colour;
        s.transmittance = all.transmittance;
    }
    if (!full || contains(parts, Parts::surface)) {
        s.surface = all.surface;
        s.reflected_surface = all.reflected_surface;
        s.depth = all.depth;
        s.normal = all.normal;
    }
    if (kind == RayKind::albedo || (full && contains(parts, Parts::shading))) s.albedo = all.albedo;
    if (full && contains(parts, Parts::shading)) {
        s.illumination = all.illumination;
        s.remainder = all.remainder;
    }
    if (kind == RayKind::probe || (full && contains(parts, Parts::signature)))
        s.signature = all.signature;
    return s;
}

}  // namespace povpreview::fake
