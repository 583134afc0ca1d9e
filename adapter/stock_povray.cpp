// SPDX-License-Identifier: AGPL-3.0-or-later
#include "adapter/stock_povray.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstring>
#include <fstream>
#include <thread>

#include "core/error.h"

namespace povpreview {
namespace {

/// POV-Ray's sentence about what stopped it, from its messages.
std::string reason(const std::filesystem::path& log) {
    std::ifstream stream(log);
    std::string line, last, found;
    while (std::getline(stream, line)) {
        if (line.find("Error") != std::string::npos) found = line;
        if (!line.empty()) last = line;
    }
    return found.empty() ? last : found;
}

/// Starts povray in a process group of its own, so that Ctrl-C reaches it only through us.
pid_t start(const std::vector<std::string>& arguments, const std::filesystem::path& log) {
    std::vector<char*> argv{const_cast<char*>("povray")};
    for (const std::string& argument : arguments)
        argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);

    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addopen(&files, STDERR_FILENO, log.c_str(),
                                     O_WRONLY | O_CREAT | O_TRUNC, 0666);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
    pid_t pid = -1;
    const int error = posix_spawnp(&pid, "povray", &files, &attributes, argv.data(), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&files);
    if (error != 0)
        throw Error(
            Exit::usage, std::string("cannot start it: ") + std::strerror(error), "povray",
            "install Debian's package povray, and see that " + log.string() + " can be written");
    return pid;
}

}  // namespace

bool render_by_stock_povray(const std::vector<std::string>& arguments,
                            const std::filesystem::path& log, const std::function<bool()>& wait) {
    const pid_t pid = start(arguments, log);
    int status = 0;
    bool stopped = false;
    while (waitpid(pid, &status, WNOHANG) == 0) {
        if (!stopped && wait()) {
            stopped = true;
            kill(-pid, SIGKILL);
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    if (stopped) return false;
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
        throw Error(Exit::scene, reason(log), "povray", "all its messages are in " + log.string());
    return true;
}

}  // namespace povpreview
