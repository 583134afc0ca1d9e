// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <memory>

// The order of POV-Ray's headers matters: frame.h first, povdebug.h last.
// clang-format off
#include "backend/frame.h"
#include "backend/scene/view.h"
#include "backend/interior/media.h"
#include "backend/lighting/photons.h"
#include "backend/lighting/radiosity.h"
#include "backend/render/rendertask.h"
#include "backend/render/tracepixel.h"
// clang-format on

#include "backend/oracle/linear_light.h"
#include "backend/oracle/oracle.h"
#include "backend/oracle/sample_recorder.h"
#include "backend/oracle/surface_index.h"

namespace povpreview::tracer {

/// What all threads share: made once, when the scene is parsed.
struct SharedScene {
    SharedScene(const pov::SceneData& scene, float version);

    LinearLight linear;
    SurfaceIndex surfaces;
};

/// One of POV-Ray's threads tracing samples to order, for as long as the previewer lives.
///
/// Stands where POV-Ray's own TraceTask stands, after photons and radiosity pretrace. A sample
/// depends on its position alone: all generators of random numbers start anew from it.
class OracleTask : public pov::RenderTask {
   public:
    OracleTask(pov::ViewData* view, std::shared_ptr<const SharedScene> shared);

    void Run() override;
    void Stopped() override {}
    void Finish() override;

   private:
    class CooperateFunction : public pov::Trace::CooperateFunctor {
       public:
        explicit CooperateFunction(pov::Task& task) : task_(task) {}
        void operator()() override { task_.Cooperate(); }

       private:
        pov::Task& task_;
    };

    void trace_slice(const Slice& slice);
    Sample trace_sample(const Batch& batch, Position position);
    void trace_full(const Batch& batch, Position position, Sample& sample);
    void trace_guide(const Batch& batch, Position position, Sample& sample);
    void add_shading(Sample& sample) const;
    void reseed(Position position);

    std::shared_ptr<const SharedScene> shared_;
    pov::TracePixel trace_;
    CooperateFunction cooperate_;
    pov::MediaFunction media_;
    pov::RadiosityFunction radiosity_;
    pov::PhotonGatherer photon_gatherer_;
    SampleRecorder recorder_;
    std::vector<Sample> samples_;
};

/// Replaces the tasks that render an image: queues the announcement of the scene to the previewer
/// and the tasks that answer it, and the one that sends the geometry. Returns their thread data for
/// POV-Ray's statistics.
std::vector<pov::ViewThreadData*> append_oracle_tasks(pov::TaskQueue& tasks, pov::ViewData& view,
                                                      POVMS_Object& options, int threads);

}  // namespace povpreview::tracer
