// SPDX-License-Identifier: AGPL-3.0-or-later
#include "backend/oracle/wire_end.h"

#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>
#include <utility>

#include "backend/oracle/wire_messages.h"

namespace povpreview::tracer {

namespace {

// _exit, not exit: POV-Ray's threads are still running, and destructors would pull the ground from
// under them.
[[noreturn]] void end_quietly() { _exit(0); }

[[noreturn]] void end_refusing(const char* why) {
    std::fprintf(stderr, "povpreview tracer: %s\n", why);
    _exit(3);
}

std::uint32_t little_endian(const std::uint8_t* bytes) {
    return std::uint32_t{bytes[0]} | std::uint32_t{bytes[1]} << 8 | std::uint32_t{bytes[2]} << 16 |
           std::uint32_t{bytes[3]} << 24;
}

}  // namespace

WireEnd::WireEnd(int socket, const std::string& povray, unsigned threads, WorkQueue& queue,
                 KnownPixels& known)
    : socket_(socket), queue_(queue), known_(known) {
    frames_.push_back(hello_frame(version, povray, threads));
    reader_ = std::thread(&WireEnd::read_orders, this);
    writer_ = std::thread(&WireEnd::write_reports, this);
}

void WireEnd::progress(Stage stage, std::uint64_t done, std::uint64_t total) {
    stage_.store(stage, std::memory_order_relaxed);
    done_.store(done, std::memory_order_relaxed);
    total_.store(total, std::memory_order_relaxed);
}

void WireEnd::send_scene(const SceneFacts& scene) {
    stage_ = Stage::ready;
    send(scene_frame(scene));
}

void WireEnd::send_answer(const Slice& slice, std::uint8_t rung,
                          const std::vector<Sample>& samples) {
    send(answer_frame(slice, rung, samples));
}

void WireEnd::send_rung_ready(std::uint8_t rung) { send(rung_ready_frame(rung)); }

void WireEnd::send_geometry(const GeometryChunk& chunk) { send(geometry_frame(chunk)); }

void WireEnd::send_texels(const TexelChunk& chunk) { send(texels_frame(chunk)); }

bool WireEnd::is_busy() {
    const std::lock_guard lock(mutex_);
    return !frames_.empty() || writing_;
}

void WireEnd::send_failure(const std::string& message, const std::string& file, unsigned line) {
    stage_ = Stage::ready;
    send(failure_frame(message, file, line));
    // A previewer that does not read shall not keep the process alive.
    std::unique_lock lock(mutex_);
    drained_.wait_for(lock, std::chrono::seconds(2),
                      [this] { return frames_.empty() && !writing_; });
}

void WireEnd::send(Frame frame) {
    {
        const std::lock_guard lock(mutex_);
        // The way past the writer saves a change of threads, which is most of the delay of a small
        // answer; it is only open when nothing waits, so frames stay in order.
        if (frames_.empty() && !writing_ && try_write(frame)) return;
        frames_.push_back(std::move(frame));
    }
    filled_.notify_one();
}

/// Writes what the socket takes at once; false, with the rest left in `frame`, if that is not all.
bool WireEnd::try_write(Frame& frame) {
    const ssize_t written =
        ::send(socket_, frame.data(), frame.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
    if (written < 0) {
        if (errno == EAGAIN || errno == EINTR) return false;
        end_quietly();
    }
    if (static_cast<std::size_t>(written) == frame.size()) return true;
    frame.erase(frame.begin(), frame.begin() + written);
    return false;
}

void WireEnd::write_reports() {
    std::unique_lock lock(mutex_);
    while (true) {
        if (!filled_.wait_for(lock, heartbeat, [this] { return !frames_.empty(); })) {
            if (stage_ == Stage::ready) continue;
            frames_.push_back(
                progress_frame(static_cast<std::uint8_t>(stage_.load()), done_, total_));
        }
        const Frame frame = std::move(frames_.front());
        frames_.pop_front();
        writing_ = true;
        lock.unlock();
        write_all(frame);
        lock.lock();
        writing_ = false;
        if (frames_.empty()) drained_.notify_all();
    }
}

void WireEnd::write_all(const Frame& frame) {
    for (std::size_t done = 0; done < frame.size();) {
        const ssize_t written =
            ::send(socket_, frame.data() + done, frame.size() - done, MSG_NOSIGNAL);
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) end_quietly();
        done += static_cast<std::size_t>(written);
    }
}

void WireEnd::read_orders() {
    while (true) {
        std::uint8_t head[4];
        read_exactly(head, sizeof head, true);
        const std::uint32_t size = little_endian(head);
        if (size == 0 || size > max_frame) end_refusing("an order of impossible size");
        Frame content(size);
        read_exactly(content.data(), content.size(), false);
        accept_order(content);
    }
}

void WireEnd::read_exactly(void* data, std::size_t size, bool end_allowed) {
    auto* bytes = static_cast<std::uint8_t*>(data);
    for (std::size_t done = 0; done < size;) {
        const ssize_t got = ::recv(socket_, bytes + done, size - done, 0);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) end_quietly();  // the previewer is gone
        if (got == 0 && end_allowed && done == 0) end_quietly();
        if (got == 0) end_refusing("an order broken off");
        done += static_cast<std::size_t>(got);
    }
}

void WireEnd::accept_order(const Frame& content) {
    std::string fault;
    Order order = read_order(content, max_positions, fault);
    if (order.finish) {
        if (!known_.add(*order.finish)) end_refusing("pixels outside of the picture");
        if (order.finish->last) queue_.close();
        return;
    }
    if (!order.batch) end_refusing(fault.c_str());
    if (!queue_.add(std::move(order.batch))) end_refusing("too many samples ordered at once");
}

}  // namespace povpreview::tracer
