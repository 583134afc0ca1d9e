// SPDX-License-Identifier: AGPL-3.0-or-later
#include "adapter/tracer_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <linux/close_range.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <ctime>
#include <string_view>
#include <thread>

#include "adapter/process_memory.h"
#include "core/error.h"

extern char** environ;

namespace povpreview {
namespace {

using std::chrono::milliseconds;
using Clock = std::chrono::steady_clock;

/// How long the tracer may take to leave by itself (it may be in the middle of a slow sample), and
/// how long after SIGTERM. Together they bound the time that quitting takes.
constexpr milliseconds leave_timeout{700}, terminate_timeout{300};
/// Bytes of the tracer's messages that are kept: its last words, not its statistics.
constexpr std::size_t words_kept = 16384;

[[noreturn]] void fail_start(const std::string& program, const char* step, int error) {
    throw Error(Exit::usage,
                fmt::format("cannot start the tracer ({}: {})", step, std::strerror(error)),
                program, "build the tracer, or name another one");
}

struct Ends {
    FileDescriptor ours, theirs;
};

Ends socket_pair(const std::string& program) {
    int fds[2];
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, fds) != 0)
        fail_start(program, "socketpair", errno);
    Ends ends{FileDescriptor(fds[0]), FileDescriptor(fds[1])};
    fcntl(fds[0], F_SETFL, O_NONBLOCK);
    return ends;
}

Ends message_pipe(const std::string& program) {
    int fds[2];
    if (pipe2(fds, O_CLOEXEC) != 0) fail_start(program, "pipe", errno);
    Ends ends{FileDescriptor(fds[0]), FileDescriptor(fds[1])};
    fcntl(fds[0], F_SETFL, O_NONBLOCK);
    return ends;
}

/// Pointers for exec, ending in a null. REQUIRES: `strings` outlives them.
std::vector<char*> pointers(std::vector<std::string>& strings) {
    std::vector<char*> result;
    for (std::string& s : strings) result.push_back(s.data());
    result.push_back(nullptr);
    return result;
}

/// Ours, but for what tells the tracer how to be one.
std::vector<std::string> environment(int wire, const TracerSetting& setting) {
    std::vector<std::string> result;
    for (char** e = environ; *e; ++e) {
        const std::string_view variable = *e;
        if (!variable.starts_with("POVPREVIEW_") && !variable.starts_with("POV_TEMP_DIR="))
            result.emplace_back(variable);
    }
    result.push_back(fmt::format("POVPREVIEW_WIRE={}", wire));
    if (setting.geometry) result.emplace_back("POVPREVIEW_GEOMETRY=1");
    if (!setting.finish_folder.empty()) {
        result.push_back("POVPREVIEW_FINISH=" + setting.finish_folder.string());
        // Images too large for its memory POV-Ray keeps in a file of this folder.
        result.push_back("POV_TEMP_DIR=" + setting.finish_folder.string());
    }
    return result;
}

/// What happens in the child between fork and exec: only calls that are safe there.
[[noreturn]] void become_tracer(pid_t parent, int wire, int messages, int verdict,
                                const Sandbox* sandbox, const char* program, char* const* argv,
                                char* const* envp) {
    setpgid(0, 0);
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) _exit(127);  // the parent died before it could be watched

    struct sigaction standard {};
    standard.sa_handler = SIG_DFL;
    for (const int s : {SIGPIPE, SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGCHLD, SIGTSTP})
        sigaction(s, &standard, nullptr);
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, nullptr);

    const int null = open("/dev/null", O_RDWR);
    if (null >= 0 && dup2(null, STDIN_FILENO) >= 0 && dup2(null, STDOUT_FILENO) >= 0 &&
        dup2(messages, STDERR_FILENO) >= 0) {
        close_range(3, ~0U, CLOSE_RANGE_CLOEXEC);  // also what libraries of ours left open
        if (fcntl(wire, F_SETFD, 0) == 0 && (!sandbox || sandbox->enter()))
            execvpe(program, argv, envp);
    }
    const int error = errno;
    [[maybe_unused]] const ssize_t written = write(verdict, &error, sizeof error);
    _exit(127);
}

