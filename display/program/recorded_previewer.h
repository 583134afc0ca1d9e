// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <utility>
#include <variant>
#include <vector>

#include "core/previewer.h"

namespace povpreview {

/// All that happens to a previewer, in order. As previewers are pure state machines, a fresh one to
/// which the same happens makes the same pictures. So a run is measured without being held up, and
/// its pictures are made when it is over: made meanwhile, even off the clock, each would give the
/// tracer and those who paint items time that the method never had.
class Recording {
   public:
    /// What happens seldom.
    using Event = std::variant<const DrawnDetail*, std::vector<EdgeChain>, Rung>;

    Recording() { steps_.reserve(1 << 20); }

    /// A request was asked for.
    void add_asked() {
        if (steps_.empty()) steps_.push_back({});
        ++steps_.back().asked;
    }
    void add(const Sample& sample) {
        if (samples_.empty() || samples_.back().size() == chunk)
            samples_.emplace_back().reserve(chunk);
        samples_.back().push_back(sample);
        steps_.push_back({Step::Kind::sample});
    }
    void add(Event event) {
        events_.push_back(std::move(event));
        steps_.push_back({Step::Kind::event});
    }
    /// A moment at which replay() stops.
    void mark() {
        marks_.push_back(steps_.size());
        steps_.push_back({});  // what is asked from now on comes after
    }
    /// Bytes that it takes, about.
    std::size_t memory() const {
        std::size_t bytes = steps_.size() * sizeof(Step);
        for (const std::vector<Sample>& some : samples_) bytes += some.size() * sizeof(Sample);
        return bytes;
    }

    /// Lets the same happen to a fresh previewer, and calls visit(i) at the i-th mark, from 0.
    template <class Visit>
    void replay(Previewer& previewer, const Visit& visit) const {
        std::size_t step = 0, sample = 0, event = 0;
        for (std::size_t i = 0; i < marks_.size(); ++i) {
            for (; step < marks_[i]; ++step) {
                if (steps_[step].kind == Step::Kind::sample) previewer.accept(sample_at(sample++));
                if (steps_[step].kind == Step::Kind::event) happen(previewer, events_[event++]);
                for (std::uint32_t n = 0; n < steps_[step].asked; ++n) previewer.next();
            }
            visit(i);
        }
    }

   private:
    /// What happened, and how many requests were asked for after it.
    struct Step {
        enum class Kind : std::uint8_t { nothing, sample, event };
        Kind kind = Kind::nothing;
        std::uint32_t asked = 0;
    };

    const Sample& sample_at(std::size_t n) const { return samples_[n / chunk][n % chunk]; }

    static void happen(Previewer& previewer, const Event& event) {
        struct Happen {
            Previewer& previewer;
            void operator()(const DrawnDetail* items) const { previewer.accept_items(*items); }
            void operator()(std::vector<EdgeChain> chains) const {
                previewer.accept_edges(std::move(chains));
            }
            void operator()(Rung rung) const { previewer.accept_ready(rung); }
        };
        std::visit(Happen{previewer}, event);
    }

    // To record a sample takes next to no time of the run: memory is set aside in large pieces, and
    // none is moved.
    static constexpr std::size_t chunk = 1 << 16;
    std::vector<Step> steps_;
    std::deque<std::vector<Sample>> samples_;  // chunks
    std::vector<Event> events_;
    std::vector<std::size_t> marks_;
};

/// A previewer, with a record of what happens to it. Items that it is given must outlive the
/// record.
class RecordedPreviewer : public Previewer {
   public:
    RecordedPreviewer(std::unique_ptr<Previewer> previewer, Recording& recording)
        : previewer_(std::move(previewer)), recording_(recording) {}

    std::string_view name() const override { return previewer_->name(); }
    Parts parts() const override { return previewer_->parts(); }
    std::optional<Request> next() override {
        recording_.add_asked();
        return previewer_->next();
    }
    void accept(const Sample& sample) override {
        recording_.add(sample);
        previewer_->accept(sample);
    }
    bool wants_edges() const override { return previewer_->wants_edges(); }
    void accept_edges(std::vector<EdgeChain>&& chains) override {
        recording_.add(chains);
        previewer_->accept_edges(std::move(chains));
    }
    bool wants_items() const override { return previewer_->wants_items(); }
    void accept_items(const DrawnDetail& items) override {
        recording_.add(&items);
        previewer_->accept_items(items);
    }
    void accept_ready(Rung rung) override {
        recording_.add(rung);
        previewer_->accept_ready(rung);
    }
    bool waits() const override { return previewer_->waits(); }
    bool done() const override { return previewer_->done(); }
    Picture picture(Overlay overlay) const override { return previewer_->picture(overlay); }
    Statistics statistics() const override { return previewer_->statistics(); }
    std::vector<Stage> stages() const override { return previewer_->stages(); }

   private:
    std::unique_ptr<Previewer> previewer_;
    Recording& recording_;
};

}  // namespace povpreview
