// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/progress_line.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>

namespace povpreview {

namespace {

constexpr std::chrono::milliseconds shortest_pause{100};

/// 1234567 as "1,234,567".
std::string grouped(std::size_t number) {
    std::string digits = std::to_string(number);
    for (int at = static_cast<int>(digits.size()) - 3; at > 0; at -= 3)
        digits.insert(static_cast<std::size_t>(at), ",");
    return digits;
}

/// The first `columns` characters of UTF-8 text, each taken to be one column wide.
std::string_view first_columns(std::string_view text, std::size_t columns) {
    std::size_t end = 0;
    for (std::size_t seen = 0; end < text.size(); ++end) {
        const bool starts_character = (static_cast<unsigned char>(text[end]) & 0xC0) != 0x80;
        if (starts_character && seen++ == columns) break;
    }
    return text.substr(0, end);
}

}  // namespace

std::string sentence(const Progress& progress) {
    std::string text(progress.state);
    text += "  " + grouped(progress.samples) + " samples";
    char part[64];
    if (progress.pixels > 0) {
        std::snprintf(
            part, sizeof part, " (%.3g %% of pixels)",
            100.0 * static_cast<double>(progress.samples) / static_cast<double>(progress.pixels));
        text += part;
    }
    if (progress.samples_per_second > 0)
        text += "  " + grouped(static_cast<std::size_t>(std::lround(progress.samples_per_second))) +
                "/s";
    const long seconds = static_cast<long>(progress.elapsed.count());
    if (seconds >= 3600)
        std::snprintf(part, sizeof part, "  %ld:%02ld:%02ld", seconds / 3600, seconds / 60 % 60,
                      seconds % 60);
    else
        std::snprintf(part, sizeof part, "  %ld:%02ld", seconds / 60, seconds % 60);
    return text + part;
}

ProgressLine::ProgressLine(int descriptor)
    : descriptor_(descriptor), terminal_(::isatty(descriptor) == 1) {}

std::size_t ProgressLine::columns() const {
    winsize size{};
    if (::ioctl(descriptor_, TIOCGWINSZ, &size) < 0 || size.ws_col == 0) return 80;
    return size.ws_col;
}

void ProgressLine::show(std::string_view text, Clock::time_point now) {
    if (!terminal_ || (shown_ && now - last_ < shortest_pause)) return;
    // One less than the width: a full last column makes some terminals go to the next line.
    const std::string_view cut = first_columns(text, columns() - 1);
    write("\r" + std::string(cut) + "\x1b[K");
    shown_ = true;
    last_ = now;
}

void ProgressLine::clear() {
    if (!shown_) return;
    write("\r\x1b[K");
    shown_ = false;
}

void ProgressLine::write(std::string_view bytes) const {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return;  // a terminal that went away is no reason to stop
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
}

}  // namespace povpreview
