// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>
#include <string>

namespace povpreview {

/// "data:TYPE;base64,..." (RFC 2397), for pictures inside an HTML file.
std::string data_uri(const std::string& type, std::span<const unsigned char> bytes);

/// Text as it stands in HTML, also inside quotes.
std::string html_escaped(const std::string& text);

}  // namespace povpreview
