// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Any command line: it is understood, or refused in one line as the user's fault.
#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "adapter/povray_options.h"
#include "core/error.h"
#include "display/program/options.h"
#include "tests/fuzz/targets.h"

namespace povpreview::fuzz {

void options(std::span<const std::byte> bytes) {
    // Words are parted by newlines. Without slashes no file of the machine is named.
    std::vector<std::string> words{"povpreview", ""};
    for (const std::byte byte : bytes) {
        const char c = static_cast<char>(byte);
        if (c == '\n')
            words.emplace_back();
        else
            words.back() += c == '/' || c == '\0' ? '_' : c;
    }
    std::vector<const char*> pointers;
    for (const std::string& word : words) pointers.push_back(word.c_str());
    try {
        const CommandLine line =
            read_command_line(static_cast<int>(pointers.size()), pointers.data());
        const int commands = line.preview.has_value() + line.compare.has_value() +
                             line.figures.has_value() + line.plan.has_value() + !line.text.empty();
        promise(commands == 1, "not one command");
        if (!line.preview) return;
        promise(!line.preview->time || *line.preview->time > 0, "a time that is none");
        promise(!line.preview->samples || *line.preview->samples > 0, "no samples");
        promise(line.preview->tracer.stall_timeout_s > 0, "a timeout that is none");
        read_povray_options(line.preview->povray);
    } catch (const Error& error) {
        promise(error.exit() == Exit::usage, "not the user's fault");
        promise(*error.what() != 0, "an error without words");
    }
}

}  // namespace povpreview::fuzz
