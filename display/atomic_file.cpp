// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>
#include <utility>

#include "core/error.h"

namespace povpreview {

namespace {

namespace fs = std::filesystem;

Error failure(const fs::path& path, int code) {
    const char* remedy = "choose another place with --output";
    if (code == ENOSPC || code == EDQUOT) remedy = "make room or choose another place";
    if (code == EACCES || code == EPERM || code == EROFS)
        remedy = "choose a place where you may write";
    if (code == ENOENT || code == ENOTDIR) remedy = "make the folder first";
    return Error(Exit::usage, std::string("cannot write: ") + std::strerror(code), path.string(),
                 remedy);
}

/// An open file; closing is told apart from destruction since only then its errors can be heard.
class File {
   public:
    explicit File(int descriptor) : descriptor_(descriptor) {}
    File(const File&) = delete;
    File& operator=(const File&) = delete;
    ~File() {
        if (descriptor_ >= 0) ::close(descriptor_);
    }
    int descriptor() const { return descriptor_; }

    /// 0, or the code of what went wrong.
    int write(std::span<const unsigned char> bytes) {
        while (!bytes.empty()) {
            const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
            if (written < 0 && errno == EINTR) continue;
            if (written < 0) return errno;
            bytes = bytes.subspan(static_cast<std::size_t>(written));
        }
        return 0;
    }
    /// Some file systems report a full disk only here.
    int close() { return ::close(std::exchange(descriptor_, -1)) < 0 ? errno : 0; }

   private:
    int descriptor_;
};

/// The mode that an ordinary new file would get. mkstemp's is for its owner alone.
mode_t ordinary_mode() {
    const mode_t mask = ::umask(0);
    ::umask(mask);
    return 0666 & ~mask;
}

void write_in_place(const fs::path& path, std::span<const unsigned char> bytes) {
    File file(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
    if (file.descriptor() < 0) throw failure(path, errno);
    int code = file.write(bytes);
    if (code == 0) code = file.close();
    if (code != 0) throw failure(path, code);
}

void replace(const fs::path& path, mode_t mode, std::span<const unsigned char> bytes) {
    std::string temporary = path.string() + ".XXXXXX";
    File file(::mkostemp(temporary.data(), O_CLOEXEC));
    if (file.descriptor() < 0) throw failure(path, errno);
    int code = file.write(bytes);
    if (code == 0 && ::fchmod(file.descriptor(), mode) < 0) code = errno;
    if (code == 0) code = file.close();
    if (code == 0 && ::rename(temporary.c_str(), path.c_str()) < 0) code = errno;
    if (code == 0) return;
    ::unlink(temporary.c_str());
    throw failure(path, code);
}

}  // namespace

void write_file(const fs::path& path, std::span<const unsigned char> bytes) {
    struct stat status {};
    if (::stat(path.c_str(), &status) < 0) {
        if (errno != ENOENT) throw failure(path, errno);
        return replace(path, ordinary_mode(), bytes);
    }
    if (!S_ISREG(status.st_mode)) return write_in_place(path, bytes);
    std::error_code error;
    const fs::path target = fs::canonical(path, error);
    if (error) throw failure(path, error.value());
    replace(target, status.st_mode & 07777, bytes);
}

}  // namespace povpreview
