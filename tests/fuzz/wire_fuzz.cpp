// SPDX-License-Identifier: AGPL-3.0-or-later
//
// The previewer's end of the wire: the first byte is the size of the chunks, the rest the stream.
#include "tests/fuzz/exercise_wire.h"
#include "tests/fuzz/targets.h"

namespace povpreview::fuzz {

void wire(std::span<const std::byte> bytes) {
    if (bytes.empty()) return;
    exercise_wire(bytes.subspan(1), static_cast<std::size_t>(bytes.front()) + 1);
}

}  // namespace povpreview::fuzz
