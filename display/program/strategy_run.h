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
          session_(*previewer_, oracle),
          wants_edges_(previewer_->wants_edges()) {
        if (wants_edges_) scene_.claim_edges();
    }

    Session& session() { return session_; }
    /// Session::advance, with the edges that have become known since.
    bool advance(std::chrono::nanoseconds patience) {
        if (wants_edges_) take_edges();
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
    void take_edges() {
        wants_edges_ = previewer_->wants_edges();
        if (!wants_edges_) return scene_.release_edges();
        const std::vector<EdgeChain>& known = scene_.edges();
        if (edges_taken_ < known.size())
            previewer_->accept_edges({known.begin() + std::ptrdiff_t(edges_taken_), known.end()});
        edges_taken_ = known.size();
    }

    TracedScene& scene_;
    std::unique_ptr<Previewer> previewer_;
    Session session_;
    bool wants_edges_ = false;
    std::size_t edges_taken_ = 0;  // of the scene's
};

}  // namespace povpreview
