// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/edge_search.h"

#include <chrono>
#include <utility>

#include "core/edge_chains.h"

namespace povpreview {

using Clock = std::chrono::steady_clock;

/// Edges known within this time come in one part.
constexpr std::chrono::milliseconds first_part(250);

EdgeSearch::EdgeSearch(PolygonScene scene, const EdgeFinding& options)
    : scene_(std::move(scene)), options_(options), thread_([this] { run(); }) {}

EdgeSearch::~EdgeSearch() {
    stop_ = true;
    thread_.join();
}

void EdgeSearch::run() {
    const Clock::time_point begin = Clock::now();
    Clock::duration next = first_part;
    find_edges(scene_, options_, [&](std::vector<ImageEdge>&& pieces) {
        pieces_.insert(pieces_.end(), pieces.begin(), pieces.end());
        if (Clock::now() - begin >= next) {
            hand_over();
            next = 2 * (Clock::now() - begin);
        }
        return !stop_.load();
    });
    hand_over();
    const std::lock_guard lock(mutex_);
    finished_ = true;
    changed_.notify_all();
}

void EdgeSearch::hand_over() {
    if (pieces_.empty() || stop_) return;
    std::vector<EdgeChain> chains =
        chain_edges(std::exchange(pieces_, {}), {scene_.width, scene_.height});
    const std::lock_guard lock(mutex_);
    chains_.insert(chains_.end(), std::make_move_iterator(chains.begin()),
                   std::make_move_iterator(chains.end()));
}

std::vector<EdgeChain> EdgeSearch::take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(chains_, {});
}

void EdgeSearch::wait() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return finished_.load(); });
}

}  // namespace povpreview
