// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "backend/oracle/oracle_task.h"

namespace povpreview::tracer {

/// What an oracle does among the tasks of POV-Ray's view:
///
///     append_early:   announce the scene | first look | photons, radiosity pretrace |
///                                        ( early oracle tasks ................... )
///     append_final:                                        the target is ready | final oracle
///     tasks
///                     ( geometry ... )
///
/// Tasks in brackets run beside the others. A scene that needs no preparation has neither first
/// look nor early tasks. Does nothing unless a previewer is there.
class OracleStages {
   public:
    /// `data`: where the thread data of all tasks go, for POV-Ray's statistics.
    OracleStages(pov::TaskQueue& tasks, pov::ViewData& view,
                 std::vector<pov::ViewThreadData*>& data, int threads);

    /// REQUIRES: the view's camera and quality are set.
    void append_early(POVMS_Object& options);
    void append_final();

   private:
    void append(pov::RenderTask* task);
    void append_geometry();

    pov::TaskQueue& tasks_;
    pov::ViewData& view_;
    std::vector<pov::ViewThreadData*>& data_;
    int threads_;
    std::shared_ptr<const SharedScene> shared_;
    bool geometry_appended_ = false;
};

}  // namespace povpreview::tracer
