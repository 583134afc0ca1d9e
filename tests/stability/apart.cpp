// SPDX-License-Identifier: AGPL-3.0-or-later
#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <fstream>
#include <map>
#include <optional>
#include <thread>

#include "core/error.h"
#include "tests/end_to_end/real_tracer.h"
#include "tests/stability/check.h"

namespace povpreview::stability {
namespace {

using Clock = std::chrono::steady_clock;

Outcome from_line(const std::string& text) {
    Outcome outcome;
    int used = 0;
    auto& l1 = outcome.l1;
    if (std::sscanf(text.c_str(), "%lf %lf %lf %lf %lf %zu %lf%n", &l1[0], &l1[1], &l1[2], &l1[3],
                    &outcome.worst, &outcome.contradicted, &outcome.seconds, &used) != 7) {
        outcome.fault = "it ended without an outcome: " + text.substr(0, 200);
        return outcome;
    }
    const std::string rest = text.substr(static_cast<std::size_t>(used) + 1);
    const std::size_t cut = rest.find('|');
    outcome.fault = rest.substr(0, cut);
    outcome.note = rest.substr(cut + 1, rest.find('\n') - cut - 1);
    return outcome;
}

/// A process that checks one case.
struct Child {
    std::size_t index;
    std::filesystem::path output;
    Clock::time_point started = Clock::now();
    bool killed = false;
};

pid_t spawn(const Case& one, bool full, const std::filesystem::path& keep,
            const std::filesystem::path& output) {
    std::vector<std::string> words{"stability", "--one", one.name()};
    if (full) words.emplace_back("--full");
    if (!keep.empty()) words.insert(words.end(), {"--keep", keep});
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, 1, output.c_str(), O_WRONLY | O_CREAT, 0600);
    posix_spawn_file_actions_adddup2(&actions, 1, 2);
    pid_t pid = 0;
    const int error =
        posix_spawn(&pid, "/proc/self/exe", &actions, nullptr, pointers.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (error)
        throw Error(Exit::usage, std::string("cannot start a process: ") + std::strerror(error),
                    "stability", "is there memory left?");
    return pid;
}

Outcome outcome_of(const Child& child, int status, const rusage& usage, const Limits& limits) {
    std::ifstream file(child.output);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    Outcome outcome = from_line(text);
    outcome.peak_kib = usage.ru_maxrss;
    if (child.killed)
        outcome.fault = fmt::format("it was not finished after {} s", limits.limit_s);
    else if (WIFSIGNALED(status))
        outcome.fault =
            fmt::format("it died by signal {}: {}", WTERMSIG(status), text.substr(0, 400));
    else if (outcome.fault.empty() && WEXITSTATUS(status) != 0)
        outcome.fault =
            fmt::format("exit status {}: {}", WEXITSTATUS(status), text.substr(0, 4000));
    else if (outcome.fault.empty() && outcome.peak_kib > limits.limit_kib)
        outcome.fault = fmt::format("it took {} MiB", outcome.peak_kib / 1024);
    return outcome;
}

/// Their tracers die with them.
void kill_late(std::map<pid_t, Child>& running, double limit_s) {
    for (auto& [pid, child] : running) {
        if (child.killed || Clock::now() - child.started < std::chrono::duration<double>(limit_s))
            continue;
        child.killed = true;
        kill(pid, SIGKILL);
    }
}

}  // namespace

std::string to_line(const Outcome& o) {
    return fmt::format("{:.6f} {:.6f} {:.6f} {:.6f} {:.6f} {} {:.3f} {}|{}\n", o.l1[0], o.l1[1],
                       o.l1[2], o.l1[3], o.worst, o.contradicted, o.seconds, o.fault, o.note);
}

void check_apart(const std::vector<Case>& all, bool full, const std::filesystem::path& keep,
                 const Limits& limits,
                 const std::function<void(const Case&, const Outcome&)>& report) {
    const WorkFolder folder;
    std::vector<std::optional<Outcome>> outcomes(all.size());
    std::map<pid_t, Child> running;
    std::size_t next = 0, reported = 0;
    while (reported < all.size()) {
        while (next < all.size() && running.size() < limits.jobs) {
            Child child{next, folder.path() / std::to_string(next)};
            running.emplace(spawn(all[next], full, keep, child.output), child);
            ++next;
        }
        int status = 0;
        rusage usage{};
        const pid_t pid = wait4(-1, &status, WNOHANG, &usage);
        if (const auto child = running.find(pid); child != running.end()) {
            outcomes[child->second.index] = outcome_of(child->second, status, usage, limits);
            running.erase(child);
        } else {
            kill_late(running, limits.limit_s);
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
        for (; reported < all.size() && outcomes[reported]; ++reported)
            report(all[reported], *outcomes[reported]);
    }
}

}  // namespace povpreview::stability
