// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <chrono>
#include <memory>

#include "backend/oracle/geometry_export.h"
#include "backend/oracle/oracle_task.h"

namespace povpreview::tracer {

/// Sends what can be drawn of the scene without tracing, beside the tasks that trace.
class GeometryTask : public pov::RenderTask, public BesideTask {
   public:
    GeometryTask(pov::ViewData* view, std::shared_ptr<const SharedScene> shared);

    void Run() override;
    void Stopped() override {}
    void Finish() override;

   private:
    /// Returns false after it has failed, and said so.
    bool send_geometry(GeometryExport& geometry);
    void send_texels(const pov::ImageData& image, std::uint32_t number);
    void wait_for_first_answers();
    void wait_for_wire();
    template <class Condition>
    void wait_while(const Condition& condition, std::chrono::microseconds patience);

    std::shared_ptr<const SharedScene> shared_;
};

}  // namespace povpreview::tracer
