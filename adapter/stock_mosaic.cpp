// SPDX-License-Identifier: AGPL-3.0-or-later
#include "adapter/stock_mosaic.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <thread>

#include "adapter/file_descriptor.h"
#include "adapter/povray_options.h"
#include "adapter/stock_povray.h"
#include "core/error.h"

namespace povpreview {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

/// Looks at the file so often: well below what a person can tell, well above what a look costs.
constexpr std::chrono::microseconds look_interval{500};

/// Watches the render state file grow, in a thread of its own. The file is opened as soon as it is
/// there, so that it can be read when POV-Ray has removed it.
class Watch {
   public:
    Watch(fs::path file, Clock::time_point launched)
        : file_(std::move(file)), launched_(launched), thread_([this](std::stop_token stop) {
              while (!stop.stop_requested()) {
                  look();
                  std::this_thread::sleep_for(look_interval);
              }
          }) {}

    /// Seconds since the parse; 0 before its end.
    double since_parse() const {
        const double parsed = parsed_s_;
        return parsed > 0 ? seconds() - parsed : 0;
    }

    void finish(StockMosaic& run) {
        thread_.request_stop();
        thread_.join();
        if (descriptor_.open()) look();
        run.ended_s = seconds();
        run.growth = std::move(growth_);
        run.parsed_s = parsed_s_;
        read_all(run.state);
    }

   private:
    double seconds() const {
        return std::chrono::duration<double>(Clock::now() - launched_).count();
    }

    void look() {
        if (!descriptor_.open()) {
            descriptor_ = FileDescriptor(open(file_.c_str(), O_RDONLY | O_CLOEXEC));
            if (!descriptor_.open()) return;
            parsed_s_ = seconds();
        }
        struct stat status {};
        if (fstat(descriptor_.get(), &status) != 0) return;
        const auto bytes = static_cast<std::size_t>(status.st_size);
        if (growth_.empty() || growth_.back().bytes != bytes) growth_.push_back({seconds(), bytes});
    }

    void read_all(std::vector<std::byte>& bytes) const {
        struct stat status {};
        if (!descriptor_.open() || fstat(descriptor_.get(), &status) != 0) return;
        bytes.resize(static_cast<std::size_t>(status.st_size));
        std::size_t have = 0;
        while (have < bytes.size()) {
            const ssize_t n = pread(descriptor_.get(), bytes.data() + have, bytes.size() - have,
                                    static_cast<off_t>(have));
            if (n <= 0) break;
            have += static_cast<std::size_t>(n);
        }
        bytes.resize(have);
    }

    fs::path file_;
    Clock::time_point launched_;
    FileDescriptor descriptor_;
    std::vector<StockMosaic::Growth> growth_;
    std::atomic<double> parsed_s_ = 0;
    std::jthread thread_;
};

}  // namespace

std::size_t StockMosaic::bytes_at(double time_s) const {
    const auto after =
        std::upper_bound(growth.begin(), growth.end(), parsed_s + time_s,
                         [](double launch_s, const Growth& g) { return launch_s < g.launch_s; });
    return after == growth.begin() ? 0 : std::min(state.size(), std::prev(after)->bytes);
}

StockMosaic run_stock_mosaic(const std::vector<std::string>& povray_words, const fs::path& folder,
                             const std::function<bool(double)>& stop) {
    const fs::path picture = folder / "stock-mosaic.tmp.png",
                   state = folder / "stock-mosaic.tmp.pov-state";
    const auto remove_files = [&] {
        std::error_code gone;
        fs::remove(picture, gone);
        fs::remove(state, gone);
    };
    remove_files();
    std::vector<std::string> arguments =
        read_povray_options(povray_words).stock_arguments({.output = picture});
    for (const char* word : {"+SP32", "+EP1"}) arguments.emplace_back(word);

    StockMosaic run;
    Watch watch(state, Clock::now());
    try {
        run.complete = render_by_stock_povray(arguments, folder / "stock-mosaic.log", [&] {
                           return stop(watch.since_parse());
                       }).has_value();
    } catch (...) {
        remove_files();
        throw;
    }
    watch.finish(run);
    remove_files();
    if (run.growth.empty())
        throw Error(Exit::tracer, "POV-Ray wrote no render state file", "stock-mosaic",
                    "leave this method out by --methods");
    return run;
}

}  // namespace povpreview
