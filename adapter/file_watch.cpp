// SPDX-License-Identifier: AGPL-3.0-or-later
#include "adapter/file_watch.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <cstddef>
#include <cstring>

#include "core/error.h"

namespace povpreview {
namespace {

namespace fs = std::filesystem;

#if defined(__x86_64__)
constexpr std::uint32_t native = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr std::uint32_t native = AUDIT_ARCH_AARCH64;
#else
#error "name this machine's AUDIT_ARCH here, see linux/audit.h"
#endif

/// Announces openat, openat2 and, where there is one, open; lets all else pass.
constexpr sock_filter filter[] = {
    BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, arch)),
    BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, native, 1, 0),
    BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
    BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
#ifdef __NR_open
    BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, __NR_open, 3, 0),
#else
    BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, __NR_openat, 3, 0),
#endif
    BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, __NR_openat, 2, 0),
    BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, __NR_openat2, 1, 0),
    BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
    BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_USER_NOTIF),
};

/// Bytes of another process. False if they are not there (any more).
bool read_memory(pid_t process, std::uint64_t address, void* to, std::size_t size) {
    const iovec here{to, size}, there{reinterpret_cast<void*>(address), size};
    return process_vm_readv(process, &here, 1, &there, 1, 0) == static_cast<ssize_t>(size);
}

/// A string of another process, page by page: what is behind its end may not be there.
std::optional<std::string> read_string(pid_t process, std::uint64_t address) {
    constexpr std::uint64_t page = 4096;
    std::string result;
    char part[page];
    while (result.size() < PATH_MAX) {
        const std::size_t size = page - address % page;
        if (!read_memory(process, address, part, size)) return std::nullopt;
        const void* end = std::memchr(part, 0, size);
        if (end)
            return result.append(static_cast<const char*>(part), static_cast<const char*>(end));
        result.append(part, size);
        address += size;
    }
    return std::nullopt;
}

/// Where relative paths of a process begin.
fs::path folder_of(pid_t process, int directory) {
    std::error_code gone;
    return fs::read_symlink(directory == AT_FDCWD
                                ? fmt::format("/proc/{}/cwd", process)
                                : fmt::format("/proc/{}/fd/{}", process, directory),
                            gone);
}

/// Parts of the program, which its own version stands for, and what is no file.
bool is_machinery(const fs::path& path) {
    const std::string name = path.filename().string(), whole = path.string();
    return name.ends_with(".so") || name.find(".so.") != std::string::npos ||
           name.starts_with("ld.so.") || whole.starts_with("/proc/") ||
           whole.starts_with("/sys/") || whole.starts_with("/dev/");
}

/// Sends a descriptor through a socket. Safe between fork and exec.
bool send_descriptor(int socket, int descriptor) {
    char byte = 0;
    iovec part{&byte, 1};
    alignas(cmsghdr) char room[CMSG_SPACE(sizeof descriptor)] = {};
    msghdr message{};
    message.msg_iov = &part;
    message.msg_iovlen = 1;
    message.msg_control = room;
    message.msg_controllen = sizeof room;
    cmsghdr* header = CMSG_FIRSTHDR(&message);
    header->cmsg_level = SOL_SOCKET;
    header->cmsg_type = SCM_RIGHTS;
    header->cmsg_len = CMSG_LEN(sizeof descriptor);
    std::memcpy(CMSG_DATA(header), &descriptor, sizeof descriptor);
    return sendmsg(socket, &message, MSG_NOSIGNAL) == 1;
}

FileDescriptor receive_descriptor(int socket) {
    char byte = 0;
    iovec part{&byte, 1};
    alignas(cmsghdr) char room[CMSG_SPACE(sizeof(int))] = {};
    msghdr message{};
    message.msg_iov = &part;
    message.msg_iovlen = 1;
    message.msg_control = room;
    message.msg_controllen = sizeof room;
    ssize_t got;
    do got = recvmsg(socket, &message, MSG_CMSG_CLOEXEC);
    while (got < 0 && errno == EINTR);
    const cmsghdr* header = got == 1 ? CMSG_FIRSTHDR(&message) : nullptr;
    int descriptor = -1;
    if (header && header->cmsg_type == SCM_RIGHTS)
        std::memcpy(&descriptor, CMSG_DATA(header), sizeof descriptor);
    return FileDescriptor(descriptor);
}

