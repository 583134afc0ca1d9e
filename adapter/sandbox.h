// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "adapter/file_descriptor.h"

namespace povpreview {

/// What a tracer may touch of the machine: a scene is a program from a stranger.
struct SandboxRules {
    std::vector<std::filesystem::path> readable;  ///< files, and folders with all that is in them
    std::vector<std::filesystem::path> writable;  ///< folders
    std::uint64_t memory = 0;                     ///< bytes of address space; 0: no limit
};

/// Confines a child between fork and exec. Files by Landlock (Linux 5.13): only `readable`, the
/// program and the shared libraries can be read, only `writable` written, nothing but the program
/// run, nobody outside be sent a signal (6.12). The network, other processes and the ways around
/// Landlock by a seccomp filter. What the kernel has not, is left out, and missing() says so.
class Sandbox {
   public:
    /// Prepares all that need not be done in the child. `program` is looked up in PATH if it has
    /// no slash. Paths that do not exist are left out.
    Sandbox(const SandboxRules& rules, const std::string& program);

    /// Confines the calling process for good: only calls that are safe between fork and exec.
    /// False with errno if the kernel refuses.
    bool enter() const;

    /// What of this the kernel cannot do, as a sentence; empty if it can do all.
    static std::string missing();

   private:
    void allow(const std::filesystem::path& path, std::uint64_t access) const;

    FileDescriptor ruleset_;  ///< not open where the kernel has no Landlock
    std::uint64_t handled_ = 0, memory_ = 0;
};

}  // namespace povpreview
