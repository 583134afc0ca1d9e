// SPDX-License-Identifier: AGPL-3.0-or-later
#include "backend/oracle/oracle_task.h"

#include <chrono>
#include <cmath>

// The order of POV-Ray's headers matters: frame.h first, povdebug.h last.
// clang-format off
#include "backend/frame.h"
#include "backend/scene/scene.h"
#include "backend/scene/view.h"
#include "base/povmsgid.h"
// clang-format on

#include "backend/oracle/give_way.h"
#include "backend/oracle/seed.h"
#include "backend/oracle/trace_flags.h"
#include "base/povdebug.h"

namespace povpreview::tracer {

namespace {

using Clock = std::chrono::steady_clock;

/// How long a thread waits for orders before it looks whether POV-Ray wants it to stop.
constexpr auto patience = std::chrono::milliseconds(50);

bool is_finite(const Rgb& c) {
    return std::isfinite(c.r) && std::isfinite(c.g) && std::isfinite(c.b);
}

}  // namespace

SharedScene::SharedScene(const pov::SceneData& scene, float version)
    : linear(scene, version), surfaces(scene.objects) {}

OracleTask::OracleTask(pov::ViewData* view, std::shared_ptr<const SharedScene> shared, Stage stage)
    : RenderTask(view),
      shared_(std::move(shared)),
      stage_(stage),
      quality_(view->GetQualityFeatureFlags()),
      trace_(view, GetViewDataPtr(), view->GetSceneData()->parsedMaxTraceLevel,
             view->GetSceneData()->parsedAdcBailout, view->GetQualityFeatureFlags(), cooperate_,
             media_, radiosity_),
      cooperate_(*this),
      media_(GetViewDataPtr(), &trace_, &photon_gatherer_),
      radiosity_(view->GetSceneData(), GetViewDataPtr(), view->GetSceneData()->radiositySettings,
                 view->GetRadiosityCache(), cooperate_, true,
                 pov::Vector3d(view->GetCamera().Location)),
      photon_gatherer_(&view->GetSceneData()->mediaPhotonMap, view->GetSceneData()->photonSettings),
      recorder_(shared_->surfaces) {
    set_rung(RungKind::target);
}

void OracleTask::Run() {
    const bool final = stage_ == Stage::final;
    if (final) Oracle::instance().serve();
    WorkQueue& queue = Oracle::instance().queue();
    // Samples must not depend on what was traced before, so nothing is added to the radiosity
    // cache any more; each sample starts the same pattern of directions.
    radiosity_.Freeze();
    radiosity_.BeforeTile(0);
    while (final || !queue.target_released()) {
        Cooperate();
        if (!final) let_preparation_go_first();
        const Slice slice = queue.take(patience, final);
        if (slice.count > 0) trace_slice(slice);
        if (slice.count == 0 && queue.finished()) return;  // the image is wanted
    }
    radiosity_.AfterTile();
}

/// A while after the previewer has had its first look, preparing the target comes first.
void OracleTask::let_preparation_go_first() {
    if (gives_way_ || !Oracle::instance().preparation_first()) return;
    gives_way_ = true;
    give_way();
}

/// The rung that a batch is traced at: that asked for, or a higher one. Samples that were to do
/// without preparation have the target as soon as it is ready.
RungKind OracleTask::rung_for(const Batch& batch) const {
    const std::size_t last = shared_->rungs.size() - 1;
    const RungKind rung = shared_->rungs[std::min<std::size_t>(batch.rung, last)];
    if (rung == RungKind::unprepared && stage_ == Stage::final) return RungKind::target;
    return rung;
}

void OracleTask::set_rung(RungKind rung) {
    const bool sketch = rung == RungKind::sketch;
    constexpr unsigned dear = Q_AREA_LIGHT | Q_SUBSURFACE | Q_ADVANCED_LIGHT;
    const unsigned all = GetViewData()->GetQualityFeatureFlags();
    rung_ = rung;
    quality_ = sketch ? all & ~dear : all;
    trace_.SetQualityFlags(quality_);
    const bool early = stage_ == Stage::early;
    GetViewDataPtr()->qualityFlags = all | (sketch || early ? ignore_photons : 0) |
                                     (early ? radiosity_so_far : 0) | (sketch ? coarse_media : 0);
}

void OracleTask::Finish() {
    GetViewDataPtr()->timeType = pov::SceneThreadData::kRenderTime;
    GetViewDataPtr()->realTime = ConsumedRealTime();
    GetViewDataPtr()->cpuTime = ConsumedCPUTime();
}

void OracleTask::trace_slice(const Slice& slice) {
    const Batch& batch = *slice.batch;
    samples_.clear();
    set_rung(batch.kind == RayKind::full ? rung_for(batch) : RungKind::target);
    const Clock::time_point start = Clock::now();
    Clock::time_point before = start;
    for (std::size_t i = slice.first; i < slice.first + slice.count; ++i) {
        samples_.push_back(trace_sample(batch, batch.positions[i]));
        const Clock::time_point after = Clock::now();
        const auto cost = std::chrono::duration_cast<std::chrono::nanoseconds>(after - before);
        samples_.back().cost_ns =
            static_cast<std::uint32_t>(std::min<std::int64_t>(cost.count(), UINT32_MAX));
        before = after;
    }
    if (stage_ == Stage::early && batch.kind == RayKind::full)
        Oracle::instance().note_early_samples(slice.count);
    Oracle::instance().queue().learn(batch, slice.count, before - start);
    const std::uint8_t rung = rung_ == RungKind::target ? target_rung : batch.rung;
    Oracle::instance().wire().send_answer(slice, rung, samples_);
    GetViewDataPtr()->AfterTile();  // lets the cache of the crackle pattern shrink
}

Sample OracleTask::trace_sample(const Batch& batch, Position position) {
    Sample sample;
    if (!std::isfinite(position.x) || !std::isfinite(position.y)) {
        sample.failed = true;
        return sample;
    }
    // Never catch (...) here: POV-Ray cancels a task by an exception of a type of its own.
    try {
        if (batch.kind == RayKind::full)
            trace_full(batch, position, sample);
        else
            trace_guide(batch, position, sample);
    } catch (pov_base::Exception&) {
        sample.failed = true;
    } catch (std::exception&) {
        sample.failed = true;
    }
    if (sample.failed) {
        sample = Sample{};
        sample.failed = true;
        trace_.SetRecorder(nullptr);
        set_rung(rung_);
        trace_.ForgetRay();
    }
    return sample;
}

void OracleTask::trace_full(const Batch& batch, Position position, Sample& sample) {
    const bool guide = batch.parts.surface || batch.parts.signature;
    // Under focal blur there is no one surface in a sample: that of the central ray stands for it.
    const bool blurred = trace_.HasFocalBlur() && rung_ != RungKind::sketch;
    if (guide && blurred) trace_guide(batch, position, sample);

    const bool record = batch.parts.shading || (guide && !blurred);
    recorder_.begin(RayKind::full, batch.parts.shading, batch.parts.signature && !blurred);
    trace_.SetRecorder(record ? &recorder_ : nullptr);
    reseed(position);
    const auto& view = *GetViewData();
    pov::Colour colour;
    const double x = position.x - 0.5, y = position.y - 0.5;
    if (rung_ == RungKind::sketch)
        trace_.TraceCentre(x, y, view.GetWidth(), view.GetHeight(), colour);
    else
        trace_(x, y, view.GetWidth(), view.GetHeight(), colour);
    trace_.SetRecorder(nullptr);

    sample.light = shared_->linear(pov::RGBColour(colour));
    sample.transmittance = std::min(std::max(0.0f, colour.transm()), 1.0f);  // NaN: none
    if (guide && !blurred) recorder_.finish(sample);
    if (batch.parts.shading) add_shading(sample);
}

/// Probe and albedo rays: POV-Ray's colour is not used, nor media and fog. They are the same at any
/// time: where photons are not shot yet, they will be.
void OracleTask::trace_guide(const Batch& batch, Position position, Sample& sample) {
    const bool albedo = batch.kind == RayKind::albedo;
    const auto& view = *GetViewData();
    pov::Colour ignored;
    recorder_.begin(albedo ? RayKind::albedo : RayKind::probe, albedo, batch.parts.signature);
    trace_.SetRecorder(&recorder_);
    trace_.SetQualityFlags(quality_ & ~Q_VOLUME);
    GetViewDataPtr()->qualityFlags = quality_ | (stage_ == Stage::early ? presume_photons : 0);
    reseed(position);
    trace_.TraceCentre(position.x - 0.5, position.y - 0.5, view.GetWidth(), view.GetHeight(),
                       ignored);
    recorder_.finish(sample);
    if (albedo && trace_.HasFocalBlur()) {
        // The pigment of a blurred sample is the mean over the lens, as it is for full rays.
        recorder_.begin(RayKind::albedo, true, false);
        trace_(position.x - 0.5, position.y - 0.5, view.GetWidth(), view.GetHeight(), ignored);
    }
    if (albedo) sample.albedo = shared_->linear(recorder_.albedo());
    set_rung(rung_);
    trace_.SetRecorder(nullptr);
}

void OracleTask::add_shading(Sample& sample) const {
    const Rgb albedo = shared_->linear(recorder_.albedo());
    const Rgb illumination = shared_->linear(recorder_.illumination());
    if (is_finite(albedo) && is_finite(illumination)) {
        sample.albedo = albedo;
        sample.illumination = illumination;
    }
    const auto rest = [](float light, float a, float i) { return light - a * i; };
    sample.remainder = {rest(sample.light.r, sample.albedo.r, sample.illumination.r),
                        rest(sample.light.g, sample.albedo.g, sample.illumination.g),
                        rest(sample.light.b, sample.albedo.b, sample.illumination.b)};
}

void OracleTask::reseed(Position position) {
    const std::size_t seed = seed_of(position);
    trace_.Reseed(seed);
    media_.Reseed(seed);
    radiosity_.Reseed(seed);
}

}  // namespace povpreview::tracer