std::string describe(int status) {
    if (WIFSIGNALED(status))
        return fmt::format("was killed by signal {} ({})", WTERMSIG(status),
                           strsignal(WTERMSIG(status)));
    return fmt::format("exited with status {}", WEXITSTATUS(status));
}

}  // namespace

void FileDescriptor::reset() {
    if (fd_ >= 0) close(fd_);
    fd_ = -1;
}

TracerProcess::TracerProcess(const std::string& program, const std::vector<std::string>& arguments,
                             const TracerSetting& setting) {
    Ends wire = socket_pair(program), messages = message_pipe(program),
         verdict = message_pipe(program);
    std::vector<std::string> words{program};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<std::string> variables = environment(wire.theirs.get(), setting);
    const std::vector<char*> argv = pointers(words), envp = pointers(variables);

    std::optional<Sandbox> sandbox;
    if (setting.sandbox) sandbox.emplace(*setting.sandbox, program);

    // fork, not posix_spawn: that cannot tie the child's life to ours.
    const pid_t parent = getpid();
    pid_ = fork();
    if (pid_ < 0) fail_start(program, "fork", errno);
    if (pid_ == 0)
        become_tracer(parent, wire.theirs.get(), messages.theirs.get(), verdict.theirs.get(),
                      sandbox ? &*sandbox : nullptr, program.c_str(), argv.data(), envp.data());

    setpgid(pid_, pid_);  // both sides do it: whoever comes first
    wire.theirs.reset();
    messages.theirs.reset();
    verdict.theirs.reset();
    socket_ = std::move(wire.ours);
    messages_ = std::move(messages.ours);

    // Closed by a successful exec, or bringing the cause of a failed one.
    pollfd answer{.fd = verdict.ours.get(), .events = POLLIN, .revents = 0};
    while (poll(&answer, 1, -1) < 0 && errno == EINTR) {
    }
    int error = 0;
    if (read(verdict.ours.get(), &error, sizeof error) == sizeof error) {
        stop();
        fail_start(program, "exec", error);
    }
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
                     {.fd = messages_.get(), .events = POLLIN, .revents = 0}};
    const auto whole = std::chrono::duration_cast<std::chrono::seconds>(patience);
    const timespec timeout{.tv_sec = whole.count(), .tv_nsec = (patience - whole).count()};
    const int ready = ppoll(fds, 2, &timeout, nullptr);
    if (ready < 0) return errno != EINTR;
    if (fds[1].revents) drain_messages();
    return true;
}

void TracerProcess::drain_messages() {
    char buffer[4096];
    while (messages_.open()) {
        const ssize_t n = read(messages_.get(), buffer, sizeof buffer);
        if (n < 0 && errno == EINTR) continue;
        if (n < 0 && errno == EAGAIN) return;
        if (n <= 0) {
            messages_.reset();
            return;
        }
        words_.append(buffer, static_cast<std::size_t>(n));
        if (words_.size() > 2 * words_kept) words_.erase(0, words_.size() - words_kept);
    }
}

bool TracerProcess::reaped(milliseconds patience) {
    const auto deadline = Clock::now() + patience;
    while (true) {
        int status = 0;
        const pid_t pid = waitpid(pid_, &status, WNOHANG);
        if (pid == pid_ || (pid < 0 && errno == ECHILD)) {
            end_ = pid == pid_ ? describe(status) : "ended";
            if (pid == pid_ && WIFEXITED(status)) exit_status_ = WEXITSTATUS(status);
            pid_ = -1;
            return true;
        }
        if (Clock::now() >= deadline) return false;
        drain_messages();  // it may be writing its last words
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
    drain_messages();
    messages_.reset();
    return end_;
}

std::string TracerProcess::last_words() {
    drain_messages();
    constexpr std::size_t lines_shown = 6;
    std::vector<std::string> lines(1);
    for (const char c : words_) {
        if (c == '\n') {
            if (!lines.back().empty()) lines.emplace_back();
        } else if (c == '\r') {
            lines.back().clear();  // a status line, overwritten
        } else {
            lines.back() += c;
        }
    }
    if (lines.back().empty()) lines.pop_back();
    const std::size_t from = lines.size() > lines_shown ? lines.size() - lines_shown : 0;
    std::string result;
    for (std::size_t i = from; i < lines.size(); ++i)
        result += (result.empty() ? "" : "\n") + lines[i];
    return result;
}

}  // namespace povpreview
