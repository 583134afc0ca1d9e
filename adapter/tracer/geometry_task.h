// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <memory>

#include "backend/oracle/oracle_task.h"

namespace povpreview::tracer {

/// Sends the polygonal part of the scene, beside the tasks that trace.
class GeometryTask : public pov::RenderTask {
   public:
    GeometryTask(pov::ViewData* view, std::shared_ptr<const SharedScene> shared);

    void Run() override;
    void Stopped() override {}
    void Finish() override;

   private:
    void send(const GeometryChunk& chunk);

    std::shared_ptr<const SharedScene> shared_;
};

}  // namespace povpreview::tracer
