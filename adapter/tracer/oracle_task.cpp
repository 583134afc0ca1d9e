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

#include "backend/oracle/finishing_pixel.h"
#include "backend/oracle/geometry_task.h"
#include "backend/oracle/scene_description.h"
#include "backend/oracle/seed.h"
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

OracleTask::OracleTask(pov::ViewData* view, std::shared_ptr<const SharedScene> shared)
    : RenderTask(view),
      shared_(std::move(shared)),
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
    GetViewDataPtr()->qualityFlags = view->GetQualityFeatureFlags();
}

void OracleTask::Run() {
    Oracle::instance().serve();
    WorkQueue& queue = Oracle::instance().queue();
    // Samples must not depend on what was traced before, so nothing is added to the radiosity
    // cache any more; each sample starts the same pattern of directions.
    radiosity_.Freeze();
    radiosity_.BeforeTile(0);
    while (true) {
        Cooperate();
        const Slice slice = queue.take(patience);
        if (slice.count > 0) trace_slice(slice);
        if (slice.count == 0 && queue.finished()) return;  // the image is wanted
    }
}

void OracleTask::Finish() {
    GetViewDataPtr()->timeType = pov::SceneThreadData::kRenderTime;
    GetViewDataPtr()->realTime = ConsumedRealTime();
    GetViewDataPtr()->cpuTime = ConsumedCPUTime();
}

void OracleTask::trace_slice(const Slice& slice) {
    const Batch& batch = *slice.batch;
    samples_.clear();
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
    Oracle::instance().queue().learn(batch.kind, slice.count, before - start);
    Oracle::instance().wire().send_answer(slice, samples_);
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
        trace_.SetQualityFlags(GetViewData()->GetQualityFeatureFlags());
        trace_.ForgetRay();
    }
    return sample;
}

void OracleTask::trace_full(const Batch& batch, Position position, Sample& sample) {
    const bool guide = batch.parts.surface || batch.parts.signature;
    // Under focal blur there is no one surface in a sample: that of the central ray stands for it.
    const bool blurred = trace_.HasFocalBlur();
    if (guide && blurred) trace_guide(batch, position, sample);

    const bool record = batch.parts.shading || (guide && !blurred);
    recorder_.begin(RayKind::full, batch.parts.shading, batch.parts.signature && !blurred);
    trace_.SetRecorder(record ? &recorder_ : nullptr);
    reseed(position);
    const auto& view = *GetViewData();
    pov::Colour colour;
    trace_(position.x - 0.5, position.y - 0.5, view.GetWidth(), view.GetHeight(), colour);
    trace_.SetRecorder(nullptr);

    sample.light = shared_->linear(pov::RGBColour(colour));
    sample.transmittance = std::clamp(colour.transm(), 0.0f, 1.0f);
    if (guide && !blurred) recorder_.finish(sample);
    if (batch.parts.shading) add_shading(sample);
    sample.failed = !is_finite(sample.light);
}

/// Probe and albedo rays: POV-Ray's colour is not used, nor media and fog.
void OracleTask::trace_guide(const Batch& batch, Position position, Sample& sample) {
    const bool albedo = batch.kind == RayKind::albedo;
    const unsigned quality = GetViewData()->GetQualityFeatureFlags();
    const auto& view = *GetViewData();
    pov::Colour ignored;
    recorder_.begin(albedo ? RayKind::albedo : RayKind::probe, albedo, batch.parts.signature);
    trace_.SetRecorder(&recorder_);
    trace_.SetQualityFlags(quality & ~Q_VOLUME);
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
    trace_.SetQualityFlags(quality);
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

namespace {

void announce(pov::ViewData* view, bool antialias, const std::string& output,
              std::shared_ptr<const SharedScene> shared) {
    Oracle& oracle = Oracle::instance();
    SceneFacts facts = describe_scene(*view, antialias, shared->linear);
    facts.alpha = view->GetSceneData()->outputAlpha;
    facts.output = output;
    facts.files = oracle.files_read();
    oracle.known().set_size(facts.width, facts.height);
    set_finishing_light({shared, &shared->linear});
    oracle.wire().send_scene(facts);
}

}  // namespace

std::vector<pov::ViewThreadData*> append_oracle_tasks(pov::TaskQueue& tasks, pov::ViewData& view,
                                                      POVMS_Object& options, int threads) {
    const auto shared = std::make_shared<const SharedScene>(
        *view.GetSceneData(), options.TryGetFloat(kPOVAttrib_Version, 0.0f));
    const bool antialias = options.TryGetBool(kPOVAttrib_Antialias, false);
    const bool to_file = options.TryGetBool(kPOVAttrib_OutputToFile, true);
    const std::string output =
        to_file ? pov_base::UCS2toASCIIString(options.TryGetUCS2String(kPOVAttrib_OutputFile, ""))
                : "";
    tasks.AppendFunction([&view, antialias, output, shared](pov::TaskQueue&) {
        announce(&view, antialias, output, shared);
    });
    std::vector<pov::ViewThreadData*> data;
    if (Oracle::instance().geometry_wanted())
        data.push_back(
            dynamic_cast<pov::ViewThreadData*>(tasks.AppendTask(new GeometryTask(&view, shared))));
    for (int i = 0; i < threads; ++i)
        data.push_back(
            dynamic_cast<pov::ViewThreadData*>(tasks.AppendTask(new OracleTask(&view, shared))));
    return data;
}

}  // namespace povpreview::tracer
