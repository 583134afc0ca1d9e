// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/bench/edge_positions/misses.h"

#include "core/colour.h"

namespace povpreview {
namespace {

constexpr glm::vec3 constraint_paint{.1f, .3f, .9f}, missed_paint{.9f, 0, 0},
    misplaced_paint{1.f, .35f, 0};

}  // namespace

Image picture_of_misses(const Image& fine, int scale, const std::vector<EdgeChain>& chains,
                        const JumpsFound& jumps, const ConstraintsPlaced& placed) {
    Image picture(fine.width, fine.height);
    for (std::size_t i = 0; i < fine.pixels.size(); ++i) {
        const glm::vec3& c = fine.pixels[i];
        picture.pixels[i] =
            glm::vec3(decode_srgb(.5f + .5f * (.3f * c.x + .59f * c.y + .11f * c.z)));
    }
    const auto dot = [&](glm::dvec2 p, int radius, const glm::vec3& paint) {
        const int x = static_cast<int>(p.x * scale), y = static_cast<int>(p.y * scale);
        for (int j = y - radius; j <= y + radius; ++j)
            for (int i = x - radius; i <= x + radius; ++i)
                if (i >= 0 && j >= 0 && i < picture.width && j < picture.height)
                    picture.at(i, j) = paint;
    };
    for (const EdgeChain& chain : chains)
        walk(chain, .5 / scale,
             [&](glm::dvec2 p, glm::dvec2, double) { dot(p, 0, constraint_paint); });
    for (const glm::dvec2& p : placed.misplaced) dot(p, 1, misplaced_paint);
    for (const glm::dvec2& p : jumps.missed) dot(p, 1, missed_paint);
    return picture;
}

}  // namespace povpreview
