// SPDX-License-Identifier: AGPL-3.0-or-later
#include "adapter/child_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <linux/close_range.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <string_view>

#include "adapter/file_watch.h"
#include "adapter/message_tail.h"
#include "adapter/sandbox.h"
#include "core/error.h"

extern char** environ;

namespace povpreview {
namespace {

/// Pointers for exec, ending in a null. REQUIRES: `strings` outlives them.
std::vector<char*> pointers(std::vector<std::string>& strings) {
    std::vector<char*> result;
    for (std::string& s : strings) result.push_back(s.data());
    result.push_back(nullptr);
    return result;
}

/// What the child needs between fork and exec, where memory cannot be asked for.
struct Child {
    pid_t parent;
    int output, messages, kept, watch, verdict;
    const Sandbox* sandbox;
    const char* program;
    char* const* argv;
    char* const* envp;
};

/// What happens in the child between fork and exec: only calls that are safe there.
[[noreturn]] void become(const Child& child) {
    setpgid(0, 0);
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != child.parent) _exit(127);  // the parent died before it could be watched

    struct sigaction standard {};
    standard.sa_handler = SIG_DFL;
    for (const int s : {SIGPIPE, SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGCHLD, SIGTSTP})
        sigaction(s, &standard, nullptr);
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, nullptr);

    const int null = open("/dev/null", O_RDWR);
    const int output = child.output >= 0 ? child.output : null;
    if (null >= 0 && dup2(null, STDIN_FILENO) >= 0 && dup2(output, STDOUT_FILENO) >= 0 &&
        dup2(child.messages, STDERR_FILENO) >= 0) {
        close_range(3, ~0U, CLOSE_RANGE_CLOEXEC);  // also what libraries of ours left open
        if (child.kept < 0 || fcntl(child.kept, F_SETFD, 0) == 0) {
            // From here on every file that is opened waits for the watcher. Before the sandbox,
            // which lets nobody be watched any more.
            if (child.watch >= 0) FileWatch::watch_this_process(child.watch);
            if (!child.sandbox || child.sandbox->enter())
                execvpe(child.program, child.argv, child.envp);
        }
    }
    const int error = errno;
    [[maybe_unused]] const ssize_t written = write(child.verdict, &error, sizeof error);
    _exit(127);
}

}  // namespace

void fail_start(const std::string& program, const char* step, int error,
                const std::string& remedy) {
    throw Error(Exit::usage, fmt::format("cannot start it ({}: {})", step, std::strerror(error)),
                program, remedy);
}

std::vector<std::string> environment_without(const std::vector<std::string>& names) {
    std::vector<std::string> result;
    for (char** e = environ; *e; ++e) {
        const std::string_view variable = *e;
        const bool left_out = std::any_of(names.begin(), names.end(), [&](const std::string& n) {
            return variable.starts_with(n) && variable.substr(n.size()).starts_with('=');
        });
        if (!left_out) result.emplace_back(variable);
    }
    return result;
}

Ends message_pipe(const std::string& program) {
    int fds[2];
    if (pipe2(fds, O_CLOEXEC) != 0)
        fail_start(program, "pipe", errno, "see how many files may be open (ulimit -n)");
    Ends ends{FileDescriptor(fds[0]), FileDescriptor(fds[1])};
    fcntl(fds[0], F_SETFL, O_NONBLOCK);
    return ends;
}

pid_t start_child(ChildPlan plan) {
    Ends verdict = message_pipe(plan.program);
    std::vector<std::string> words{plan.program};
    words.insert(words.end(), plan.arguments.begin(), plan.arguments.end());
    const std::vector<char*> argv = pointers(words), envp = pointers(plan.environment);
    Ends watch = plan.watch ? FileWatch::socket_pair() : Ends{};
    const Child child{getpid(),           plan.output,          plan.messages, plan.kept,
                      watch.theirs.get(), verdict.theirs.get(), plan.sandbox,  plan.program.c_str(),
                      argv.data(),        envp.data()};

    // fork, not posix_spawn: that cannot tie the child's life to ours.
    const pid_t pid = fork();
    if (pid < 0) fail_start(plan.program, "fork", errno, plan.remedy);
    if (pid == 0) become(child);

    setpgid(pid, pid);  // both sides do it: whoever comes first
    verdict.theirs.reset();
    watch.theirs.reset();

    // Closed by a successful exec, or bringing the cause of a failed one.
    pollfd answer{.fd = verdict.ours.get(), .events = POLLIN, .revents = 0};
    while (poll(&answer, 1, -1) < 0 && errno == EINTR) {
    }
    int error = 0;
    if (read(verdict.ours.get(), &error, sizeof error) == sizeof error) {
        while (waitpid(pid, nullptr, 0) < 0 && errno == EINTR) {
        }
        fail_start(plan.program, "exec", error, plan.remedy);
    }
    if (plan.watch) plan.watch->begin(std::move(watch.ours));
    return pid;
}

namespace {

std::vector<unsigned char> contents(int file) {
    std::vector<unsigned char> result(static_cast<std::size_t>(lseek(file, 0, SEEK_END)));
    for (std::size_t at = 0; at < result.size();) {
        const ssize_t n =
            pread(file, result.data() + at, result.size() - at, static_cast<off_t>(at));
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) break;
        at += static_cast<std::size_t>(n);
    }
    return result;
}

}  // namespace

ChildResult run_child(ChildPlan plan, const std::function<bool()>& wait) {
    constexpr int patience_ms = 20;
    const FileDescriptor output(memfd_create("output", MFD_CLOEXEC));
    if (!output.open()) fail_start(plan.program, "memfd_create", errno, plan.remedy);
    Ends messages = message_pipe(plan.program);
    plan.output = output.get();
    plan.messages = messages.theirs.get();
    const pid_t pid = start_child(std::move(plan));
    messages.theirs.reset();
    MessageTail tail(std::move(messages.ours));

    ChildResult result;
    while (waitpid(pid, &result.status, WNOHANG) == 0) {
        if (!result.stopped && wait()) {
            result.stopped = true;
            kill(-pid, SIGKILL);
        }
        pollfd more{.fd = tail.descriptor(), .events = POLLIN, .revents = 0};
        poll(&more, 1, patience_ms);
        tail.drain();
    }
    kill(-pid, SIGKILL);  // whatever it started and left behind
    tail.drain();
    result.messages = tail.text();
    if (!result.stopped) result.output = contents(output.get());
    return result;
}

std::string describe_end(int status) {
    if (WIFSIGNALED(status))
        return fmt::format("was killed by signal {} ({})", WTERMSIG(status),
                           strsignal(WTERMSIG(status)));
    return fmt::format("exited with status {}", WEXITSTATUS(status));
}

}  // namespace povpreview
