// SPDX-License-Identifier: AGPL-3.0-or-later
#include "backend/oracle/work_queue.h"

#include <algorithm>
#include <utility>

namespace povpreview::tracer {

void WorkQueue::set_threads(std::size_t threads) {
    const std::lock_guard lock(mutex_);
    threads_ = std::max<std::size_t>(1, threads);
}

bool WorkQueue::add(std::shared_ptr<const Batch> batch) {
    {
        const std::lock_guard lock(mutex_);
        const std::size_t size = batch->positions.size();
        if (size > max_waiting - waiting_) return false;
        if (size == 0) return true;
        waiting_ += size;
        batches_.push_back(std::move(batch));
    }
    filled_.notify_all();
    return true;
}

void WorkQueue::close() {
    {
        const std::lock_guard lock(mutex_);
        closed_ = true;
    }
    filled_.notify_all();
}

bool WorkQueue::finished() {
    const std::lock_guard lock(mutex_);
    return closed_ && waiting_ == 0;
}

Slice WorkQueue::take(std::chrono::nanoseconds patience) {
    std::unique_lock lock(mutex_);
    if (!filled_.wait_for(lock, patience, [this] { return waiting_ > 0 || closed_; })) return {};
    if (waiting_ == 0) return {};
    Slice slice;
    slice.batch = batches_.front();
    slice.first = taken_;
    slice.count = slice_size(*slice.batch);
    taken_ += slice.count;
    waiting_ -= slice.count;
    if (taken_ == slice.batch->positions.size()) {
        batches_.pop_front();
        taken_ = 0;
    }
    return slice;
}

std::size_t WorkQueue::slice_size(const Batch& batch) const {
    const auto by_time = static_cast<std::size_t>(static_cast<double>(slice_time.count()) /
                                                  cost_[static_cast<std::size_t>(batch.kind)]);
    const std::size_t left = batch.positions.size() - taken_;
    std::size_t size = std::min({std::max<std::size_t>(1, by_time), max_slice, left});
    if (waiting_ == left)  // the last batch
        size = std::min(size, (left + threads_ - 1) / threads_);
    return size;
}

void WorkQueue::learn(RayKind kind, std::size_t count, std::chrono::nanoseconds cost) {
    if (count == 0) return;
    const std::lock_guard lock(mutex_);
    double& mean = cost_[static_cast<std::size_t>(kind)];
    const double seen = static_cast<double>(cost.count()) / static_cast<double>(count);
    // A dearer sample is believed at once, a cheaper one by halves: costs vary over the image, and
    // a slice that is too long delays an answer, while one that is too short costs little.
    mean = std::max(50.0, seen > mean ? seen : (mean + seen) / 2);
}

}  // namespace povpreview::tracer
