// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

// The order of POV-Ray's headers matters: frame.h first, povdebug.h last.
// clang-format off
#include "backend/frame.h"
#include "backend/colour/colour.h"
#include "backend/math/vector.h"
// clang-format on

#include "backend/oracle/samples.h"

namespace pov {
class LightSource;
class Ray;
}  // namespace pov

namespace povpreview::tracer {

class SurfaceIndex;

/// Watches POV-Ray trace one sample and writes down what core/oracle.h calls its parts.
///
/// A `pov::Trace` carries a pointer to one, null except while an oracle task wants parts; the
/// patches call it from the places where POV-Ray knows what is needed. It only watches: nothing it
/// is told flows back into a colour. Probe and albedo rays are the exception, their colour is
/// thrown away, and `shades`, `follows_rays` and `tests_lights` tell POV-Ray what to leave out.
///
///     eye --primary--> surface --reflection--> surface ...      each arrow a call of TraceRay,
///                         |  \--refraction--> surface ...       each surface a node here
///                       lights: lit, blocked, partly lit, filtered
///
/// Shading is that of the first surface, unless that is a mirror of one colour (plain_mirror()): of
/// what it adds itself nothing varies but light, so that the surface that it shows is recorded in
/// its place, with its light as the mirror reflects it. Rays that find it are followed so far.
///
/// Signatures are sums of hashes, one per node or light, of the path from the eye: the order in
/// which POV-Ray visits the branches does not matter.
class SampleRecorder {
   public:
    explicit SampleRecorder(const SurfaceIndex& surfaces) : surfaces_(surfaces) {}

    /// Starts a sample. Every ray from the eye until `finish` belongs to it (focal blur takes
    /// many).
    void begin(RayKind kind, bool shading, bool signature);
    /// Writes the parts into the sample; the remainder is left to the caller, who knows the colour.
    void finish(Sample& sample) const;
    /// Mean albedo and illumination over the rays of the sample, in POV-Ray's working gamma.
    pov::RGBColour albedo() const;
    pov::RGBColour illumination() const;

    bool shades() const { return kind_ == RayKind::full; }
    bool follows_rays() const { return kind_ != RayKind::albedo; }
    bool tests_lights() const { return kind_ != RayKind::albedo; }

    // -- called from POV-Ray while it traces

    void enter(const pov::Ray& ray, const pov::Intersection& hit, bool found, bool straight_on);
    void leave();
    /// Between `pause` and `resume` rays and lights are no part of the ray tree (subsurface light).
    void pause() { ++paused_; }
    void resume() { --paused_; }

    void set_normal(const pov::Vector3d& normal);
    const pov::Vector3d& normal() const { return nodes_[depth_ - 1].normal; }

    /// Share of the texture that is being computed in its surface; returns the former share.
    double scale_share(double factor);
    double set_share(double share) { return std::exchange(share_, share); }

    void begin_layer(const pov::RGBColour& filter, const pov::RGBColour& pigment, double opacity);
    void end_layer();
    /// Light that the layer would scatter if its pigment were white.
    void add_white(const pov::RGBColour& light);
    /// Photons are summed first and divided by their area after.
    void begin_photons();
    void end_photons(double scale);
    /// Whether what a surface with this texture shows is to be recorded in its place.
    bool looks_into(const pov::TEXTURE& texture) const;
    /// Between `begin_mirror` and `end_mirror` the ray goes on that the first surface reflects;
    /// `reflected` is the factor by which its light enters the colour. Of several, as layers
    /// reflect one each, the first stands for all.
    void begin_mirror(const pov::RGBColour& reflected);
    void end_mirror() { in_mirror_ = false; }
    /// Everything seen so far lies behind a medium that lets `transmittance` through.
    void attenuate(const pov::RGBColour& transmittance);

    /// Is this light's state at the current surface still to be recorded? True once a light.
    bool wants_light(const pov::LightSource& light);
    void begin_shadow_test() { filtered_ = false; }
    void shadow_passed_through() { filtered_ = true; }
    /// The outcome of a light that was tested; `index` tells the lights of a surface apart.
    void light_tested(int index, bool area, const pov::RGBColour& unshadowed,
                      const pov::RGBColour& shadowed);
    void light_faces_away(int index);

