// SPDX-License-Identifier: AGPL-3.0-or-later
//
// same_picture A B: exits with 0 if two image files hold the same values, with 1 if not, and says
// how many pixels differ and how far.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/common.hpp>

#include "core/error.h"
#include "display/image_file.h"

int main(int argc, char** argv) {
    using namespace povpreview;
    if (argc != 3) return 2;
    try {
        const Image a = read_image(argv[1]), b = read_image(argv[2]);
        if (a.width != b.width || a.height != b.height) {
            std::printf("%dx%d against %dx%d\n", a.width, a.height, b.width, b.height);
            return 1;
        }
        std::size_t differing = 0;
        float most = 0;
        for (std::size_t i = 0; i < a.pixels.size(); ++i) {
            if (a.pixels[i] == b.pixels[i]) continue;
            ++differing;
            const auto apart = glm::abs(a.pixels[i] - b.pixels[i]);
            for (int channel = 0; channel < apart.length(); ++channel)
                most = std::max(most, apart[channel]);
        }
        std::printf("%zu pixels by %.2g at most\n", differing, most);
        return differing != 0;
    } catch (const Error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    }
}
