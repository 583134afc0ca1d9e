// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>

#include "core/detail/item_buffer.h"

namespace povpreview {

/// Paints a scene's item buffer in a thread of its own, while the first samples are traced.
class ItemSearch {
   public:
    using Scene = std::shared_ptr<const DrawableScene>;

    /// `make_scene` is called once in that thread; without a scene there are no items.
    explicit ItemSearch(std::function<Scene()> make_scene);
    /// Ends the search wherever it is.
    ~ItemSearch();
    ItemSearch(const ItemSearch&) = delete;
    ItemSearch& operator=(const ItemSearch&) = delete;

    bool finished() const { return finished_; }
    /// Waits for the search to finish, at most so long.
    void wait_for(std::chrono::milliseconds patience);

    /// Null if there was no scene. REQUIRES: finished().
    const ItemBuffer* items() const { return items_.get(); }
    /// That painting took. REQUIRES: finished().
    double seconds() const { return seconds_; }

   private:
    void run();

    const std::function<Scene()> make_scene_;
    std::unique_ptr<ItemBuffer> items_;  // the searching thread's own until finished
    double seconds_ = 0;

    std::atomic<bool> stop_{false}, finished_{false};
    std::mutex mutex_;
    std::condition_variable changed_;
    std::thread thread_;  // last: begins when all else is there
};

}  // namespace povpreview
