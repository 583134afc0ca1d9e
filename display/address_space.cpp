// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/address_space.h"

#include <sys/mman.h>

#include "core/error.h"

namespace povpreview {

void require_address_space(std::size_t bytes, const std::string& place) {
    void* const mapped =
        mmap(nullptr, bytes, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (mapped == MAP_FAILED)
        throw Error(Exit::usage,
                    "needs " + std::to_string(bytes / address_space::mib) +
                        " MiB of address space, which the system refuses",
                    place, "raise the limit (ulimit -v)");
    munmap(mapped, bytes);
}

}  // namespace povpreview
