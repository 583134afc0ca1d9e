// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "adapter/file_descriptor.h"
#include "adapter/message_tail.h"
#include "adapter/sandbox.h"

namespace povpreview {

class FileWatch;

/// What a tracer is told by its environment, and what it may touch.
struct TracerSetting {
    bool geometry = false;                ///< the scene's polygons are wanted
    bool writes = false;                  ///< the scene may write files
    std::filesystem::path finish_folder;  ///< where POV-Ray's image is to be made; empty: none
    std::optional<SandboxRules> sandbox;  ///< else it may do what we may
    FileWatch* watch = nullptr;           ///< is told what files it opens, or nobody
};

/// A tracer running as a child, with one end of a private stream socket to it.
///
/// The child gets POVPREVIEW_WIRE=<fd> in its environment, POVPREVIEW_GEOMETRY=1 and
/// POVPREVIEW_FINISH=<folder> where they are wanted, no output but a pipe for its messages, and
/// what start_child() gives every child.
class TracerProcess {
   public:
    /// Starts `program`, looked up in PATH if it has no slash. Throws Error if that fails.
    TracerProcess(const std::string& program, const std::vector<std::string>& arguments,
                  const TracerSetting& setting = {});
    /// Ends and reaps the child; see stop().
    ~TracerProcess();
    TracerProcess(const TracerProcess&) = delete;
    TracerProcess& operator=(const TracerProcess&) = delete;

    /// Sends what the socket takes now; returns the number of bytes. To a child that has gone,
    /// everything is sent and lost: receive() tells.
    std::size_t send(std::span<const std::byte> bytes);

    enum class Received { bytes, nothing_yet, end };
    struct Receipt {
        Received what;
        std::size_t size;  ///< bytes that have come
    };
    /// Receives what has come, never waits. `end`: the child closed its end or is dead.
    Receipt receive(std::span<std::byte> buffer);

    /// Waits until there is something to receive, or room to send if asked for, or `patience` is
    /// over. Returns false if a signal of this process ended the wait.
    bool wait(std::chrono::nanoseconds patience, bool to_send);

    /// Ends the child: by closing the wire, then asking (SIGTERM), then by force (SIGKILL), each
    /// after a short while. Returns how it ended, as in "the tracer ...". May be called again.
    const std::string& stop();
    /// The most memory that it has had resident so far, bytes; 0 when it has gone.
    std::size_t peak_memory() const;
    /// The child left by itself with this exit status, or -1. Known after stop().
    int exit_status() const { return exit_status_; }

    /// The end of what it wrote to its standard error, at most a few lines.
    std::string last_words();

   private:
    bool reaped(std::chrono::milliseconds patience);

    pid_t pid_ = -1;
    FileDescriptor socket_;
    MessageTail messages_;
    std::string end_;  ///< how it ended; empty while it lives
    int exit_status_ = -1;
};

}  // namespace povpreview
