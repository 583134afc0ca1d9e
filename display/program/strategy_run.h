// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "core/methods.h"
#include "core/session.h"
#include "display/program/progress_log.h"
#include "display/program/traced_scene.h"

namespace povpreview {

/// One method at work on a scene.
class StrategyRun {
   public:
    StrategyRun(const std::string& method, TracedScene& scene, SampleOracle& oracle)
        : scene_(scene),
          previewer_(make_previewer(method, scene.description().width, scene.description().height)),
          session_(*previewer_, oracle) {}

    Session& session() { return session_; }
    /// Session::advance, with the edges that have become known since.
    bool advance(std::chrono::nanoseconds patience) {
        if (previewer_->wants_edges()) {
            const std::vector<EdgeChain>& known = scene_.edges();
            if (edges_taken_ < known.size())
                previewer_->accept_edges(
                    {known.begin() + std::ptrdiff_t(edges_taken_), known.end()});
            edges_taken_ = known.size();
        }
        return session_.advance(patience);
    }
    const Previewer& previewer() const { return *previewer_; }
    std::size_t samples() const { return session_.counts().full; }

    Standing standing() const {
        return {.time_s = scene_.time_s(),
                .launch_s = scene_.launch_s(),
                .full = session_.counts().full,
                .probe = session_.counts().probe,
                .albedo = session_.counts().albedo,
                .busy = scene_.oracle().statistics().busy,
                .statistics = previewer_->statistics()};
    }

   private:
    TracedScene& scene_;
    std::unique_ptr<Previewer> previewer_;
    Session session_;
    std::size_t edges_taken_ = 0;  // of the scene's
};

}  // namespace povpreview
