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

#include "backend/oracle/beside_task.h"
#include "backend/oracle/ladder.h"
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
    std::vector<RungKind> rungs;  ///< cheapest first, the target last
};

/// One of POV-Ray's threads tracing samples to order.
///
/// A sample of the lowest rung and of the target depends on its position alone: all generators of
/// random numbers start anew from it.
class OracleTask : public pov::RenderTask, public BesideTask {
   public:
    enum class Stage {
        early,  ///< beside photons and radiosity pretrace, for all rungs but the target
        final   ///< where POV-Ray's own TraceTask stands, for as long as the previewer lives
    };

    OracleTask(pov::ViewData* view, std::shared_ptr<const SharedScene> shared, Stage stage);

    void Run() override;
    void Stopped() override {}
    void Finish() override;
    bool is_beside() const override { return stage_ == Stage::early; }

   private:
    class CooperateFunction : public pov::Trace::CooperateFunctor {
       public:
        explicit CooperateFunction(pov::Task& task) : task_(task) {}
        void operator()() override { task_.Cooperate(); }

       private:
        pov::Task& task_;
    };

    void let_preparation_go_first();
    void trace_slice(const Slice& slice);
    RungKind rung_for(const Batch& batch) const;
    void set_rung(RungKind rung);
    Sample trace_sample(const Batch& batch, Position position);
    void trace_full(const Batch& batch, Position position, Sample& sample);
    void trace_guide(const Batch& batch, Position position, Sample& sample);
    void add_shading(Sample& sample) const;
    void reseed(Position position);

    std::shared_ptr<const SharedScene> shared_;
    Stage stage_;
    RungKind rung_ = RungKind::target;
    unsigned quality_;  ///< POV-Ray's quality flags for that rung
    bool gives_way_ = false;
    pov::TracePixel trace_;
    CooperateFunction cooperate_;
    pov::MediaFunction media_;
    pov::RadiosityFunction radiosity_;
    pov::PhotonGatherer photon_gatherer_;
    SampleRecorder recorder_;
    std::vector<Sample> samples_;
};

}  // namespace povpreview::tracer
