// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/program/slurm.h"

#include <fmt/format.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdio>

#include "adapter/child_process.h"
#include "display/atomic_file.h"
#include "display/program/interrupt.h"

namespace povpreview {
namespace {

namespace fs = std::filesystem;

/// Slurm's MaxArraySize is 1001 unless its configuration says otherwise.
constexpr std::size_t most_elements = 1000;

/// A word as the shell reads it back.
std::string quoted_for_shell(const std::string& word) {
    std::string result = "'";
    for (const char c : word) result += c == '\'' ? "'\\''" : std::string(1, c);
    return result + "'";
}

/// The arguments that ask for the same pictures again, wherever they are rendered.
std::vector<std::string> command_words(const ReferenceOptions& options) {
    std::vector<std::string> words = options.povray;
    const auto add = [&](const char* name, const std::string& value) {
        words.insert(words.end(), {name, value});
    };
    add("--out", options.out.string());
    add("--engine", options.engine == Engine::stock ? "stock" : "tracer");
    add("--format", options.format == FileFormat::exr_half ? "exr"
                    : options.format == FileFormat::png8   ? "png8"
                                                           : "png");
    if (!options.sections.empty()) add("--sections", options.sections.string());
    if (options.timeout) add("--timeout", fmt::format("{}", *options.timeout));
    return words;
}

std::string trimmed(std::string text) {
    while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
    return text;
}

}  // namespace

std::string slurm_batch(const ReferenceOptions& options, const std::vector<ReferenceItem>& items,
                        const fs::path& program, const fs::path& folder) {
    const std::size_t elements = std::min(items.size(), most_elements);
    int threads = 1;
    for (const ReferenceItem& item : items) threads = std::max(threads, item.povray.threads);
    std::string command;
    for (const std::string& word : command_words(options)) command += " " + quoted_for_shell(word);
    return fmt::format(
        "#!/bin/sh\n"
        "# {} pictures. When all elements have ended, the same command without --slurm tells what\n"
        "# came of each, and renders what is missing.\n"
        "#SBATCH --job-name=povpreview\n"
        "#SBATCH --array=0-{}\n"
        "#SBATCH --ntasks=1\n"
        "#SBATCH --cpus-per-task={}\n"
        "#SBATCH --output=\"{}/slurm-%A_%a.log\"\n"
        "cd {} || exit 2\n"
        "exec {} reference{} --jobs 1 --share \"$SLURM_ARRAY_TASK_ID/{}\"\n",
        items.size(), elements - 1, threads, (folder / records_folder(options.out)).string(),
        quoted_for_shell(folder.string()), quoted_for_shell(program.string()), command, elements);
}

Exit submit_to_slurm(const ReferenceOptions& options, const std::vector<ReferenceItem>& items) {
    const fs::path file = options.out / "reference.sbatch";
    write_text(file,
               slurm_batch(options, items, fs::read_symlink("/proc/self/exe"), fs::current_path()));
    const std::string by_hand = "or submit it where Slurm is: sbatch " + file.string();
    const ChildResult result =
        run_child({.program = "sbatch",
                   .arguments = {"--parsable", file.string()},
                   .environment = environment_without({}),
                   .remedy = "install Slurm's client (Debian: slurm-client), " + by_hand},
                  interrupted);
    if (result.stopped) throw Error(Exit::interrupted, "interrupted while submitting", "", "");
    if (!WIFEXITED(result.status) || WEXITSTATUS(result.status) != 0)
        throw Error(Exit::usage, trimmed(result.messages), "sbatch",
                    "the batch file is " + file.string());
    fmt::print("submitted {} as job {}: {} pictures\n", file.string(),
               trimmed({result.output.begin(), result.output.end()}), items.size());
    return Exit::success;
}

}  // namespace povpreview
