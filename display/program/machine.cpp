// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/program/machine.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sched.h>
#include <sys/utsname.h>

#include <chrono>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <memory>
#include <thread>

#include "core/error.h"
#include "display/program/json_text.h"

namespace povpreview {
namespace {

/// What stands behind the first line that begins with `key`, without blanks, signs and quotes.
std::string value_in(const char* file, const std::string& key) {
    std::ifstream stream(file);
    for (std::string line; std::getline(stream, line);) {
        if (!line.starts_with(key)) continue;
        const std::size_t begin = line.find_first_not_of(" \t:=\"", key.size());
        if (begin == std::string::npos) return "";
        return line.substr(begin, line.find_last_not_of(" \t\"") + 1 - begin);
    }
    return "";
}

/// The first line that a command writes; empty if it cannot be run.
std::string first_line_of(const char* command) {
    const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command, "r"), pclose);
    char line[512] = "";
    if (!pipe || !std::fgets(line, sizeof line, pipe.get())) return "";
    std::string text = line;
    while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
    return text;
}

std::size_t usable_cores() {
    cpu_set_t set;
    if (sched_getaffinity(0, sizeof set, &set) != 0) return std::thread::hardware_concurrency();
    return static_cast<std::size_t>(CPU_COUNT(&set));
}

}  // namespace

Machine this_machine(int threads, const std::string& drawing) {
    utsname kernel{};
    uname(&kernel);
    const std::string memory = value_in("/proc/meminfo", "MemTotal");
    std::string model = value_in("/proc/cpuinfo", "model name");
    if (model.empty()) model = kernel.machine;
    const std::time_t now = std::time(nullptr);
    return {
        {"date", fmt::format("{:%Y-%m-%d %H:%M} UTC", fmt::gmtime(now))},
        {"processor", model},
        {"cores", fmt::format("{}{}", usable_cores(),
                              threads > 0 ? ", pinned for all methods" : ", all of the machine")},
        {"memory", memory},
        {"system",
         value_in("/etc/os-release", "PRETTY_NAME") + ", " + kernel.sysname + " " + kernel.release},
        {"povpreview", POVPREVIEW_VERSION},
        {"stock POV-Ray", first_line_of("povray --version 2>&1 | sed -n 's/^Persistence.*Version "
                                        "//p;s/^POV-Ray //p'")},
        {"drawing", drawing},
    };
}

std::string json(const Machine& machine) {
    std::string text = "{";
    for (const auto& [name, value] : machine)
        text += (text.size() > 1 ? ", " : "") + json_string(name) + ": " + json_string(value);
    return text + "}";
}

void keep_to_cores(int count) {
    cpu_set_t allowed, kept;
    CPU_ZERO(&kept);
    if (sched_getaffinity(0, sizeof allowed, &allowed) != 0) CPU_ZERO(&allowed);
    int left = count;
    for (std::size_t core = 0; core < CPU_SETSIZE && left > 0; ++core)
        if (CPU_ISSET(core, &allowed)) {
            CPU_SET(core, &kept);
            --left;
        }
    if (left > 0 || sched_setaffinity(0, sizeof kept, &kept) != 0)
        throw Error(Exit::usage, fmt::format("there are no {} cores to pin to", count), "--threads",
                    fmt::format("give at most {}", usable_cores()));
}

}  // namespace povpreview
