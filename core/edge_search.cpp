// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/edge_search.h"

#include <utility>

#include "core/edge_chains.h"
#include "core/give_way.h"

namespace povpreview {

using Clock = std::chrono::steady_clock;

/// Effort until the first edges are handed over: about a quarter of a second.
constexpr std::uint64_t first_part = 15'000'000;

/// Whether pieces may belong to one chain.
static bool alike(const ImageEdge& a, const ImageEdge& b) {
    return a.kind == b.kind && a.light == b.light;
}

EdgeSearch::EdgeSearch(std::function<std::optional<PolygonScene>()> make_scene,
                       const EdgeFinding& options)
    : make_scene_(std::move(make_scene)), options_(options), thread_([this] { run(); }) {}

EdgeSearch::~EdgeSearch() {
    stop_ = true;
    thread_.join();
}

void EdgeSearch::run() {
    const Clock::time_point begin = Clock::now();
    give_way();
    if (const std::optional<PolygonScene> scene = make_scene_()) search(*scene);
    report_.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    const std::lock_guard lock(mutex_);
    finished_ = true;
    changed_.notify_all();
}

void EdgeSearch::search(const PolygonScene& scene) {
    const glm::ivec2 size{scene.width, scene.height};
    report_.scene = true;
    report_.faces = scene.faces.size();
    std::uint64_t next = first_part;
    report_.all =
        find_edges(scene, options_, [&](std::vector<ImageEdge>&& pieces, std::uint64_t effort) {
            if (!pieces_.empty() && !pieces.empty() && !alike(pieces_.back(), pieces.front()))
                hand_over(size);
            pieces_.insert(pieces_.end(), pieces.begin(), pieces.end());
            if (effort >= next) {
                hand_over(size);
                next = 2 * effort;
            }
            return !stop_.load();
        });
    hand_over(size);
}

void EdgeSearch::hand_over(glm::ivec2 image_size) {
    if (pieces_.empty() || stop_) return;
    report_.pieces += pieces_.size();
    std::vector<EdgeChain> chains = chain_edges(std::exchange(pieces_, {}), image_size);
    report_.chains += chains.size();
    const std::lock_guard lock(mutex_);
    chains_.insert(chains_.end(), std::make_move_iterator(chains.begin()),
                   std::make_move_iterator(chains.end()));
}

std::vector<EdgeChain> EdgeSearch::take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(chains_, {});
}

void EdgeSearch::wait_for(std::chrono::milliseconds patience) {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, patience, [this] { return finished_.load(); });
}

}  // namespace povpreview