   private:
    enum class Branch : std::uint8_t { primary, reflected, refracted };
    enum class LightState : std::uint32_t { away = 1, lit, blocked, partly_lit, filtered };

    struct Node {
        std::uint64_t path = 0;
        Branch branch = Branch::primary;
        std::uint32_t surface = 0;
        pov::Vector3d normal;
        std::vector<const pov::LightSource*> lights;
    };

    bool at_first_surface() const { return depth_ == 1 && paused_ == 0; }
    /// Whether the surface is the one whose shading is recorded.
    bool at_shaded_surface() const {
        return paused_ == 0 && (mirrors_ == 0 ? depth_ == 1 : in_mirror_ && depth_ == 2);
    }
    void note_light(int index, LightState state);

    const SurfaceIndex& surfaces_;
    RayKind kind_ = RayKind::full;
    bool shading_ = false, signature_ = false;

    std::vector<Node> nodes_;
    std::size_t depth_ = 0;
    int paused_ = 0;
    bool filtered_ = false;

    unsigned rays_ = 0;  ///< from the eye
    std::uint32_t surface_ = 0, reflected_surface_ = 0;
    double distance_ = 0;
    pov::Vector3d normal_;
    std::uint64_t primary_ = 0, lights_ = 0, reflected_ = 0, refracted_ = 0;

    // Of the shaded surface of the current ray; white light is kept per layer, then weighted.
    double share_ = 1;
    pov::RGBColour layer_filter_, layer_pigment_, layer_white_, white_before_photons_;
    double layer_opacity_ = 0;
    pov::RGBColour ray_albedo_, ray_white_, ray_through_;
    double ray_weight_ = 0;
    unsigned mirrors_ = 0;    ///< rays that the current ray's first surface reflected
    bool in_mirror_ = false;  ///< the first of them is under way
    pov::RGBColour ray_reflected_;
    pov::RGBColour albedo_sum_, illumination_sum_;
};

/// Scopes for use inside POV-Ray; all of them do nothing without a recorder.
class RecordedNode {
   public:
    RecordedNode(SampleRecorder* recorder, const pov::Ray& ray, const pov::Intersection& hit,
                 bool found, bool straight_on)
        : recorder_(recorder) {
        if (recorder_ != nullptr) recorder_->enter(ray, hit, found, straight_on);
    }
    ~RecordedNode() {
        if (recorder_ != nullptr) recorder_->leave();
    }
    RecordedNode(const RecordedNode&) = delete;
    RecordedNode& operator=(const RecordedNode&) = delete;

   private:
    SampleRecorder* recorder_;
};

class RecordedShare {
   public:
    RecordedShare(SampleRecorder* recorder, double factor) : recorder_(recorder) {
        if (recorder_ != nullptr) former_ = recorder_->scale_share(factor);
    }
    ~RecordedShare() {
        if (recorder_ != nullptr) recorder_->set_share(former_);
    }
    RecordedShare(const RecordedShare&) = delete;
    RecordedShare& operator=(const RecordedShare&) = delete;

   private:
    SampleRecorder* recorder_;
    double former_ = 1;
};

class RecordedMirror {
   public:
    RecordedMirror(SampleRecorder* recorder, const pov::RGBColour& reflected)
        : recorder_(recorder) {
        if (recorder_ == nullptr) return;
        recorder_->begin_mirror(reflected);
        former_share_ = recorder_->set_share(1);
    }
    ~RecordedMirror() {
        if (recorder_ == nullptr) return;
        recorder_->set_share(former_share_);
        recorder_->end_mirror();
    }
    RecordedMirror(const RecordedMirror&) = delete;
    RecordedMirror& operator=(const RecordedMirror&) = delete;

   private:
    SampleRecorder* recorder_;
    double former_share_ = 1;
};

class RecordingPause {
   public:
    explicit RecordingPause(SampleRecorder* recorder) : recorder_(recorder) {
        if (recorder_ != nullptr) recorder_->pause();
    }
    ~RecordingPause() {
        if (recorder_ != nullptr) recorder_->resume();
    }
    RecordingPause(const RecordingPause&) = delete;
    RecordingPause& operator=(const RecordingPause&) = delete;

   private:
    SampleRecorder* recorder_;
};

}  // namespace povpreview::tracer
