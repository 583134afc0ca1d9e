// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <string>

namespace povpreview::fuzz {

/// What the fuzzer feeds: each does with any bytes what the program might, and ends the process
/// where a promise is broken. Their corpora are in folders of these names.
using Target = void(std::span<const std::byte>);
Target wire, mesh, edges, items, options;

/// Ends the process, saying what was promised.
inline void promise(bool kept, const std::string& what) {
    if (kept) return;
    std::fprintf(stderr, "broken promise: %s\n", what.c_str());
    std::abort();
}

}  // namespace povpreview::fuzz
