// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/oracle.h"

namespace povpreview {

/// What samples are samples of: with equal identities they are equal.
struct SessionIdentity {
    std::string tracer;              ///< its version
    int width = 0, height = 0;       ///< pixels
    bool alpha = false;              ///< see SceneDescription
    std::vector<std::string> words;  ///< POV-Ray's, that samples depend on
    std::vector<std::string> files;  ///< all that the scene is made of; their contents count
};

/// The samples of a run, kept in a file so that a later run can go on from there.
///
///     | "povpreview session 1\n" | size | checksum | identity | size | checksum | samples | ...
///
/// Samples are written in chunks, about one a second, each by one write: what a kill loses is what
/// was traced since the last one. The file is locked as long as it is open. A disk that fills up
/// ends the keeping, not the preview: trouble() says so.
class SessionFile {
   public:
    /// Begins a session in a file that does not exist. Throws Error(Exit::usage).
    static SessionFile begin(const std::filesystem::path& file, const SessionIdentity& identity);
    /// Reads a session, tells of all its samples, and goes on with it. Of a chunk that a kill has
    /// cut off in the middle of writing nothing is used. Throws Error(Exit::usage) if it is
    /// damaged, in use, no session, or of another identity; what of the identity differs, the
    /// message says.
    static SessionFile resume(const std::filesystem::path& file, const SessionIdentity& identity,
                              const std::function<void(const Sample&)>& each);
    ~SessionFile();
    SessionFile(SessionFile&& other) noexcept;
    SessionFile& operator=(SessionFile&&) = delete;

    void add(const Sample& sample);
    /// Writes what was added, if that is much or a while ago.
    void write_some();
    /// Writes what was added.
    void write_all();

    const std::filesystem::path& file() const { return path_; }
    /// Why nothing is kept any more; empty while all is well.
    const std::string& trouble() const { return trouble_; }

   private:
    using Clock = std::chrono::steady_clock;
    SessionFile(std::filesystem::path path, int fd) : path_(std::move(path)), fd_(fd) {}
    bool write(const std::string& bytes);

    std::filesystem::path path_;
    int fd_ = -1;
    std::string pending_;  ///< samples, encoded
    Clock::time_point written_ = Clock::now();
    std::string trouble_;
};

}  // namespace povpreview
