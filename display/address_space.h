// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

namespace povpreview {

/// What others' libraries map at most, measured with 50 % more than they took. They are asked for
/// beforehand, as GL's drivers and what comes with the image library do not bear being refused
/// memory: they crash.
namespace address_space {
constexpr std::size_t mib = std::size_t(1) << 20;
constexpr std::size_t drawing = 384 * mib;  ///< a GL driver of Mesa, with LLVM
constexpr std::size_t images = 1024 * mib;  ///< OpenImageIO with the libraries that it needs
constexpr std::size_t preview = drawing + images + 256 * mib;
}  // namespace address_space

/// Throws Error (Exit::usage) where this process may not map `bytes` more (ulimit -v); `place` is
/// for the message.
void require_address_space(std::size_t bytes, const std::string& place);

}  // namespace povpreview
