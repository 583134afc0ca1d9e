// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/outline_search.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace povpreview {

void OutlineSearch::consider(const Sample& a, const Sample& b) {
    const SurfacePair pair = surface_pair(a.surface, b.surface);
    if (at_work_[pair] || waiting_.size() >= round || tries_[pair] >= most_per_pair) return;
    ++tries_[pair];
    OutlineTracer tracer(a, b, image_size_, options_);
    if (tracer.done()) return;
    const std::uint32_t number = launched_++;
    jobs_.emplace(number, Job{pair, std::move(tracer)});
    waiting_.push_back(number);
    at_work_[pair] = true;
}

std::optional<OutlineSearch::Probe> OutlineSearch::next() {
    for (std::size_t turn = 0; turn < order_.size(); ++turn) {
        const std::uint32_t number = order_.front();
        order_.pop_front();
        order_.push_back(number);
        if (const auto position = jobs_.at(number).tracer.next()) return Probe{number, *position};
    }
    return std::nullopt;
}

void OutlineSearch::accept(std::uint32_t number, const Sample& sample) {
    OutlineTracer& tracer = jobs_.at(number).tracer;
    tracer.accept(sample);
    if (tracer.done()) retire(number);
}

void OutlineSearch::retire(std::uint32_t number) {
    Job& job = jobs_.at(number);
    const Outline& outline = job.tracer.outline();
    double length = 0;
    for (std::size_t i = 1; i < outline.vertices.size(); ++i)
        length += glm::distance(outline.vertices[i - 1], outline.vertices[i]);
    if (length < short_outline ||
        (outline.begin == OutlineEnd::lost && outline.end == OutlineEnd::lost))
        tries_[job.pair] = most_per_pair;
    finished_.push_back(outline);
    at_work_[job.pair] = false;
    jobs_.erase(number);
    order_.erase(std::find(order_.begin(), order_.end(), number));
}

std::optional<Outline> OutlineSearch::take_finished() {
    if (finished_.empty()) return std::nullopt;
    Outline first = std::move(finished_.front());
    finished_.pop_front();
    return first;
}

}  // namespace povpreview
