// SPDX-License-Identifier: AGPL-3.0-or-later
//
// open_context [backend]: opens an offscreen context and prints what it is, or the error that came
// of it. A process of its own, since a library once loaded cannot be taken away again.
#include <cstdio>

#include "core/error.h"
#include "display/gl_context.h"

int main(int argc, char** argv) {
    using namespace povpreview;
    try {
        const Backend backend = argc > 1 ? backend_named(argv[1]) : Backend::automatic;
        std::puts(open_offscreen(backend)->description().c_str());
        return 0;
    } catch (const Error& error) {
        std::puts(error.what());
        return static_cast<int>(error.exit());
    }
}