std::int64_t nanoseconds(const timespec& time) {
    return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

}  // namespace

FileStamp FileStamp::of(const fs::path& path) {
    struct stat status {};
    if (stat(path.c_str(), &status) != 0) return {};
    return {status.st_dev, status.st_ino, status.st_size, nanoseconds(status.st_mtim),
            nanoseconds(status.st_ctim)};
}

Ends FileWatch::socket_pair() {
    int fds[2];
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, fds) != 0)
        throw Error(Exit::usage, std::string("cannot make a socket: ") + std::strerror(errno), "",
                    "see how many files may be open (ulimit -n)");
    return {FileDescriptor(fds[0]), FileDescriptor(fds[1])};
}

void FileWatch::watch_this_process(int socket) {
    const sock_fprog program{static_cast<unsigned short>(std::size(filter)),
                             const_cast<sock_filter*>(filter)};
    if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) return;
    // SPEC_ALLOW: a filter must not slow the tracing down by mitigations that nobody asked for.
    const long listener =
        syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER,
                SECCOMP_FILTER_FLAG_NEW_LISTENER | SECCOMP_FILTER_FLAG_SPEC_ALLOW, &program);
    if (listener < 0) return;  // the parent hears of it: the socket closes without a message
    if (!send_descriptor(socket, static_cast<int>(listener))) _exit(127);
    close(static_cast<int>(listener));
}

void FileWatch::begin(FileDescriptor socket) {
    FileDescriptor listener = receive_descriptor(socket.get());
    if (!listener.open()) {
        complete_ = false;
        return;
    }
    threads_.emplace_back(
        [this](std::stop_token stop, FileDescriptor l) { serve(std::move(l), std::move(stop)); },
        std::move(listener));
}

FileWatch::~FileWatch() { finish(); }

std::optional<std::vector<FileAccess>> FileWatch::finish() {
    for (std::jthread& thread : threads_) thread.request_stop();
    threads_.clear();  // joins
    if (!complete_) return std::nullopt;
    std::vector<FileAccess> result;
    for (const auto& [path, access] : accesses_) result.push_back(access);
    return result;
}

void FileWatch::serve(FileDescriptor listener, std::stop_token stop) {
    constexpr int patience_ms = 20;
    while (true) {
        pollfd ready{.fd = listener.get(), .events = POLLIN, .revents = 0};
        const int count = poll(&ready, 1, patience_ms);
        if (count == 0 && stop.stop_requested()) return;
        if (count <= 0) continue;
        if (!(ready.revents & POLLIN)) return;  // all that were watched have gone
        seccomp_notif call{};
        if (ioctl(listener.get(), SECCOMP_IOCTL_NOTIF_RECV, &call) != 0) continue;
        const auto process = static_cast<pid_t>(call.pid);
        const auto* arguments = call.data.args;
        const bool old_open = call.data.nr != __NR_openat && call.data.nr != __NR_openat2;
        const auto path = read_string(process, arguments[old_open ? 0 : 1]);
        std::uint64_t flags = arguments[old_open ? 1 : 2];
        bool known = path.has_value();
        if (call.data.nr == __NR_openat2)  // its flags stand in a structure, first
            known = known && read_memory(process, flags, &flags, sizeof flags);
        // A call that was given up meanwhile had another's memory read for it, or none.
        if (ioctl(listener.get(), SECCOMP_IOCTL_NOTIF_ID_VALID, &call.id) != 0) continue;
        if (known) {
            note(old_open ? AT_FDCWD : static_cast<int>(arguments[0]), *path, flags, process);
        } else {
            const std::lock_guard lock(mutex_);
            complete_ = false;
        }
        seccomp_notif_resp answer{
            .id = call.id, .val = 0, .error = 0, .flags = SECCOMP_USER_NOTIF_FLAG_CONTINUE};
        ioctl(listener.get(), SECCOMP_IOCTL_NOTIF_SEND, &answer);
    }
}

void FileWatch::note(int directory, std::string path, std::uint64_t flags, pid_t process) {
    fs::path file = path;
    if (file.is_relative()) file = folder_of(process, directory) / file;
    if (is_machinery(file)) return;
    const bool made = (flags & (O_TRUNC | O_EXCL)) != 0;
    const std::lock_guard lock(mutex_);
    if (!accesses_.contains(file)) accesses_[file] = {file, made, FileStamp::of(file)};
}

}  // namespace povpreview
