// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/detail/item_search.h"

#include "core/detail/item_painter.h"

namespace povpreview {

ItemSearch::ItemSearch(std::function<Scene()> make_scene)
    : make_scene_(std::move(make_scene)), thread_([this] { run(); }) {}

ItemSearch::~ItemSearch() {
    stop_ = true;
    thread_.join();
}

void ItemSearch::wait_for(std::chrono::milliseconds patience) {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, patience, [this] { return finished(); });
}

void ItemSearch::run() {
    using Clock = std::chrono::steady_clock;
    if (const Scene scene = make_scene_(); scene && !stop_) {
        const auto begun = Clock::now();
        items_ = std::make_unique<ItemBuffer>(paint_items(*scene, stop_));
        seconds_ = std::chrono::duration<double>(Clock::now() - begun).count();
    }
    {
        const std::lock_guard lock(mutex_);
        finished_ = true;
    }
    changed_.notify_all();
}

}  // namespace povpreview
