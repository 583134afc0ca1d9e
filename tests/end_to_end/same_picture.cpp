// SPDX-License-Identifier: AGPL-3.0-or-later
//
// same_picture A B: exits with 0 if two image files hold the same values, with 1 if not.
#include <cstdio>

#include "core/error.h"
#include "display/image_file.h"

int main(int argc, char** argv) {
    using namespace povpreview;
    if (argc != 3) return 2;
    try {
        const Image a = read_image(argv[1]), b = read_image(argv[2]);
        return a.width != b.width || a.height != b.height || a.pixels != b.pixels;
    } catch (const Error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    }
}
