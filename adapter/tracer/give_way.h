// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <sys/resource.h>

namespace povpreview::tracer {

/// From now on this thread gets about a quarter of a processor that others want as well.
inline void give_way() {
    constexpr int niceness = 5;
    setpriority(PRIO_PROCESS, 0, niceness);  // of this thread alone, on Linux
}

}  // namespace povpreview::tracer
