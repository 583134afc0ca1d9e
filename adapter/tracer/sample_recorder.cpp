// SPDX-License-Identifier: AGPL-3.0-or-later
#include "backend/oracle/sample_recorder.h"

#include <algorithm>
#include <cmath>

// The order of POV-Ray's headers matters: frame.h first, povdebug.h last.
// clang-format off
#include "backend/frame.h"
#include "backend/lighting/point.h"
#include "backend/render/ray.h"
// clang-format on

#include "backend/oracle/hash.h"
#include "backend/oracle/surface_index.h"
#include "backend/oracle/surface_looks.h"
#include "base/povdebug.h"

namespace povpreview::tracer {

namespace {

/// A layer this transparent has no colour of its own that could be told from rounding.
constexpr double least_opacity = 1e-6;

float finite(double value) { return std::isfinite(value) ? static_cast<float>(value) : 0.0f; }

Rgb rgb(const pov::Vector3d& v) { return {finite(v.x()), finite(v.y()), finite(v.z())}; }

bool is_dark(const pov::RGBColour& c) {
    return std::fabs(c.red()) < EPSILON && std::fabs(c.green()) < EPSILON &&
           std::fabs(c.blue()) < EPSILON;
}

}  // namespace

void SampleRecorder::begin(RayKind kind, bool shading, bool signature) {
    kind_ = kind;
    shading_ = shading;
    signature_ = signature;
    depth_ = 0;
    paused_ = 0;
    rays_ = 0;
    surface_ = 0;
    reflected_surface_ = no_reflection;
    distance_ = 0;
    normal_ = pov::Vector3d(0, 0, 0);
    primary_ = lights_ = reflected_ = refracted_ = 0;
    share_ = 1;
    in_mirror_ = false;
    albedo_sum_.clear();
    illumination_sum_.clear();
}

void SampleRecorder::finish(Sample& sample) const {
    sample.surface = surface_;
    sample.reflected_surface = reflected_surface_;
    sample.depth = finite(distance_);
    sample.normal = rgb(normal_);
    sample.primary = fold(primary_);
    sample.lights = fold(lights_);
    sample.reflected = fold(reflected_);
    sample.refracted = fold(refracted_);
}

pov::RGBColour SampleRecorder::albedo() const { return albedo_sum_ / std::max(1u, rays_); }

pov::RGBColour SampleRecorder::illumination() const {
    return illumination_sum_ / std::max(1u, rays_);
}

void SampleRecorder::enter(const pov::Ray& ray, const pov::Intersection& hit, bool found,
                           bool straight_on) {
    if (paused_ > 0) return;
    if (nodes_.size() <= depth_) nodes_.resize(depth_ + 8);
    Node& node = nodes_[depth_++];
    node.lights.clear();
    node.surface = found ? surfaces_.identity(hit) : 0;
    if (depth_ == 1) {
        ++rays_;
        node.branch = Branch::primary;
        node.path = 1;
        if (rays_ == 1 && found) {
            surface_ = node.surface;
            distance_ = hit.Depth;
        }
        ray_albedo_.clear();
        ray_white_.clear();
        ray_through_ = pov::RGBColour(1.0);
        ray_weight_ = 0;
        ray_reflected_ = pov::RGBColour(1.0);
        mirrors_ = 0;
    } else {
        const Node& parent = nodes_[depth_ - 2];
        const Branch turn = straight_on             ? Branch::primary
                            : ray.IsReflectionRay() ? Branch::reflected
                                                    : Branch::refracted;
        // What lies behind a mirror stays there, however the light goes on from it.
        node.branch = parent.branch == Branch::primary ? turn : parent.branch;
        if (depth_ == 2 && rays_ == 1 && turn == Branch::reflected &&
            reflected_surface_ == no_reflection)
            reflected_surface_ = node.surface;
        node.path = mix(mix(parent.path, parent.surface), static_cast<std::uint64_t>(turn) + 1);
    }
    if (!signature_) return;
    const std::uint64_t seen = mix(node.path, node.surface);
    switch (node.branch) {
        case Branch::primary:
            if (found) primary_ += seen;
            break;
        case Branch::reflected:
            reflected_ += seen;
            break;
        case Branch::refracted:
            refracted_ += seen;
            break;
    }
}

void SampleRecorder::leave() {
    if (paused_ > 0) return;
    if (--depth_ > 0 || !shading_) return;
    albedo_sum_ += ray_albedo_;
    if (ray_weight_ > least_opacity)
        illumination_sum_ += ray_white_ * ray_through_ * ray_reflected_ * (1.0 / ray_weight_);
}

void SampleRecorder::set_normal(const pov::Vector3d& normal) {
    if (paused_ > 0) return;
    nodes_[depth_ - 1].normal = normal;
    if (depth_ == 1 && rays_ == 1) normal_ = normal;
}

double SampleRecorder::scale_share(double factor) {
    const double former = share_;
    share_ *= factor;
    return former;
}

void SampleRecorder::begin_layer(const pov::RGBColour& filter, const pov::RGBColour& pigment,
                                 double opacity) {
    if (!shading_ || !at_shaded_surface()) return;
    layer_filter_ = filter;
    layer_pigment_ = pigment;
    layer_opacity_ = opacity;
    layer_white_.clear();
}

void SampleRecorder::end_layer() {
    if (!shading_ || !at_shaded_surface()) return;
    const double reach = share_ * layer_filter_.greyscale();
    ray_albedo_ += layer_filter_ * layer_pigment_ * (share_ * layer_opacity_);
    ray_white_ += layer_white_ * reach;
    ray_weight_ += reach * layer_opacity_;
}

void SampleRecorder::add_white(const pov::RGBColour& light) {
    if (shading_ && at_shaded_surface()) layer_white_ += light;
}

void SampleRecorder::begin_photons() {
    white_before_photons_ = layer_white_;
    layer_white_.clear();
}

void SampleRecorder::end_photons(double scale) {
    layer_white_ = white_before_photons_ + layer_white_ * scale;
}

bool SampleRecorder::looks_into(const pov::TEXTURE& texture) const {
    return shading_ && at_first_surface() && plain_mirror(texture);
}

void SampleRecorder::begin_mirror(const pov::RGBColour& reflected) {
    if (mirrors_++ == 0) {
        in_mirror_ = true;
        ray_albedo_.clear();
        ray_white_.clear();
        ray_weight_ = 0;
        ray_reflected_.clear();
    }
    ray_reflected_ += reflected * share_;
}

/// What lies before a mirror lies before all that it shows.
void SampleRecorder::attenuate(const pov::RGBColour& transmittance) {
    if (shading_ && (at_first_surface() || at_shaded_surface())) ray_through_ *= transmittance;
}

bool SampleRecorder::wants_light(const pov::LightSource& light) {
    if (!signature_ || paused_ > 0 || depth_ == 0) return false;
    std::vector<const pov::LightSource*>& seen = nodes_[depth_ - 1].lights;
    if (std::find(seen.begin(), seen.end(), &light) != seen.end()) return false;
    seen.push_back(&light);
    return true;
}

void SampleRecorder::light_tested(int index, bool area, const pov::RGBColour& unshadowed,
                                  const pov::RGBColour& shadowed) {
    if (is_dark(shadowed))
        note_light(index, LightState::blocked);
    else if (filtered_)
        note_light(index, LightState::filtered);
    else if (area && pov::colourDistance(unshadowed, shadowed) >
                         1e-4 * (std::fabs(unshadowed.red()) + std::fabs(unshadowed.green()) +
                                 std::fabs(unshadowed.blue())))
        note_light(index, LightState::partly_lit);
    else
        note_light(index, LightState::lit);
}

void SampleRecorder::light_faces_away(int index) { note_light(index, LightState::away); }

void SampleRecorder::note_light(int index, LightState state) {
    const Node& node = nodes_[depth_ - 1];
    const std::uint64_t seen =
        mix(mix(mix(node.path, node.surface), 0x11687 + std::uint64_t(index)),
            static_cast<std::uint64_t>(state));
    switch (node.branch) {
        case Branch::primary:
            lights_ += seen;
            break;
        case Branch::reflected:
            reflected_ += seen;
            break;
        case Branch::refracted:
            refracted_ += seen;
            break;
    }
}

}  // namespace povpreview::tracer
