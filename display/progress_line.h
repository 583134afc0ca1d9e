// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <string_view>

namespace povpreview {

/// How far a preview has come.
struct Progress {
    std::string_view state;         ///< such as "parsing" or "refining"
    std::size_t samples = 0;        ///< full samples so far
    std::size_t pixels = 0;         ///< of the image; 0: not known yet
    double samples_per_second = 0;  ///< 0: not known yet
    std::chrono::duration<double> elapsed{};
};

/// Such as "refining  12,345 samples (4.02 % of pixels)  133,000/s  0:12".
std::string sentence(const Progress& progress);

/// One line of a terminal, rewritten as things go on and gone at the end. Writes nothing where
/// there is no terminal to rewrite it on.
class ProgressLine {
   public:
    using Clock = std::chrono::steady_clock;

    /// `descriptor` is written to; stderr by default, so that output in a pipe stays clean.
    explicit ProgressLine(int descriptor = 2);
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;
    ~ProgressLine() { clear(); }

    /// Shows `text`, cut to the terminal's width; nothing if less than a tenth of a second went by
    /// since the line was last written.
    void show(std::string_view text, Clock::time_point now = Clock::now());
    void show(const Progress& progress) { show(sentence(progress)); }
    /// Takes the line away, so that something else can be written; the next show() is not held
    /// back.
    void clear();

   private:
    void write(std::string_view bytes) const;
    std::size_t columns() const;

    int descriptor_;
    bool terminal_;
    bool shown_ = false;
    Clock::time_point last_{};
};

}  // namespace povpreview
