// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/detail/item_search.h"

#include "core/detail/item_painter.h"
#include "core/give_way.h"

namespace povpreview {

ItemSearch::ItemSearch(MakeScene make_scene, bool images_follow)
    : make_scene_(std::move(make_scene)),
      images_follow_(images_follow),
      thread_([this] { run(); }) {}

ItemSearch::~ItemSearch() {
    {
        const std::lock_guard lock(mutex_);
        pace_.stop();
    }
    changed_.notify_all();
    thread_.join();
}

void ItemSearch::add_images(MakeScene make_scene) {
    {
        const std::lock_guard lock(mutex_);
        make_scene_with_images_ = std::move(make_scene);
    }
    changed_.notify_all();
}

void ItemSearch::wait_for(std::chrono::milliseconds patience) {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, patience, [this] { return finished(); });
}

void ItemSearch::run() {
    wait_for_first_looks();
    // Painting takes as long as many samples do, and edges and textures are worth a part of what
    // those are: at 1920x1080 it delays an error of .02 by a fifth if it gets an equal share of
    // two processors (seven of dear_scenes.txt), and by another tenth if it does not keep to its
    // PaintingPace. Where there are more, it gets those left over.
    give_way();
    if (const Scene scene = make_scene_(); scene && !pace_.stopped()) paint(*scene);
    {
        const std::lock_guard lock(mutex_);
        finished_ = true;
    }
    changed_.notify_all();
}

/// Begun at once, painting would take half of the first samples of two processors. A little later
/// it lets pictures come to an error of .05 in .83 (640x480) to .91 times the time (1920x1080), and
/// to smaller ones no later (20 of textured_scenes.txt and dear_scenes.txt).
void ItemSearch::wait_for_first_looks() {
    constexpr std::chrono::milliseconds first_looks{15};
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, first_looks, [this] { return pace_.stopped(); });
}

void ItemSearch::paint(const DrawableScene& scene) {
    using Clock = std::chrono::steady_clock;
    auto begun = Clock::now();
    const auto worked = [&] {
        seconds_ += std::chrono::duration<double>(Clock::now() - begun).count();
    };
    ItemPainting painting(scene, pace_);
    ItemBuffer items = painting.read(scene);
    DrawnDetail detail(items);
    publish(detail);
    painting.paint_mirrors(scene, items);
    if (!items.mirrors.empty()) {
        detail.accept(items);
        publish(detail);
    }
    worked();
    if (!images_follow_) return;
    const Scene with_images = wait_for_images();
    if (!with_images) return;
    begun = Clock::now();
    ItemBuffer all = painting.read(*with_images);
    all.mirrors = std::move(items.mirrors);
    all.mirrored = std::move(items.mirrored);
    painting.read_mirrored_looks(*with_images, all);
    detail.accept(all);
    publish(detail);
    worked();
}

ItemSearch::Scene ItemSearch::wait_for_images() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return pace_.stopped() || make_scene_with_images_; });
    if (pace_.stopped()) return nullptr;
    const MakeScene make_scene = make_scene_with_images_;
    lock.unlock();
    return make_scene();
}

void ItemSearch::publish(const DrawnDetail& detail) {
    if (pace_.stopped()) return;
    published_.push_back(std::make_unique<const DrawnDetail>(detail));
    latest_ = published_.back().get();
}

}  // namespace povpreview
