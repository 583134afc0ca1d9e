// SPDX-License-Identifier: AGPL-3.0-or-later
#include "backend/oracle/oracle.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <utility>

#include "backend/oracle/front_end.h"

namespace povpreview::tracer {

Oracle& Oracle::instance() {
    // Never destroyed: its threads run until the process ends.
    static Oracle* const oracle = new Oracle;
    return *oracle;
}

Oracle::Oracle() {
    const char* wire = std::getenv("POVPREVIEW_WIRE");
    if (wire == nullptr) return;
    char* end = nullptr;
    const long socket = std::strtol(wire, &end, 10);
    int type = 0;
    socklen_t size = sizeof type;
    if (end == wire || *end != '\0' || socket < 0 || socket > 1 << 20 ||
        getsockopt(static_cast<int>(socket), SOL_SOCKET, SO_TYPE, &type, &size) != 0 ||
        type != SOCK_STREAM) {
        std::fprintf(stderr, "povpreview tracer: POVPREVIEW_WIRE=%s is no stream socket\n", wire);
        _exit(3);
    }
    socket_ = static_cast<int>(socket);
    fcntl(socket_, F_SETFD, FD_CLOEXEC);  // not for the commands that a scene's options may run
    unsetenv("POVPREVIEW_WIRE");
    geometry_wanted_ = std::getenv("POVPREVIEW_GEOMETRY") != nullptr;
    if (const char* folder = std::getenv("POVPREVIEW_FINISH")) finish_folder_ = folder;
    prctl(PR_SET_PDEATHSIG, SIGKILL);
}

void Oracle::start(const std::string& povray, unsigned threads) {
    if (!enabled() || wire_) return;
    queue_.set_threads(threads);
    wire_ = std::make_unique<WireEnd>(socket_, povray, threads, queue_, known_);
}

void Oracle::begin_first_look(std::int64_t samples) {
    first_samples_left_ = samples;
    first_look_from_ = Clock::now().time_since_epoch().count();
}

bool Oracle::first_look_over() {
    if (!first_look_over_)
        first_look_over_ =
            first_samples_left_ <= 0 || preparation_first() || queue_.only_target_wanted();
    return first_look_over_;
}

bool Oracle::preparation_first() const {
    constexpr Clock::duration grace = std::chrono::milliseconds(900);
    return Clock::now().time_since_epoch() - Clock::duration(first_look_from_) >= grace;
}

void Oracle::progress(Stage stage, std::uint64_t done, std::uint64_t total) {
    if (wire_) wire_->progress(stage, done, total);
}

void Oracle::expect(Stage stage, std::uint64_t total) {
    stage_ = stage;
    total_ = total;
    done_ = 0;
    stage_begun_ = Clock::now();
    progress(stage, 0, total);
}

void Oracle::advance(std::uint64_t done) {
    const std::uint64_t now = done_ += done;
    progress(stage_, now, total_);
    if (stage_ != Stage::radiosity || now < announced_from_) return;
    const Clock::rep taken = (Clock::now() - stage_begun_).count();
    Clock::rep last = announced_at_;
    if (taken >= 2 * last && announced_at_.compare_exchange_strong(last, taken))
        wire_->send_rung_ready(announced_rung_);
}

void Oracle::announce_rung(std::uint8_t rung, std::uint64_t pretraced) {
    announced_rung_ = rung;
    announced_from_ = pretraced;
}

void Oracle::note_read(const std::string& file) {
    if (!enabled()) return;
    const std::lock_guard lock(files_mutex_);
    files_.insert(file);
}

std::vector<std::string> Oracle::files_read() {
    const std::lock_guard lock(files_mutex_);
    return {files_.begin(), files_.end()};
}

void Oracle::note_error(const std::string& text, const std::string& file, long line, bool certain) {
    if (!enabled()) return;
    const std::lock_guard lock(error_mutex_);
    if (!error_.empty()) return;  // what comes later follows from the first
    if (certain) {
        error_ = text;
    } else {
        // Of possible ones the last two: "cannot find file 'sign'" and "cannot find image file".
        earlier_possible_error_ = std::exchange(possible_error_, text);
    }
    if (file.empty()) return;
    error_file_ = file;
    error_line_ = line > 0 ? static_cast<unsigned>(line) : 0;
}

void Oracle::fail(const std::string& text) {
    if (!enabled()) return;
    start("", 0);
    const std::lock_guard lock(error_mutex_);
    const std::string& earlier = earlier_possible_error_;
    const std::string possible =
        earlier.empty() ? possible_error_ : earlier + " " + possible_error_;
    std::string message = error_.empty() ? possible : error_;
    if (message.empty())
        message = text;
    else if (!error_.empty() && !possible.empty())
        message += " (" + possible + ")";
    std::replace(message.begin(), message.end(), '\n', ' ');
    wire_->send_failure(message, error_file_, error_line_);
}

bool serves_previewer() { return enabled(); }

bool may_write() { return std::getenv("POVPREVIEW_WRITE") != nullptr; }

void note_read(const std::string& file) { Oracle::instance().note_read(file); }

std::string image_file(const std::string& wanted) {
    const std::string& folder = Oracle::instance().finish_folder();
    return enabled() && !folder.empty() ? folder + "/image" : wanted;
}

void note_error(const std::string& text) { Oracle::instance().note_error(text, "", 0, false); }

}  // namespace povpreview::tracer
