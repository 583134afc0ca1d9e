// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/program/session_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <utility>

#include "core/error.h"
#include "display/program/session_samples.h"

namespace povpreview {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view magic = "povpreview session 2\n";
constexpr std::size_t largest_chunk = std::size_t{1} << 28, chunk_wanted = std::size_t{1} << 20;
constexpr std::chrono::milliseconds interval{700};

[[noreturn]] void refuse(const std::string& cause, const fs::path& file,
                         const std::string& remedy = "name another file, or delete this one") {
    throw Error(Exit::usage, cause, file.string(), remedy);
}

/// FNV-1a (Fowler, Noll, Vo): tells accidents apart, not attacks.
constexpr std::uint64_t hash_begin = 0xcbf29ce484222325;
std::uint64_t hash(std::string_view bytes, std::uint64_t before = hash_begin) {
    for (const char c : bytes) before = (before ^ static_cast<unsigned char>(c)) * 0x100000001b3;
    return before;
}

/// Of a file's contents; 0 if it cannot be read.
std::uint64_t hash_of(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream) return 0;
    std::uint64_t result = hash_begin;
    std::string part(1 << 16, '\0');
    while (stream.read(part.data(), static_cast<std::streamsize>(part.size())) ||
           stream.gcount() > 0)
        result = hash({part.data(), static_cast<std::size_t>(stream.gcount())}, result);
    return result;
}

/// The identity as lines, each a fact, named by its first word.
std::vector<std::string> facts(const SessionIdentity& identity) {
    std::vector<std::string> result;
    result.push_back("version " + identity.tracer);
    result.push_back(fmt::format("size {} x {}", identity.width, identity.height));
    result.push_back(fmt::format("alpha {}", identity.alpha ? "on" : "off"));
    for (const std::string& word : identity.words) result.push_back("option " + word);
    for (const std::string& file : identity.files)
        result.push_back(fmt::format("file {} {:016x}", file, hash_of(file)));
    return result;
}

std::string joined(const std::vector<std::string>& lines) {
    return fmt::format("{}\n", fmt::join(lines, "\n"));
}

/// Says in what a session differs from what it should be.
[[noreturn]] void refuse_identity(const std::string& theirs, const std::vector<std::string>& ours,
                                  const fs::path& session) {
    std::vector<std::string> lines;
    for (std::size_t at = 0; at < theirs.size();) {
        const std::size_t end = std::min(theirs.find('\n', at), theirs.size());
        lines.push_back(theirs.substr(at, end - at));
        at = end + 1;
    }
    const auto missing = [](const std::vector<std::string>& in,
                            const std::vector<std::string>& of) {
        for (const std::string& line : in)
            if (std::find(of.begin(), of.end(), line) == of.end()) return line;
        return std::string();
    };
    std::string old = missing(lines, ours), now = missing(ours, lines);
    const std::string& either = now.empty() ? old : now;
    if (either.starts_with("file "))
        refuse(fmt::format("the session is of another scene: {} has changed since",
                           either.substr(5, either.rfind(' ') - 5)),
               session);
    if (old.empty() && now.empty()) old = "its options in another order";
    refuse(fmt::format("the session was made otherwise: {}",
                       old.empty()   ? "without " + now
                       : now.empty() ? "with " + old
                                     : "with " + old + ", not with " + now),
           session);
}

std::string chunk(std::string_view content) {
    const std::uint64_t size = content.size(), checksum = hash(content);
    std::string result(16, '\0');
    std::memcpy(result.data(), &size, 8);
    std::memcpy(result.data() + 8, &checksum, 8);
    result += content;
    return result;
}

