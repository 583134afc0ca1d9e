// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <cstddef>

namespace povpreview {

/// The most memory that a living process has had resident so far, bytes; 0 where the system does
/// not tell.
std::size_t peak_resident_memory(pid_t process);

/// What this process has resident now, bytes; 0 where the system does not tell.
std::size_t resident_memory();

}  // namespace povpreview
