// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/item_search.h"

#include <chrono>

#include "core/error.h"
#include "display/item_painter.h"

namespace povpreview {

ItemSearch::ItemSearch(Backend backend) : thread_([this, backend] { run(backend); }) {}

ItemSearch::~ItemSearch() {
    {
        const std::lock_guard lock(mutex_);
        stop_ = true;
    }
    changed_.notify_all();
    thread_.join();
}

void ItemSearch::begin(std::function<Scene()> make_scene) {
    {
        const std::lock_guard lock(mutex_);
        make_scene_ = std::move(make_scene);
    }
    changed_.notify_all();
}

void ItemSearch::wait_for(std::chrono::milliseconds patience) {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, patience, [this] { return finished(); });
}

void ItemSearch::run(Backend backend) {
    try {
        draw(backend);
    } catch (const Error& error) {
        result_.fault = error.what();
    }
    {
        const std::lock_guard lock(mutex_);
        finished_ = true;
    }
    changed_.notify_all();
}

void ItemSearch::draw(Backend backend) {
    const std::unique_ptr<GlContext> context = open_offscreen(backend);
    ItemPainter painter(*context);
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return stop_ || make_scene_; });
    if (stop_) return;
    const std::function<Scene()> make_scene = std::move(make_scene_);
    lock.unlock();
    const Scene scene = make_scene();
    if (!scene) return;
    const auto begun = std::chrono::steady_clock::now();
    result_.items = painter.paint(*scene);
    result_.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
}

}  // namespace povpreview
