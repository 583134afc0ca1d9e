// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/program/figures.h"

#include <gtest/gtest.h>

#include "core/mesh_previewer.h"

namespace povpreview {
namespace {

/// Samples that the previewer asks for before it has an answer to any, and fills no squares: its
/// grid.
std::size_t grid_of(const RegularGrid& grid, glm::ivec2 size) {
    MeshPreviewer previewer(size.x, size.y,
                            {.constraints = false,
                             .detail = false,
                             .lattice = false,
                             .grid_cell = grid.cell,
                             .dense = 2});
    std::size_t asked = 0;
    while (previewer.next()) ++asked;
    return asked;
}

TEST(RegularGrid, HasTheSamplesThatItSays) {
    for (const glm::ivec2 size : {glm::ivec2(640, 480), glm::ivec2(37, 400), glm::ivec2(97, 101)})
        for (const std::size_t samples : {4, 20, 100, 500, 900}) {
            const RegularGrid grid = regular_grid(samples, size);
            EXPECT_EQ(grid_of(grid, size), grid.samples) << size.x << " " << samples;
        }
}

TEST(RegularGrid, ComesCloseToTheSamplesWanted) {
    for (const std::size_t samples : {100, 500, 3072, 10000}) {
        const RegularGrid grid = regular_grid(samples, {640, 480});
        EXPECT_NEAR(double(grid.samples), double(samples), 3 * std::sqrt(double(samples)))
            << samples;
    }
}

TEST(RegularGrid, IsNeverFinerThanEveryOtherPixel) {
    EXPECT_LE(regular_grid(1000000, {100, 100}).samples, 51u * 51u);
}

}  // namespace
}  // namespace povpreview
