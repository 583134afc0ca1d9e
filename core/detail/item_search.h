// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "core/detail/drawable_scene.h"
#include "core/detail/drawn_detail.h"
#include "core/detail/painting_pace.h"

namespace povpreview {

/// Paints a scene's item buffer in a thread of its own, while the first samples are traced. What is
/// known is there to be taken at once: first the surfaces, then what mirrors show, at last the
/// albedo of images, which come later than all else.
class ItemSearch {
   public:
    using Scene = std::shared_ptr<const DrawableScene>;
    using MakeScene = std::function<Scene()>;

    /// `make_scene` is called once in that thread; without a scene there are no items.
    /// `images_follow`: it has no images yet, see add_images().
    ItemSearch(MakeScene make_scene, bool images_follow);
    /// Ends the search wherever it is.
    ~ItemSearch();
    ItemSearch(const ItemSearch&) = delete;
    ItemSearch& operator=(const ItemSearch&) = delete;

    /// The same scene with its images, made in that thread. Called once, if images follow.
    void add_images(MakeScene make_scene);

    bool finished() const { return finished_; }
    /// Waits for the search to finish, at most so long.
    void wait_for(std::chrono::milliseconds patience);

    /// The latest; null as long as there is nothing. Lives as long as the search.
    const DrawnDetail* items() const { return latest_; }
    /// That painting took. REQUIRES: finished().
    double seconds() const { return seconds_; }

   private:
    void run();
    void wait_for_first_looks();
    void paint(const DrawableScene& scene);
    Scene wait_for_images();
    void publish(const DrawnDetail& detail);

    const MakeScene make_scene_;
    const bool images_follow_;
    std::vector<std::unique_ptr<const DrawnDetail>> published_;  // the searching thread's own
    double seconds_ = 0;

    std::atomic<const DrawnDetail*> latest_{nullptr};
    std::atomic<bool> finished_{false};
    PaintingPace pace_;
    std::mutex mutex_;
    std::condition_variable changed_;
    MakeScene make_scene_with_images_;
    std::thread thread_;  // last: begins when all else is there
};

}  // namespace povpreview
