// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <fmt/format.h>

#include <optional>
#include <string>

namespace povpreview {

/// A string as JSON writes it; bytes of UTF-8 stay as they are.
inline std::string json_string(const std::string& text) {
    std::string quoted = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\')
            (quoted += '\\') += c;
        else if (static_cast<unsigned char>(c) < ' ')
            quoted += fmt::format("\\u{:04x}", c);
        else
            quoted += c;
    }
    return quoted + '"';
}

/// A number, or null.
inline std::string json_number(const std::optional<double>& number) {
    return number ? fmt::format("{:.6g}", *number) : "null";
}

}  // namespace povpreview
