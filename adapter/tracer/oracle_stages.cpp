// SPDX-License-Identifier: AGPL-3.0-or-later
#include "backend/oracle/oracle_stages.h"

#include <algorithm>
#include <chrono>
#include <thread>

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
#include "base/povdebug.h"

namespace povpreview::tracer {

namespace {

/// The image file that POV-Ray would make; empty: none.
std::string output_file(POVMS_Object& options) {
    if (!options.TryGetBool(kPOVAttrib_OutputToFile, true)) return "";
    return pov_base::UCS2toASCIIString(options.TryGetUCS2String(kPOVAttrib_OutputFile, ""));
}

/// What will be read only when the scene has been announced.
void note_later_files(const pov::SceneData& scene) {
    const auto& photons = scene.photonSettings;
    if (photons.photonsEnabled && photons.loadFile && photons.fileName)
        Oracle::instance().note_read(photons.fileName);
}

/// Radiosity's pretrace goes over the image again and again, each time twice as finely; the first
/// times take the longest. After a quarter of the first it is known how bright things are, and with
/// that the rung below the target is worth looking at.
void announce_pretrace(const SceneFacts& facts) {
    for (std::size_t i = 0; i + 1 < facts.rungs.size(); ++i)
        if (!facts.rungs[i].ready)
            Oracle::instance().announce_rung(
                static_cast<std::uint8_t>(i),
                std::max<std::uint64_t>(1, std::uint64_t{facts.width} * facts.height / 4));
}

/// Samples of a first look. Each is soon traced again where radiosity is prepared, which takes both
/// processors for a moment only in many scenes: there they are as many as a first grid takes
/// (raddem and six more at 640x480 come to an error of .02 in .72 of the time that 2400 let them).
/// Photons change less of a picture.
unsigned first_look(const SceneFacts& scene) {
    const unsigned look = scene.width * scene.height / 128;
    return scene.features.count("radiosity") ? std::min(320u, look) : look;
}

/// Waits while the previewer makes a first picture, so that preparing the target does not compete
/// with it.
class FirstLookTask : public pov::RenderTask {
   public:
    FirstLookTask(pov::ViewData* view, Stage next) : RenderTask(view), next_(next) {}

    void Run() override {
        while (!Oracle::instance().first_look_over()) {
            Cooperate();
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        Oracle::instance().progress(next_, 0, 0);
    }
    void Stopped() override {}
    void Finish() override {}

   private:
    Stage next_;
};

}  // namespace

OracleStages::OracleStages(pov::TaskQueue& tasks, pov::ViewData& view,
                           std::vector<pov::ViewThreadData*>& data, int threads)
    : tasks_(tasks), view_(view), data_(data), threads_(threads) {}

void OracleStages::append(pov::RenderTask* task) {
    data_.push_back(dynamic_cast<pov::ViewThreadData*>(tasks_.AppendTask(task)));
}

void OracleStages::append_early(POVMS_Object& options) {
    if (!enabled()) return;
    const pov::SceneData& scene = *view_.GetSceneData();
    const auto shared =
        std::make_shared<SharedScene>(scene, options.TryGetFloat(kPOVAttrib_Version, 0.0f));
    const auto facts = std::make_shared<SceneFacts>(
        describe_scene(view_, options.TryGetBool(kPOVAttrib_Antialias, false), shared->linear));
    const bool prepares = needs_preparation(facts->features);
    facts->first_look = first_look(*facts);
    shared->rungs = rungs_of(facts->features);
    facts->rungs = describe_rungs(shared->rungs, facts->features);
    facts->alpha = scene.outputAlpha;
    facts->output = output_file(options);
    note_later_files(scene);
    facts->files = Oracle::instance().files_read();
    shared_ = shared;
    Oracle::instance().known().set_size(facts->width, facts->height);
    set_finishing_light({shared_, &shared_->linear});
    announce_pretrace(*facts);
    tasks_.AppendFunction([facts, prepares](pov::TaskQueue&) {
        if (!prepares) Oracle::instance().queue().release_target();
        Oracle::instance().begin_first_look(facts->first_look);
        Oracle::instance().wire().send_scene(*facts);
    });
    if (!prepares) return;
    for (int i = 0; i < threads_; ++i)
        append(new OracleTask(&view_, shared_, OracleTask::Stage::early));
    append(new FirstLookTask(
        &view_, scene.photonSettings.photonsEnabled ? Stage::photons : Stage::radiosity));
    append_geometry();
    tasks_.AppendSync();
}

/// After the threads that trace: those shall not wait for it to be made.
void OracleStages::append_geometry() {
    if (geometry_appended_ || !Oracle::instance().geometry_wanted()) return;
    geometry_appended_ = true;
    append(new GeometryTask(&view_, shared_));
}

void OracleStages::append_final() {
    if (!enabled()) return;
    const auto target = static_cast<std::uint8_t>(shared_->rungs.size() - 1);
    tasks_.AppendFunction([target](pov::TaskQueue&) {
        if (Oracle::instance().queue().target_released()) return;
        Oracle::instance().queue().release_target();
        Oracle::instance().progress(Stage::ready, 0, 0);
        Oracle::instance().wire().send_rung_ready(target);
    });
    for (int i = 0; i < threads_; ++i)
        append(new OracleTask(&view_, shared_, OracleTask::Stage::final));
    append_geometry();
}

}  // namespace povpreview::tracer