/// Reads chunks one after the other.
class ChunkReader {
   public:
    explicit ChunkReader(const fs::path& file) : file_(file), stream_(file, std::ios::binary) {
        std::string start(magic.size(), '\0');
        if (!stream_.read(start.data(), static_cast<std::streamsize>(start.size())) ||
            start != magic)
            refuse("this is no session of this version of povpreview", file);
        end_ = magic.size();
    }
    /// False at the end, or where the last chunk is cut off.
    bool read(std::string& content) {
        std::uint64_t head[2];
        if (!stream_.read(reinterpret_cast<char*>(head), sizeof head)) return false;
        if (head[0] > largest_chunk) refuse_damage();
        content.resize(head[0]);
        if (!stream_.read(content.data(), static_cast<std::streamsize>(content.size())))
            return false;
        if (hash(content) != head[1]) refuse_damage();
        end_ += sizeof head + content.size();
        return true;
    }
    [[noreturn]] void refuse_damage() const { refuse("the session is damaged", file_); }
    std::size_t end() const { return end_; }  ///< of the chunks read, bytes

   private:
    const fs::path& file_;
    std::ifstream stream_;
    std::size_t end_ = 0;
};

void lock(int fd, const fs::path& file) {
    if (flock(fd, LOCK_EX | LOCK_NB) == 0) return;
    close(fd);
    refuse("another povpreview is at work on this session", file, "wait for its end");
}

}  // namespace

SessionFile SessionFile::begin(const fs::path& file, const SessionIdentity& identity) {
    const int fd = open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (fd < 0 && errno == EEXIST)
        refuse("there is a session, or another file, of this name", file,
               "go on with it by --resume, name another file, or delete this one");
    if (fd < 0)
        refuse(fmt::format("cannot make this file ({})", std::strerror(errno)), file,
               "give --session a file in a folder that you may write");
    lock(fd, file);
    SessionFile session(file, fd);
    if (!session.write(std::string(magic) + chunk(joined(facts(identity))))) {
        std::error_code gone;
        fs::remove(file, gone);
        refuse(session.trouble_, file, "give --session a file on a disk with room");
    }
    return session;
}

SessionFile SessionFile::resume(const fs::path& file, const SessionIdentity& identity,
                                const std::function<void(const Sample&)>& each) {
    const int fd = open(file.c_str(), O_WRONLY | O_CLOEXEC);
    if (fd < 0) refuse(fmt::format("cannot open this file ({})", std::strerror(errno)), file);
    lock(fd, file);
    SessionFile session(file, fd);
    ChunkReader reader(file);
    std::string content;
    const std::vector<std::string> ours = facts(identity);
    if (!reader.read(content)) reader.refuse_damage();
    if (content != joined(ours)) refuse_identity(content, ours, file);
    while (reader.read(content))
        if (!decode_samples(content, each)) reader.refuse_damage();
    // A chunk that was cut off is overwritten.
    if (ftruncate(fd, static_cast<off_t>(reader.end())) != 0 ||
        lseek(fd, static_cast<off_t>(reader.end()), SEEK_SET) < 0)
        refuse(fmt::format("cannot write this file ({})", std::strerror(errno)), file);
    return session;
}

SessionFile::SessionFile(SessionFile&& other) noexcept
    : path_(std::move(other.path_)),
      fd_(std::exchange(other.fd_, -1)),
      pending_(std::move(other.pending_)),
      written_(other.written_),
      trouble_(std::move(other.trouble_)) {}

SessionFile::~SessionFile() {
    write_all();
    if (fd_ >= 0) close(fd_);
}

void SessionFile::add(const Sample& sample) {
    if (fd_ >= 0 && trouble_.empty()) encode_sample(pending_, sample);
}

void SessionFile::write_some() {
    if (pending_.size() >= chunk_wanted || Clock::now() - written_ >= interval) write_all();
}

void SessionFile::write_all() {
    written_ = Clock::now();
    if (fd_ < 0 || pending_.empty()) return;
    write(chunk(pending_));
    pending_.clear();
}

/// All of it, or the session ends before it.
bool SessionFile::write(const std::string& bytes) {
    const off_t begin = lseek(fd_, 0, SEEK_CUR);
    for (std::size_t done = 0; done < bytes.size();) {
        const ssize_t n = ::write(fd_, bytes.data() + done, bytes.size() - done);
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) {
            trouble_ =
                fmt::format("the session cannot be kept any more ({})", std::strerror(errno));
            // What is whole stays of use.
            [[maybe_unused]] const int cut = ftruncate(fd_, begin);
            return false;
        }
        done += static_cast<std::size_t>(n);
    }
    return true;
}

}  // namespace povpreview
