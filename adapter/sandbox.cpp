// SPDX-License-Identifier: AGPL-3.0-or-later
#include "adapter/sandbox.h"

#include <elf.h>
#include <fcntl.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/landlock.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>

namespace povpreview {
namespace {

namespace fs = std::filesystem;

// ---- Landlock, whose calls have no wrappers in glibc

/// The rights that this machine's header may not know yet, and the attribute with all that we use.
constexpr std::uint64_t right_refer = 1u << 13, right_truncate = 1u << 14, right_ioctl = 1u << 15;
constexpr std::uint64_t scope_abstract_unix_socket = 1u << 0, scope_signal = 1u << 1;
struct RulesetAttribute {
    std::uint64_t handled_access_fs, handled_access_net, scoped;
};

int landlock_version() {
    const long version =
        syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION);
    return version < 0 ? 0 : static_cast<int>(version);
}

/// All rights to files that a version of Landlock can take away.
std::uint64_t all_rights(int version) {
    std::uint64_t rights = (LANDLOCK_ACCESS_FS_MAKE_SYM << 1) - 1;
    if (version >= 2) rights |= right_refer;
    if (version >= 3) rights |= right_truncate;
    if (version >= 5) rights |= right_ioctl;
    return rights;
}

FileDescriptor create_ruleset(int version, std::uint64_t handled) {
    RulesetAttribute attribute{handled, 0, 0};
    if (version >= 6) attribute.scoped = scope_abstract_unix_socket | scope_signal;
    const std::size_t size = version >= 6 ? sizeof attribute : sizeof handled;
    return FileDescriptor(
        static_cast<int>(syscall(SYS_landlock_create_ruleset, &attribute, size, 0)));
}

constexpr std::uint64_t read_rights = LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_READ_DIR;
constexpr std::uint64_t write_rights = read_rights | LANDLOCK_ACCESS_FS_WRITE_FILE |
                                       LANDLOCK_ACCESS_FS_MAKE_REG |
                                       LANDLOCK_ACCESS_FS_REMOVE_FILE | right_truncate;
constexpr std::uint64_t run_rights = LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_EXECUTE;

/// What any dynamically linked program reads.
constexpr const char* system_paths[] = {"/lib",
                                        "/lib64",
                                        "/usr/lib",
                                        "/usr/local/lib",
                                        "/etc/ld.so.cache",
                                        "/etc/localtime",
                                        "/proc",
                                        "/sys/devices/system",
                                        "/usr/share/zoneinfo",
                                        "/dev/null",
                                        "/dev/urandom"};

// ---- the program

fs::path find_in_path(const std::string& program) {
    if (program.find('/') != std::string::npos) return program;
    std::istringstream folders(std::getenv("PATH") ? std::getenv("PATH") : "/usr/bin:/bin");
    for (std::string folder; std::getline(folders, folder, ':');)
        if (access((fs::path(folder) / program).c_str(), X_OK) == 0)
            return fs::path(folder) / program;
    return program;
}

/// The dynamic loader that an ELF file names, or nothing.
std::string loader_of(const fs::path& program) {
    std::ifstream file(program, std::ios::binary);
    Elf64_Ehdr header{};
    if (!file.read(reinterpret_cast<char*>(&header), sizeof header) ||
        std::memcmp(header.e_ident, ELFMAG, SELFMAG) != 0)
        return {};
    for (unsigned i = 0; i < header.e_phnum; ++i) {
        Elf64_Phdr segment{};
        file.seekg(static_cast<std::streamoff>(header.e_phoff + i * sizeof segment));
        if (!file.read(reinterpret_cast<char*>(&segment), sizeof segment)) return {};
        if (segment.p_type != PT_INTERP || segment.p_filesz > 4096) continue;
        std::string name(segment.p_filesz, '\0');
        file.seekg(static_cast<std::streamoff>(segment.p_offset));
        file.read(name.data(), static_cast<std::streamsize>(name.size()));
        return name.c_str();  // up to its null
    }
    return {};
}

// ---- seccomp

#if defined(__x86_64__)
constexpr std::uint32_t architecture = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr std::uint32_t architecture = AUDIT_ARCH_AARCH64;
#else
constexpr std::uint32_t architecture = 0;  // no filter
#endif

/// Calls that a tracer has no use for: the network, other processes, ways around file rules.
constexpr std::uint32_t denied_calls[] = {SYS_socket,
                                          SYS_connect,
                                          SYS_bind,
                                          SYS_listen,
                                          SYS_ptrace,
                                          SYS_process_vm_readv,
                                          SYS_process_vm_writev,
                                          SYS_pidfd_getfd,
                                          SYS_io_uring_setup,
                                          SYS_bpf,
                                          SYS_userfaultfd,
                                          SYS_keyctl,
                                          SYS_add_key,
                                          SYS_request_key,
                                          SYS_mount,
                                          SYS_unshare,
                                          SYS_setns,
                                          SYS_chroot,
                                          SYS_perf_event_open,
                                          SYS_open_by_handle_at};

constexpr std::size_t filter_length = 5 + std::size(denied_calls) + 2;

/// | foreign architecture or numbers of x32 -> denied | a denied call -> denied | else allowed |
constexpr std::array<sock_filter, filter_length> make_filter() {
    constexpr std::uint32_t x32_bit = 0x40000000, refuse = SECCOMP_RET_ERRNO | EPERM;
    constexpr auto calls = static_cast<std::uint8_t>(std::size(denied_calls));
    std::array<sock_filter, filter_length> filter{};
    std::size_t n = 0;
    filter[n++] = BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, arch));
    filter[n++] = BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, architecture, 1, 0);
    filter[n++] = BPF_STMT(BPF_RET | BPF_K, refuse);
    filter[n++] = BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr));
    filter[n++] = BPF_JUMP(BPF_JMP | BPF_JGE | BPF_K, x32_bit, calls + 1, 0);
    for (std::uint8_t i = 0; i < calls; ++i)
        filter[n++] = BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, denied_calls[i],
                               static_cast<std::uint8_t>(calls - i), 0);
    filter[n++] = BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW);
    filter[n++] = BPF_STMT(BPF_RET | BPF_K, refuse);
    return filter;
}

