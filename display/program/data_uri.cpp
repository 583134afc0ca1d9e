// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/program/data_uri.h"

namespace povpreview {

std::string data_uri(const std::string& type, std::span<const unsigned char> bytes) {
    static constexpr char digits[] =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string uri = "data:" + type + ";base64,";
    uri.reserve(uri.size() + (bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t rest = bytes.size() - i;
        const unsigned group =
            bytes[i] << 16 | (rest > 1 ? bytes[i + 1] << 8 : 0) | (rest > 2 ? bytes[i + 2] : 0);
        uri += digits[group >> 18];
        uri += digits[group >> 12 & 63];
        uri += rest > 1 ? digits[group >> 6 & 63] : '=';
        uri += rest > 2 ? digits[group & 63] : '=';
    }
    return uri;
}

std::string html_escaped(const std::string& text) {
    std::string result;
    for (const char c : text) switch (c) {
            case '&':
                result += "&amp;";
                break;
            case '<':
                result += "&lt;";
                break;
            case '>':
                result += "&gt;";
                break;
            case '"':
                result += "&quot;";
                break;
            default:
                result += c;
        }
    return result;
}

}  // namespace povpreview
