// SPDX-License-Identifier: AGPL-3.0-or-later
#include "adapter/stock_povray.h"

#include <sys/wait.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "adapter/child_process.h"
#include "core/error.h"

namespace povpreview {

std::string reason_of_failure(std::string_view messages) {
    std::istringstream stream{std::string(messages)};
    // POV-Ray breaks long lines; the rest begins with the blank where it broke.
    std::vector<std::string> sentences;
    for (std::string line; std::getline(stream, line);) {
        if (line.empty()) continue;
        if (line.front() == ' ' && !sentences.empty())
            sentences.back() += line;
        else
            sentences.push_back(line);
    }
    const auto tells = [](const std::string& sentence) {
        return sentence.find("Error") != std::string::npos;
    };
    const auto last = std::find_if(sentences.rbegin(), sentences.rend(), tells);
    if (last != sentences.rend()) return *last;
    return sentences.empty() ? "" : sentences.back();
}

std::optional<std::vector<unsigned char>> render_by_stock_povray(
    const std::vector<std::string>& arguments, const std::filesystem::path& log,
    const std::function<bool()>& wait, FileWatch* watch) {
    ChildResult result = run_child({.program = "povray",
                                    .arguments = arguments,
                                    .environment = environment_without({}),
                                    .watch = watch,
                                    .remedy = "install Debian's package povray"},
                                   wait);
    if (result.stopped) return std::nullopt;
    if (WIFEXITED(result.status) && WEXITSTATUS(result.status) == 0)
        return std::move(result.output);
    std::ofstream(log) << result.messages;
    const std::string reason =
        WIFEXITED(result.status) ? reason_of_failure(result.messages) : describe_end(result.status);
    throw Error(Exit::scene, reason, "povray", "all its messages are in " + log.string());
}

}  // namespace povpreview
