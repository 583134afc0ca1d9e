// SPDX-License-Identifier: AGPL-3.0-or-later
#include "backend/oracle/geometry_task.h"

#include <chrono>
#include <exception>
#include <thread>

// The order of POV-Ray's headers matters: frame.h first, povdebug.h last.
// clang-format off
#include "backend/frame.h"
#include "backend/scene/objects.h"
#include "backend/scene/scene.h"
#include "backend/scene/view.h"
// clang-format on

#include "backend/oracle/geometry_export.h"
#include "base/povdebug.h"

namespace povpreview::tracer {

GeometryTask::GeometryTask(pov::ViewData* view, std::shared_ptr<const SharedScene> shared)
    : RenderTask(view), shared_(std::move(shared)) {}

void GeometryTask::Run() {
    const pov::Camera& camera = GetViewData()->GetCamera();
    const auto inside = [this](const Point& p, const pov::ObjectBase& object) {
        const pov::VECTOR point = {p.x, p.y, p.z};
        // POV-Ray's own does not change the object, only its thread's statistics.
        return pov::Inside_Object(point, const_cast<pov::ObjectPtr>(&object), GetViewDataPtr());
    };
    // Whatever goes wrong here costs edges, never the picture. Not (...): POV-Ray cancels a task by
    // an exception of a type of its own.
    try {
        GeometryExport({shared_->surfaces,
                        {camera.Location[0], camera.Location[1], camera.Location[2]},
                        inside,
                        [this] { Cooperate(); },
                        [this](const GeometryChunk& chunk) { send(chunk); }})
            .run(GetSceneData()->objects);
    } catch (std::exception&) {
        GeometryChunk end;
        end.left_out[{"the rest", "out of memory or broken", false}] = 1;
        end.unknown.push_back(everything);
        end.last = true;
        send(end);
    }
}

/// Waits until nothing else is to be sent, so that no answer waits for more than one chunk.
void GeometryTask::send(const GeometryChunk& chunk) {
    WireEnd& wire = Oracle::instance().wire();
    while (wire.is_busy()) {
        Cooperate();
        std::this_thread::sleep_for(std::chrono::microseconds(200));
    }
    wire.send_geometry(chunk);
}

void GeometryTask::Finish() {
    GetViewDataPtr()->timeType = pov::SceneThreadData::kRenderTime;
    GetViewDataPtr()->realTime = ConsumedRealTime();
    GetViewDataPtr()->cpuTime = ConsumedCPUTime();
}

}  // namespace povpreview::tracer
