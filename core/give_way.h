// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <unistd.h>

namespace povpreview {

/// From now on this thread gets about a quarter of a processor that others want as well: what is
/// found out beside the samples is worth a part of what those are. Not to be undone.
inline void give_way() {
    // On Linux a thread has a niceness of its own. Where it may not change, all goes on as before.
    [[maybe_unused]] const int niceness = nice(5);
}

}  // namespace povpreview
