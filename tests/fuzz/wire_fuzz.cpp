// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Feeds the wire with whatever the fuzzer thinks of: the first byte is the size of the chunks, the
// rest the stream. Run: wire_fuzz -max_len=4096 CORPUS
#include <cstddef>
#include <cstdint>

#include "tests/fuzz/exercise_wire.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size < 1) return 0;
    const std::span<const std::byte> stream(reinterpret_cast<const std::byte*>(data) + 1, size - 1);
    povpreview::exercise_wire(stream, std::size_t{data[0]} + 1);
    return 0;
}
