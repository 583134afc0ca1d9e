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
        if (size > max_waiting - waiting_ - held_positions_) return false;
        if (size == 0) return true;
        if (batch->wants_target() && !target_released_) {
            held_positions_ += size;
            held_.push_back(std::move(batch));
            return true;
        }
        append(std::move(batch));
    }
    filled_.notify_all();
    return true;
}

void WorkQueue::append(std::shared_ptr<const Batch> batch) {
    waiting_ += batch->positions.size();
    batches_.push_back(std::move(batch));
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
    return closed_ && waiting_ + held_positions_ == 0;
}

void WorkQueue::release_target() {
    {
        const std::lock_guard lock(mutex_);
        target_released_ = true;
        for (std::shared_ptr<const Batch>& batch : held_) append(std::move(batch));
        held_.clear();
        held_positions_ = 0;
    }
    filled_.notify_all();
}

bool WorkQueue::target_released() {
    const std::lock_guard lock(mutex_);
    return target_released_;
}

bool WorkQueue::only_target_wanted() {
    const std::lock_guard lock(mutex_);
    return waiting_ == 0 && held_positions_ > 0;
}

Slice WorkQueue::take(std::chrono::nanoseconds patience, bool for_target) {
    std::unique_lock lock(mutex_);
    const auto over = [&] { return target_released_ && !for_target; };
    if (!filled_.wait_for(lock, patience, [&] { return waiting_ > 0 || closed_ || over(); }))
        return {};
    if (waiting_ == 0 || over()) return {};
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
    const double cost = cost_[cost_class(batch)];
    const auto samples_in = [&](std::chrono::nanoseconds time) {
        return std::max<std::size_t>(1, static_cast<std::size_t>(double(time.count()) / cost));
    };
    const std::size_t left = batch.positions.size() - taken_;
    const std::size_t share = (waiting_ + threads_ - 1) / threads_;
    return std::min(
        {samples_in(slice_time), max_slice, left, std::max(share, samples_in(least_slice_time))});
}

/// Rays by kind, and full rays of the lowest rung and of those between it and the target.
std::size_t WorkQueue::cost_class(const Batch& batch) {
    if (batch.kind != RayKind::full || batch.rung == target_rung)
        return static_cast<std::size_t>(batch.kind);
    return batch.rung == 0 ? 3 : 4;
}

void WorkQueue::learn(const Batch& batch, std::size_t count, std::chrono::nanoseconds cost) {
    if (count == 0) return;
    const std::lock_guard lock(mutex_);
    traced_ += count;
    double& mean = cost_[cost_class(batch)];
    const double seen = static_cast<double>(cost.count()) / static_cast<double>(count);
    // A dearer sample is believed at once, a cheaper one by halves: costs vary over the image, and
    // a slice that is too long delays an answer, while one that is too short costs little.
    mean = std::max(50.0, seen > mean ? seen : (mean + seen) / 2);
}

std::size_t WorkQueue::traced() {
    const std::lock_guard lock(mutex_);
    return traced_;
}

}  // namespace povpreview::tracer
