// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/program/reference_batch.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "display/program/folder.h"
#include "display/program/interrupt.h"
#include "display/program/reference.h"
#include "display/program/reference_list.h"
#include "display/program/slurm.h"
#include "display/progress_line.h"

namespace povpreview {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point then) {
    return std::chrono::duration<double>(Clock::now() - then).count();
}

/// What came of an item.
struct Outcome {
    std::size_t item = 0;
    ReferenceMade made;
    std::string failure;
};

/// Rows of the table as they come, and the count of all.
class Report {
   public:
    explicit Report(const std::vector<ReferenceItem>& items) : items_(items) {}

    void add(const Outcome& outcome, const std::string& file) {
        ++done_;
        if (!outcome.failure.empty()) failures_.push_back(outcome);
        const ReferenceMade& made = outcome.made;
        const char* what = !outcome.failure.empty() ? "FAILED" : made.reused ? "kept" : "rendered";
        const std::string& remark = outcome.failure.empty() ? made.remark : outcome.failure;
        const bool timed = outcome.failure.empty() && !made.reused;
        line_.clear();
        fmt::print("{:>8} {:>10}  {}{}{}\n", what,
                   timed ? fmt::format("{:.1f} s", made.seconds) : "", file,
                   remark.empty() ? "" : ": ", remark);
        std::fflush(stdout);
        kept_ += made.reused;
        rendered_ += timed;
    }

    void show_progress(std::size_t running) {
        const std::size_t left = items_.size() - done_;
        std::string text = fmt::format("{} of {} done, {} failed, {} at work", done_, items_.size(),
                                       failures_.size(), running);
        // Kept ones took no time; those to come may have to be rendered.
        const std::size_t worked = done_ - kept_;
        if (worked > 0 && running > 0) {
            const double each = seconds_since(started_) / double(worked);
            text += fmt::format(", about {:%H:%M:%S} left",
                                std::chrono::seconds(std::lround(each * double(left))));
        }
        line_.show(text);
    }

    void summary() {
        line_.clear();
        fmt::print("{} pictures: {} rendered in {:.1f} s, {} kept, {} failed", items_.size(),
                   rendered_, seconds_since(started_), kept_, failures_.size());
        if (done_ < items_.size()) fmt::print(", {} not done", items_.size() - done_);
        fmt::print("\n");
        std::sort(failures_.begin(), failures_.end(),
                  [](const Outcome& a, const Outcome& b) { return a.item < b.item; });
        if (!failures_.empty()) fmt::print("failed:\n");
        for (const Outcome& outcome : failures_)
            fmt::print("  {}: {}\n", items_[outcome.item].name, outcome.failure);
        std::fflush(stdout);
    }
    bool some_failed() const { return !failures_.empty(); }

   private:
    const std::vector<ReferenceItem>& items_;
    std::vector<Outcome> failures_;
    std::size_t done_ = 0, kept_ = 0, rendered_ = 0;
    Clock::time_point started_ = Clock::now();
    ProgressLine line_;
};

class Batch {
   public:
    Batch(const ReferenceOptions& options, std::vector<ReferenceItem> items)
        : options_(options), items_(std::move(items)), report_(items_) {}

    Exit run() {
        {
            std::vector<std::jthread> workers;
            for (int i = jobs(); i > 0; --i) workers.emplace_back([this] { work(); });
            gather();
        }
        report_.summary();
        if (trouble_) std::rethrow_exception(trouble_);
        if (interrupted()) return Exit::interrupted;
        return report_.some_failed() ? Exit::scene : Exit::success;
    }

   private:
    /// Renders at a time: as many as the cores hold, and no more than there are pictures.
    int jobs() const {
        int threads = 1;
        for (const ReferenceItem& item : items_) threads = std::max(threads, item.povray.threads);
        const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
        const int wanted = options_.jobs.value_or(std::max(1, cores / threads));
        return std::min<int>(wanted, static_cast<int>(items_.size()));
    }

    std::string file_of(const ReferenceItem& item) const {
        return item.name + (options_.format == FileFormat::exr_half ? ".exr" : ".png");
    }
    bool stopped() const { return interrupted() || trouble_seen_; }

    /// A worker: takes items as long as there are any. POV-Ray's processes belong to its thread,
    /// and end with it.
    void work() {
        while (!stopped()) {
            const std::size_t i = next_++;
            if (i >= items_.size()) return;
            ++running_;
            Outcome outcome;
            outcome.item = i;
            outcome.failure = items_[i].problem;
            const bool finished = !outcome.failure.empty() || make(items_[i], outcome);
            --running_;
            if (!finished) return;
            const std::lock_guard lock(mutex_);
            finished_.push_back(std::move(outcome));
        }
    }

    /// False if all is to end.
    bool make(const ReferenceItem& item, Outcome& outcome) {
        try {
            const fs::path record = records_folder(options_.out) / (item.name + ".record");
            const ReferenceJob job{.povray = item.povray,
                                   .frame = item.frame,
                                   .engine = options_.engine,
                                   .format = options_.format,
                                   .antialias = item.povray.antialias,
                                   .picture = options_.out / file_of(item),
                                   .record = record,
                                   .timeout_s = options_.timeout};
            make_folder(job.picture.parent_path(), "--out");
            make_folder(record.parent_path(), "--out");
            outcome.made = make_reference(job, hashes_, [this] { return stopped(); });
        } catch (const Error& error) {
            if (error.exit() == Exit::interrupted) return false;
            if (error.exit() == Exit::usage) return note_trouble();
            outcome.failure = error.what();
        } catch (...) {
            return note_trouble();
        }
        return true;
    }

    bool note_trouble() {
        const std::lock_guard lock(mutex_);
        if (!trouble_) trouble_ = std::current_exception();
        trouble_seen_ = true;
        return false;
    }

    /// Reports what the workers have finished, until no more can come.
    void gather() {
        using namespace std::chrono_literals;
        std::size_t reported = 0;
        for (bool last = false; !last;) {
            last = stopped() && running_ == 0;  // before looking: then nothing is overlooked
            std::vector<Outcome> finished;
            {
                const std::lock_guard lock(mutex_);
                finished.swap(finished_);
            }
            for (const Outcome& outcome : finished)
                report_.add(outcome, file_of(items_[outcome.item]));
            reported += finished.size();
            if (reported == items_.size()) return;
            report_.show_progress(running_);
            std::this_thread::sleep_for(20ms);
        }
    }

    const ReferenceOptions& options_;
    const std::vector<ReferenceItem> items_;
    ContentHashes hashes_;
    Report report_;
    std::atomic<std::size_t> next_ = 0, running_ = 0;
    std::atomic<bool> trouble_seen_ = false;
    std::mutex mutex_;  // guards what follows
    std::vector<Outcome> finished_;
    std::exception_ptr trouble_;
};

/// Every count-th item, beginning with the share's own.
std::vector<ReferenceItem> part(const std::vector<ReferenceItem>& items, const Share& share) {
    std::vector<ReferenceItem> result;
    for (std::size_t i = share.index; i < items.size(); i += share.count)
        result.push_back(items[i]);
    return result;
}

}  // namespace

Exit reference(const ReferenceOptions& options) {
    std::vector<ReferenceItem> items = reference_items(options.povray, options.sections);
    make_folder(records_folder(options.out), "--out");
    if (options.slurm) return submit_to_slurm(options, items);
    return Batch(options, part(items, options.share)).run();
}

}  // namespace povpreview