constinit std::array<sock_filter, filter_length> call_filter = make_filter();

bool has_seccomp() {
    const std::uint32_t action = SECCOMP_RET_ERRNO;
    return architecture != 0 && syscall(SYS_seccomp, SECCOMP_GET_ACTION_AVAIL, 0, &action) == 0;
}

}  // namespace

Sandbox::Sandbox(const SandboxRules& rules, const std::string& program) : memory_(rules.memory) {
    const int version = landlock_version();
    if (version < 1) return;
    handled_ = all_rights(version);
    ruleset_ = create_ruleset(version, handled_);
    if (!ruleset_.open()) return;
    const fs::path executable = find_in_path(program);
    allow(executable, run_rights);
    if (const std::string loader = loader_of(executable); !loader.empty())
        allow(loader, run_rights);
    for (const char* path : system_paths) allow(path, read_rights);
    for (const fs::path& path : rules.readable) allow(path, read_rights);
    for (const fs::path& path : rules.writable) allow(path, write_rights);
}

void Sandbox::allow(const fs::path& path, std::uint64_t access) const {
    const FileDescriptor fd(open(path.c_str(), O_PATH | O_CLOEXEC));
    struct stat status {};
    if (!fd.open() || fstat(fd.get(), &status) != 0) return;
    constexpr std::uint64_t file_rights = LANDLOCK_ACCESS_FS_EXECUTE |
                                          LANDLOCK_ACCESS_FS_READ_FILE |
                                          LANDLOCK_ACCESS_FS_WRITE_FILE | right_truncate;
    if (!S_ISDIR(status.st_mode)) access &= file_rights;
    landlock_path_beneath_attr rule{};
    rule.allowed_access = access & handled_;
    rule.parent_fd = fd.get();
    syscall(SYS_landlock_add_rule, ruleset_.get(), LANDLOCK_RULE_PATH_BENEATH, &rule, 0);
}

bool Sandbox::enter() const {
    if (memory_ > 0) {
        const rlimit limit{memory_, memory_};
        if (setrlimit(RLIMIT_AS, &limit) != 0) return false;
    }
    const rlimit no_core{0, 0};  // a core is a file, and large
    setrlimit(RLIMIT_CORE, &no_core);
    if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) return false;
    if (ruleset_.open() && syscall(SYS_landlock_restrict_self, ruleset_.get(), 0) != 0)
        return false;
    if (architecture == 0) return true;
    const sock_fprog filter{static_cast<unsigned short>(call_filter.size()), call_filter.data()};
    if (prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &filter, 0, 0) != 0)
        return errno == EINVAL || errno == ENOSYS;  // not built into this kernel
    return true;
}

std::string Sandbox::missing() {
    std::string text;
    if (landlock_version() < 1)
        text = "this kernel has no Landlock: only POV-Ray itself keeps the scene from files";
    if (!has_seccomp())
        text += std::string(text.empty() ? "" : "; ") +
                "this kernel filters no system calls: the tracer is not kept from the network";
    return text;
}

}  // namespace povpreview
