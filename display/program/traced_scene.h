// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "adapter/povray_options.h"
#include "adapter/povray_oracle.h"
#include "core/detail/item_search.h"
#include "core/edge_search.h"
#include "core/methods.h"
#include "display/program/tracer_wishes.h"

namespace povpreview {

/// What is to be found out about a scene without tracing; nothing by default.
struct Foreknowledge {
    std::optional<EdgeFinding> edges;
    bool items = false;
};

Foreknowledge foreknowledge_for(const MethodNeeds& needs, int mirror_depth);

/// What a tracer is doing, for people: "parsing, 12,000 tokens".
std::string sentence(const report::Progress& progress);

/// A scene in a tracer of its own, parsed, and the clocks that run since.
class TracedScene {
   public:
    /// Starts a tracer and waits for the end of the parse; `report` is told what it does
    /// ("parsing, 12,000 tokens"), `interrupted` asked whether to give up. Without foreknowledge
    /// the scene's geometry is not asked for. Throws Error.
    TracedScene(const PovrayOptions& povray, const TracerWishes& wishes,
                const std::function<void(const std::string&)>& report,
                const std::function<bool()>& interrupted, const Foreknowledge& foreknowledge);

    PovrayOracle& oracle() { return oracle_; }
    const SceneDescription& description() const { return description_; }
    /// `fixed_accuracy`: without a ladder to climb.
    ImageFrame frame(bool fixed_accuracy, bool by_cost) const;
    /// The rung that was asked for by name; nothing if the name is empty. Throws Error.
    std::optional<Rung> accuracy(const std::string& named) const;
    /// What the tracer prepares the target with ("shooting photons, 12,000"); empty when that is
    /// ready.
    std::string preparation() const;

    /// The edges known by now without tracing, in the order of their coming. They are found beside
    /// everything else, as soon as the geometry has come.
    const std::vector<EdgeChain>& edges();
    /// Who has a use for edges claims them; when all have released them again, no more are found.
    void claim_edges() { ++edge_claims_; }
    void release_edges();
    /// What is seen in each pixel, known without tracing; null if it is not known, or not yet. What
    /// it points to stands; when more is known, it points to that.
    const DrawnDetail* items();
    /// Nothing more will come of items().
    bool items_finished();
    /// Waits until all of both are known, or `interrupted`.
    void wait_for_foreknowledge(const std::function<bool()>& interrupted);
    /// The item buffer as a stage of a method, and what the edge search has to say of its own.
    Stage item_stage() const;
    void complete(Stage& edges) const;
    /// What there is to say about the item buffer when that is known, as a sentence; once.
    std::optional<std::string> take_item_report();
    /// What there is to say about them when all are known, as a sentence; once.
    std::optional<std::string> take_edge_report();

    /// Seconds since the parse ended, and since the tracer was started; pauses not counted.
    double time_s() const { return seconds(now() - parsed_) - paused_s_; }
    double launch_s() const { return seconds(now() - launched_) - paused_s_; }

    /// Runs something outside the clocks, which stand still meanwhile. Not to be nested.
    template <class Work>
    auto off_the_clock(const Work& work) {
        const Pause pause(*this);
        return work();
    }

   private:
    using Clock = std::chrono::steady_clock;
    static double seconds(Clock::duration d) { return std::chrono::duration<double>(d).count(); }
    struct Pause {
        explicit Pause(TracedScene& s) : scene(s) { scene.paused_at_ = Clock::now(); }
        ~Pause() {
            scene.paused_s_ += seconds(Clock::now() - *scene.paused_at_);
            scene.paused_at_.reset();
        }
        TracedScene& scene;
    };
    Clock::time_point now() const { return paused_at_.value_or(Clock::now()); }

    Clock::time_point launched_ = Clock::now(), parsed_;
    double paused_s_ = 0;
    std::optional<Clock::time_point> paused_at_;
    PovrayOracle oracle_;
    const SceneDescription& description_;

    void take_geometry();
    void paint_items();

    bool wants_items_, items_reported_ = false;
    std::optional<ItemSearch> item_search_;
    std::shared_future<ItemSearch::Scene> drawable_;  // valid when the geometry has come
    bool has_images_ = false;
    std::optional<EdgeFinding> edge_finding_;
    std::vector<EdgeChain> edges_;
    std::optional<EdgeSearch> edge_search_;
    int edge_claims_ = 0;
    std::string left_out_;  // objects without polygons, for the report
    bool edges_too_late_ = false, edges_reported_ = false;
};

}  // namespace povpreview
