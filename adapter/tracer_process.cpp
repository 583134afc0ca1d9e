// SPDX-License-Identifier: AGPL-3.0-or-later
#include "adapter/tracer_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <ctime>
#include <thread>

#include "adapter/child_process.h"
#include "adapter/process_memory.h"
#include "core/error.h"

namespace povpreview {
namespace {

using std::chrono::milliseconds;
using Clock = std::chrono::steady_clock;

/// How long the tracer may take to leave by itself (it may be in the middle of a slow sample), and
/// how long after SIGTERM. Together they bound the time that quitting takes.
constexpr milliseconds leave_timeout{700}, terminate_timeout{300};
constexpr const char* remedy = "build the tracer, or name another one";

Ends socket_pair(const std::string& program) {
    int fds[2];
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, fds) != 0)
        fail_start(program, "socketpair", errno, remedy);
    Ends ends{FileDescriptor(fds[0]), FileDescriptor(fds[1])};
    fcntl(fds[0], F_SETFL, O_NONBLOCK);
    return ends;
}

/// Ours, but for what tells the tracer how to be one.
std::vector<std::string> environment(int wire, const TracerSetting& setting) {
    std::vector<std::string> result =
        environment_without({"POVPREVIEW_WIRE", "POVPREVIEW_GEOMETRY", "POVPREVIEW_WRITE",
                             "POVPREVIEW_FINISH", "POV_TEMP_DIR"});
    result.push_back(fmt::format("POVPREVIEW_WIRE={}", wire));
    if (setting.geometry) result.emplace_back("POVPREVIEW_GEOMETRY=1");
    if (setting.writes) result.emplace_back("POVPREVIEW_WRITE=1");
    if (!setting.finish_folder.empty()) {
        result.push_back("POVPREVIEW_FINISH=" + setting.finish_folder.string());
        // Images too large for its memory POV-Ray keeps in a file of this folder.
        result.push_back("POV_TEMP_DIR=" + setting.finish_folder.string());
    }
    return result;
}

}  // namespace

TracerProcess::TracerProcess(const std::string& program, const std::vector<std::string>& arguments,
                             const TracerSetting& setting) {
    Ends wire = socket_pair(program), messages = message_pipe(program);
    std::optional<Sandbox> sandbox;
    if (setting.sandbox) sandbox.emplace(*setting.sandbox, program);
    pid_ = start_child({.program = program,
                        .arguments = arguments,
                        .environment = environment(wire.theirs.get(), setting),
                        .messages = messages.theirs.get(),
                        .kept = wire.theirs.get(),
                        .watch = setting.watch,
                        .sandbox = sandbox ? &*sandbox : nullptr,
                        .remedy = remedy});
    socket_ = std::move(wire.ours);
    messages_ = MessageTail(std::move(messages.ours));
}

TracerProcess::~TracerProcess() { stop(); }

std::size_t TracerProcess::peak_memory() const {
    return end_.empty() && pid_ > 0 ? peak_resident_memory(pid_) : 0;
}

std::size_t TracerProcess::send(std::span<const std::byte> bytes) {
    std::size_t sent = 0;
    while (sent < bytes.size() && socket_.open()) {
        const ssize_t n = ::send(socket_.get(), bytes.data() + sent, bytes.size() - sent,
                                 MSG_NOSIGNAL | MSG_DONTWAIT);
        if (n > 0)
            sent += static_cast<std::size_t>(n);
        else if (errno == EAGAIN || errno == EWOULDBLOCK)
            return sent;
        else if (errno != EINTR)
            return bytes.size();  // gone
    }
    return sent;
}

TracerProcess::Receipt TracerProcess::receive(std::span<std::byte> buffer) {
    while (socket_.open()) {
        const ssize_t n = recv(socket_.get(), buffer.data(), buffer.size(), MSG_DONTWAIT);
        if (n > 0) return {Received::bytes, static_cast<std::size_t>(n)};
        if (n < 0 && errno == EINTR) continue;
        if (n < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) return {Received::nothing_yet, 0};
        break;
    }
    return {Received::end, 0};
}

bool TracerProcess::wait(std::chrono::nanoseconds patience, bool to_send) {
    pollfd fds[2] = {{.fd = socket_.get(),
                      .events = static_cast<short>(POLLIN | (to_send ? POLLOUT : 0)),
                      .revents = 0},
                     // A full pipe of messages would stop the tracer.
                     {.fd = messages_.descriptor(), .events = POLLIN, .revents = 0}};
    const auto whole = std::chrono::duration_cast<std::chrono::seconds>(patience);
    const timespec timeout{.tv_sec = whole.count(), .tv_nsec = (patience - whole).count()};
    const int ready = ppoll(fds, 2, &timeout, nullptr);
    if (ready < 0) return errno != EINTR;
    if (fds[1].revents) messages_.drain();
    return true;
}

bool TracerProcess::reaped(milliseconds patience) {
    const auto deadline = Clock::now() + patience;
    while (true) {
        int status = 0;
        const pid_t pid = waitpid(pid_, &status, WNOHANG);
        if (pid == pid_ || (pid < 0 && errno == ECHILD)) {
            end_ = pid == pid_ ? describe_end(status) : "ended";
            if (pid == pid_ && WIFEXITED(status)) exit_status_ = WEXITSTATUS(status);
            pid_ = -1;
            return true;
        }
        if (Clock::now() >= deadline) return false;
        messages_.drain();  // it may be writing its last words
        std::this_thread::sleep_for(std::chrono::microseconds(500));
    }
}

const std::string& TracerProcess::stop() {
    socket_.reset();
    if (pid_ < 0) return end_;
    const pid_t group = pid_;
    if (!reaped(leave_timeout)) {
        kill(pid_, SIGTERM);
        if (!reaped(terminate_timeout)) {
            kill(pid_, SIGKILL);
            while (!reaped(milliseconds(1000))) {
            }
        }
        end_ = "did not leave and had to be ended";
        exit_status_ = -1;
    }
    kill(-group, SIGKILL);  // whatever it started itself
    messages_.drain();
    messages_.close();
    return end_;
}

std::string TracerProcess::last_words() {
    messages_.drain();
    constexpr std::size_t lines_shown = 6;
    return messages_.last_lines(lines_shown);
}

}  // namespace povpreview
