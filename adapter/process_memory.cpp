// SPDX-License-Identifier: AGPL-3.0-or-later
#include "adapter/process_memory.h"

#include <unistd.h>

#include <fstream>
#include <string>

namespace povpreview {

std::size_t peak_resident_memory(pid_t process) {
    std::ifstream status("/proc/" + std::to_string(process) + "/status");
    for (std::string word; status >> word;)
        if (std::size_t kilobytes = 0; word == "VmHWM:" && status >> kilobytes)
            return kilobytes * 1024;
    return 0;
}

std::size_t resident_memory() {
    std::ifstream pages("/proc/self/statm");
    std::size_t all = 0, resident = 0;
    if (!(pages >> all >> resident)) return 0;
    return resident * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

}  // namespace povpreview
