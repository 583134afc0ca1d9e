// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "adapter/file_descriptor.h"

namespace povpreview {

/// What tells whether a file was changed without reading it. All zero where there is none.
struct FileStamp {
    std::uint64_t device = 0, inode = 0;
    std::int64_t size = 0, modified_ns = 0, changed_ns = 0;
    bool operator==(const FileStamp&) const = default;
    static FileStamp of(const std::filesystem::path& path);
};

/// A file that a watched process opened, or looked for in vain.
struct FileAccess {
    std::filesystem::path path;  ///< absolute
    bool made = false;           ///< it was first opened to be written anew: what it held before
                                 ///< had no influence
    FileStamp stamp;             ///< as it was when it was first opened
};

/// Learns from the kernel what files a child opens, and its own children too, including those that
/// it looks for where they are not: so it is known on which files a result of it depends, whatever
/// it computes their names from.
///
/// Every open() of the child is announced by a seccomp filter (SECCOMP_RET_USER_NOTIF, seccomp(2);
/// Linux 5.5 or newer) and goes on when it has been noted down, some 10 us later. Nothing else of
/// the child is touched, and no rights are needed; programs that gain rights when they are started
/// (sudo) cannot do so in the child. Shared libraries and what the kernel makes up (/proc, /sys,
/// /dev) are left out.
class FileWatch {
   public:
    FileWatch() = default;
    ~FileWatch();
    FileWatch(const FileWatch&) = delete;
    FileWatch& operator=(const FileWatch&) = delete;

    /// All files opened so far by the children given to start_child() with this watch, each once.
    /// REQUIRES: they have ended. Nothing if this machine does not let them be watched.
    std::optional<std::vector<FileAccess>> finish();

    /// For start_child(): the socket by which a child hands over its announcements,
    static Ends socket_pair();
    /// the child's part, between fork and exec,
    static void watch_this_process(int socket);
    /// and the parent's, after it.
    void begin(FileDescriptor socket);

   private:
    void serve(FileDescriptor listener, std::stop_token stop);
    void note(int directory, std::string path, std::uint64_t flags, pid_t process);

    std::mutex mutex_;  // guards what follows against the threads
    std::map<std::filesystem::path, FileAccess> accesses_;
    bool complete_ = true;  ///< every child could be watched
    std::vector<std::jthread> threads_;
};

}  // namespace povpreview
