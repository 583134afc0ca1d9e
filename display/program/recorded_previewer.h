// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

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
    struct Asked {  ///< for so many requests
        std::size_t times;
    };
    using Event = std::variant<Asked, Sample, const DrawnDetail*, std::vector<EdgeChain>, Rung>;

    void add(Event event) { events_.push_back(std::move(event)); }
    void add_asked() {
        if (events_.empty() || !std::holds_alternative<Asked>(events_.back())) add(Asked{0});
        ++std::get<Asked>(events_.back()).times;
    }
    /// A moment at which replay() stops.
    void mark() {
        marks_.push_back(events_.size());
        add(Asked{0});  // what is asked from now on comes after
    }
    /// Bytes that it takes, about.
    std::size_t memory() const { return events_.size() * sizeof(Event); }

    /// Lets the same happen to a fresh previewer, and calls visit(i) at the i-th mark, from 0.
    template <class Visit>
    void replay(Previewer& previewer, const Visit& visit) const {
        std::size_t next = 0;
        for (std::size_t i = 0; i < marks_.size(); ++i) {
            for (; next < marks_[i]; ++next) happen(previewer, events_[next]);
            visit(i);
        }
    }

   private:
    static void happen(Previewer& previewer, const Event& event) {
        struct Happen {
            Previewer& previewer;
            void operator()(Asked asked) const {
                while (asked.times-- > 0) previewer.next();
            }
            void operator()(const Sample& sample) const { previewer.accept(sample); }
            void operator()(const DrawnDetail* items) const { previewer.accept_items(*items); }
            void operator()(std::vector<EdgeChain> chains) const {
                previewer.accept_edges(std::move(chains));
            }
            void operator()(Rung rung) const { previewer.accept_ready(rung); }
        };
        std::visit(Happen{previewer}, event);
    }

    std::deque<Event> events_;
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
