// SPDX-License-Identifier: AGPL-3.0-or-later
#include "adapter/message_tail.h"

#include <cerrno>
#include <vector>

namespace povpreview {

void MessageTail::drain() {
    constexpr std::size_t kept = 16384;
    char buffer[4096];
    while (pipe_.open()) {
        const ssize_t n = read(pipe_.get(), buffer, sizeof buffer);
        if (n < 0 && errno == EINTR) continue;
        if (n < 0 && errno == EAGAIN) return;
        if (n <= 0) return pipe_.reset();
        text_.append(buffer, static_cast<std::size_t>(n));
        if (text_.size() > 2 * kept) text_.erase(0, text_.size() - kept);
    }
}

std::string MessageTail::last_lines(std::size_t count) const {
    std::vector<std::string> lines(1);
    for (const char c : text_) {
        if (c == '\n') {
            if (!lines.back().empty()) lines.emplace_back();
        } else if (c == '\r') {
            lines.back().clear();
        } else {
            lines.back() += c;
        }
    }
    if (lines.back().empty()) lines.pop_back();
    std::string result;
    for (std::size_t i = lines.size() > count ? lines.size() - count : 0; i < lines.size(); ++i)
        result += (result.empty() ? "" : "\n") + lines[i];
    return result;
}

}  // namespace povpreview
