// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/fixed_rung.h"
#include "core/methods.h"
#include "core/session.h"
#include "display/program/progress_log.h"
#include "display/program/recorded_previewer.h"
#include "display/program/traced_scene.h"

namespace povpreview {

/// One method at work on a scene.
class StrategyRun {
   public:
    /// `accuracy`: the rung to stay on; if none is given, those methods that can rise from the
    /// lowest to the target, and the others are traced at the target. `recording`: of what happens
    /// to the previewer, or null.
    StrategyRun(const std::string& method, TracedScene& scene, SampleOracle& oracle,
                std::optional<Rung> accuracy, bool by_cost = true, Recording* recording = nullptr)
        : method_(method),
          frame_(scene.frame(accuracy.has_value(), by_cost)),
          scene_(scene),
          fixed_rung_(oracle, accuracy.value_or(target_rung)),
          previewer_(observed(fresh_previewer(), recording)),
          session_(*previewer_, accuracy ? static_cast<SampleOracle&>(fixed_rung_) : oracle),
          wants_edges_(previewer_->wants_edges()),
          wants_items_(previewer_->wants_items()),
          wants_rungs_(!accuracy && scene.description().ladder.rungs.size() > 1),
          has_radiosity_(scene.description().has("radiosity")),
          rungs_taken_(scene.description().ladder.rungs.size()) {
        if (wants_edges_) scene_.claim_edges();
    }

    Session& session() { return session_; }
    /// Session::advance, with what has become known without tracing since.
    bool advance(std::chrono::nanoseconds patience) {
        if (wants_rungs_) take_rungs();
        if (wants_items_) take_items();
        if (wants_edges_ && (!wants_items_ || items_taken_)) take_edges();
        let_target_be_prepared();
        if (session_.advance(patience)) return true;
        if (!session_.paused() && !previewer_->waits()) return false;
        scene_.oracle().listen(patience);
        return true;
    }
    const Previewer& previewer() const { return *previewer_; }
    /// One to which nothing has happened yet.
    std::unique_ptr<Previewer> fresh_previewer() const { return make_previewer(method_, frame_); }
    /// What is done for this scene and what is left out, why, and what it has taken; empty before
    /// the first samples have told what rays cost.
    std::vector<Stage> stages() const {
        std::vector<Stage> all = previewer_->stages();
        if (all.empty()) return all;
        for (Stage& stage : all) {
            if (stage.runs &&
                (stage.name == refinement_stage_name || stage.name == lattice_stage_name))
                stage.own_s = session_.own_s();
            if (stage.name == edge_stage_name) scene_.complete(stage);
        }
        all.insert(all.begin(), scene_.item_stage());
        return all;
    }
    std::size_t samples() const { return session_.counts().full; }

    Standing standing() const {
        return {.time_s = scene_.time_s(),
                .launch_s = scene_.launch_s(),
                .full = session_.counts().full,
                .probe = session_.counts().probe,
                .albedo = session_.counts().albedo,
                .cost_s = cost_s(),
                .busy = scene_.oracle().statistics().busy,
                .statistics = previewer_->statistics()};
    }

   private:
    /// Leaves the tracer to prepare the target, for a moment once there is a first look: radiosity
    /// that takes no longer than that takes several times as long beside samples, which are soon
    /// traced again. Without photons pictures are closer to the finished one, and go on.
    void let_target_be_prepared() {
        if (!has_radiosity_) return;
        using Clock = std::chrono::steady_clock;
        constexpr std::chrono::milliseconds moment{100};
        const std::size_t look = scene_.description().first_look;
        if (samples() >= look && !preparing_until_) preparing_until_ = Clock::now() + moment;
        const bool over = !wants_rungs_ || (preparing_until_ && Clock::now() >= *preparing_until_);
        session_.pause_at(over ? SIZE_MAX : look);
    }

    static std::unique_ptr<Previewer> observed(std::unique_ptr<Previewer> previewer,
                                               Recording* recording) {
        if (!recording) return previewer;
        return std::make_unique<RecordedPreviewer>(std::move(previewer), *recording);
    }
    std::array<double, 3> cost_s() const {
        std::array<double, 3> seconds{};
        for (std::size_t kind = 0; kind < seconds.size(); ++kind)
            seconds[kind] = 1e-9 * double(session_.counts().cost_ns[kind]);
        return seconds;
    }

    void take_rungs() {
        const std::vector<unsigned>& ready = scene_.oracle().rungs_ready();
        if (ready == rungs_taken_) return;
        const std::size_t target = ready.size() - 1;
        for (std::size_t i = 0; i <= target; ++i)
            if (ready[i] != rungs_taken_[i])
                previewer_->accept_ready(i == target ? target_rung : static_cast<Rung>(i));
        rungs_taken_ = ready;
        wants_rungs_ = ready[target] == 0;
    }
    void take_items() {
        const bool all = scene_.items_finished();
        const DrawnDetail* items = scene_.items();
        if (items && items != items_taken_) previewer_->accept_items(*items);
        items_taken_ = items;
        wants_items_ = !all;
    }
    void take_edges() {
        wants_edges_ = previewer_->wants_edges();
        if (!wants_edges_) return scene_.release_edges();
        const std::vector<EdgeChain>& known = scene_.edges();
        if (edges_taken_ < known.size())
            previewer_->accept_edges({known.begin() + std::ptrdiff_t(edges_taken_), known.end()});
        edges_taken_ = known.size();
    }

    const std::string method_;
    const ImageFrame frame_;
    TracedScene& scene_;
    FixedRung fixed_rung_;
    std::unique_ptr<Previewer> previewer_;
    Session session_;
    bool wants_edges_ = false, wants_items_ = false, wants_rungs_ = false;
    const DrawnDetail* items_taken_ = nullptr;
    const bool has_radiosity_;
    std::optional<std::chrono::steady_clock::time_point> preparing_until_;
    std::vector<unsigned> rungs_taken_;  // of those that became ready, told to the previewer
    std::size_t edges_taken_ = 0;        // of the scene's
};

}  // namespace povpreview
