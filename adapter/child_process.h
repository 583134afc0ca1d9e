// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <functional>
#include <string>
#include <vector>

#include "adapter/file_descriptor.h"

namespace povpreview {

class FileWatch;
class Sandbox;

/// How a child is to be started.
struct ChildPlan {
    std::string program;  ///< looked up in PATH if it has no slash
    std::vector<std::string> arguments;
    std::vector<std::string> environment;  ///< NAME=value
    int output = -1;                       ///< its standard output; -1: thrown away
    int messages = -1;                     ///< its standard error
    int kept = -1;                         ///< one more descriptor that it keeps, or -1
    FileWatch* watch = nullptr;            ///< who is told what files it opens, or nobody
    const Sandbox* sandbox = nullptr;      ///< what it may touch; null: all that we may
    std::string remedy;                    ///< what to do when it cannot be started
};

/// Starts a child with no input, no other open descriptor, signals as they are by default, a
/// process group of its own (so that Ctrl-C reaches it only through us), and the order to die with
/// the thread that started it (Linux ties that to the thread, not the process: start it on one that
/// lives as long as the child is to live). Throws Error(Exit::usage) if that fails.
pid_t start_child(ChildPlan plan);

/// How a child went that was waited for.
struct ChildResult {
    bool stopped = false;  ///< by `wait`; the rest is then of no interest
    int status = 0;        ///< waitpid's
    std::vector<unsigned char> output;
    std::string messages;  ///< the end of them
};
/// Starts a child, collects its output (in memory, seekable) and messages, and waits for its end.
/// Calls `wait` some times a second; when that returns true the child is ended, with all that it
/// started. `output` and `messages` of the plan are not used. Throws Error as start_child().
ChildResult run_child(ChildPlan plan, const std::function<bool()>& wait);

/// This process's own environment, less the variables of these names.
std::vector<std::string> environment_without(const std::vector<std::string>& names);

/// A pipe for a child's messages; our end never waits. `program` is named in errors.
Ends message_pipe(const std::string& program);

/// waitpid's status as the rest of a sentence: "exited with status 1".
std::string describe_end(int status);

[[noreturn]] void fail_start(const std::string& program, const char* step, int error,
                             const std::string& remedy);

}  // namespace povpreview
