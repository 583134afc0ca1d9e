// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "core/image_edge.h"
#include "core/polygonal/edge_finding.h"

namespace povpreview {

/// Finds a scene's edges in a thread of its own, while the first samples are traced.
///
/// They come in parts, the most important ones first: what belongs to surfaces, then the shadows
/// light by light, then what mirrors show; chains never join pieces of two kinds anyhow. Where one
/// kind takes more than a moment, it comes in several parts, each taking as much work again as all
/// before it, so that chains that cannot be joined for that stay few, and the same each time.
class EdgeSearch {
   public:
    /// `make_scene` is called once in that thread; without a scene there are no edges.
    EdgeSearch(std::function<std::optional<PolygonScene>()> make_scene, const EdgeFinding& options);
    /// Ends the search wherever it is.
    ~EdgeSearch();
    EdgeSearch(const EdgeSearch&) = delete;
    EdgeSearch& operator=(const EdgeSearch&) = delete;

    /// The chains that have come since the last call, heaviest first.
    std::vector<EdgeChain> take();
    /// Nothing more will come than what `take` gives now.
    bool finished() const { return finished_; }
    /// Waits for the search to finish, at most so long.
    void wait_for(std::chrono::milliseconds patience);

    /// What the search took and found.
    struct Report {
        bool scene = false;  ///< there was one
        bool all = false;    ///< found: there was no more than EdgeFinding::most_effort to do
        std::size_t faces = 0, pieces = 0, chains = 0;
        double seconds = 0;
    };
    /// REQUIRES: finished().
    const Report& report() const { return report_; }

   private:
    void run();
    void search(const PolygonScene& scene);
    void hand_over(glm::ivec2 image_size);

    const std::function<std::optional<PolygonScene>()> make_scene_;
    const EdgeFinding options_;
    std::vector<ImageEdge> pieces_;  // the searching thread's own, as is the report until finished
    Report report_;

    std::atomic<bool> stop_{false}, finished_{false};
    std::mutex mutex_;
    std::condition_variable changed_;
    std::vector<EdgeChain> chains_;
    std::thread thread_;  // last: begins when all else is there
};

}  // namespace povpreview
