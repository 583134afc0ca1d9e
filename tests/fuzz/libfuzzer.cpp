// SPDX-License-Identifier: AGPL-3.0-or-later
//
// libFuzzer's way into FUZZ_TARGET, one of targets.h. Run:
//   build/fuzz/tests/fuzz/mesh_fuzz -max_len=4096 -max_total_time=600 NEW tests/fuzz/corpus/mesh
#include <cstdint>

#include "tests/fuzz/targets.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    povpreview::fuzz::FUZZ_TARGET({reinterpret_cast<const std::byte*>(data), size});
    return 0;
}
