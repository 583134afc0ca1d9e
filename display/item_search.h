// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "core/detail/item_buffer.h"
#include "display/gl_context.h"

namespace povpreview {

/// Draws a scene's item buffer in a thread of its own, with a GL context of its own: that is opened
/// and made ready while the scene is still being parsed.
class ItemSearch {
   public:
    using Scene = std::shared_ptr<const DrawableScene>;

    explicit ItemSearch(Backend backend);
    /// Waits for what it is doing.
    ~ItemSearch();
    ItemSearch(const ItemSearch&) = delete;
    ItemSearch& operator=(const ItemSearch&) = delete;

    /// `make_scene` is called once in the thread; null: nothing can be drawn.
    void begin(std::function<Scene()> make_scene);
    /// Nothing more will come.
    bool finished() const { return finished_; }
    /// Waits for it to finish, at most so long. REQUIRES: begun.
    void wait_for(std::chrono::milliseconds patience);

    struct Result {
        std::optional<ItemBuffer> items;
        double seconds = 0;  ///< that drawing took
        std::string fault;   ///< why GL could not draw; empty if it could or had nothing to draw
    };
    /// REQUIRES: finished().
    const Result& result() const { return result_; }

   private:
    void run(Backend backend);
    void draw(Backend backend);

    Result result_;  // the drawing thread's own until finished
    std::mutex mutex_;
    std::condition_variable changed_;
    std::function<Scene()> make_scene_;
    bool stop_ = false;
    std::atomic<bool> finished_{false};
    std::thread thread_;  // last: begins when all else is there
};

}  // namespace povpreview
