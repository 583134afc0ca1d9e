// SPDX-License-Identifier: AGPL-3.0-or-later
#include "backend/oracle/geometry_task.h"

#include <algorithm>
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

#include "backend/oracle/give_way.h"
#include "base/povdebug.h"

namespace povpreview::tracer {

GeometryTask::GeometryTask(pov::ViewData* view, std::shared_ptr<const SharedScene> shared)
    : RenderTask(view), shared_(std::move(shared)) {}

void GeometryTask::Run() {
    wait_for_first_answers();
    give_way();
    const pov::Camera& camera = GetViewData()->GetCamera();
    const auto inside = [this](const Point& p, const pov::ObjectBase& object) {
        const pov::VECTOR point = {p.x, p.y, p.z};
        // POV-Ray's own does not change the object, only its thread's statistics.
        return pov::Inside_Object(point, const_cast<pov::ObjectPtr>(&object), GetViewDataPtr());
    };
    GeometryExport geometry({shared_->surfaces,
                             shared_->linear,
                             {camera.Location[0], camera.Location[1], camera.Location[2]},
                             inside,
                             [this] { Cooperate(); },
                             [this](const GeometryChunk& chunk) {
                                 wait_for_wire();
                                 Oracle::instance().wire().send_geometry(chunk);
                             }});
    if (!send_geometry(geometry)) return;
    // Reading and drawing them takes as long as a small picture of cheap samples altogether.
    wait_while([] { return true; }, std::chrono::milliseconds(100));
    std::uint32_t number = 0;
    for (const pov::ImageData* image : geometry.images()) send_texels(*image, number++);
}

/// Whatever goes wrong here costs edges, never the picture.
bool GeometryTask::send_geometry(GeometryExport& geometry) {
    // Not (...): POV-Ray cancels a task by an exception of a type of its own.
    try {
        geometry.run(GetSceneData()->objects);
        return true;
    } catch (std::exception&) {
        GeometryChunk end;
        end.left_out[{"the rest", "out of memory or broken", false}] = 1;
        end.unknown.push_back(everything);
        end.last = true;
        wait_for_wire();
        Oracle::instance().wire().send_geometry(end);
        return false;
    }
}

void GeometryTask::send_texels(const pov::ImageData& image, std::uint32_t number) {
    constexpr std::uint32_t chunk_size = 65536;  // half a megabyte
    const std::uint32_t count = size_of(image).width * size_of(image).height;
    for (std::uint32_t first = 0; first < count; first += chunk_size) {
        TexelChunk chunk = texels_of(image, first, std::min(chunk_size, count - first));
        chunk.image = number;
        wait_for_wire();
        Oracle::instance().wire().send_texels(chunk);
    }
}

/// What comes first is a picture: a few samples, as long as they do not take long.
void GeometryTask::wait_for_first_answers() {
    constexpr std::size_t first_answers = 100;
    wait_while([] { return Oracle::instance().queue().traced() < first_answers; },
               std::chrono::milliseconds(10));
}

/// So that few answers wait for more than one chunk. Where samples are cheap the wire is never
/// idle.
void GeometryTask::wait_for_wire() {
    wait_while([] { return Oracle::instance().wire().is_busy(); }, std::chrono::microseconds(400));
}

template <class Condition>
void GeometryTask::wait_while(const Condition& condition, std::chrono::microseconds patience) {
    const auto end = std::chrono::steady_clock::now() + patience;
    while (condition() && std::chrono::steady_clock::now() < end) {
        Cooperate();
        std::this_thread::sleep_for(std::chrono::microseconds(100));
    }
}

void GeometryTask::Finish() {
    GetViewDataPtr()->timeType = pov::SceneThreadData::kRenderTime;
    GetViewDataPtr()->realTime = ConsumedRealTime();
    GetViewDataPtr()->cpuTime = ConsumedCPUTime();
}

}  // namespace povpreview::tracer
