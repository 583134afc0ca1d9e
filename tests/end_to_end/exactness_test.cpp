// SPDX-License-Identifier: AGPL-3.0-or-later
//
// The tracer against stock POV-Ray, an independent program: samples of pixel centres, ordered in a
// random order, are the pixels of POV-Ray's own image.
#include <gtest/gtest.h>

#include "tests/end_to_end/image_of_samples.h"
#include "tests/end_to_end/scenes.h"

namespace povpreview {
namespace {

class ExactnessTest : public testing::TestWithParam<scenes::SmallScene> {
   protected:
    void SetUp() override {
        if (real_tracer().empty()) GTEST_SKIP() << "no tracer: POVPREVIEW_TRACER is not set";
    }
};

TEST_P(ExactnessTest, SamplesAreThePixelsOfStockPovray) {
    const WorkFolder folder;
    const std::vector<std::string> words{folder.write("scene.pov", GetParam().text), "+W96", "+H72",
                                         "+WT1"};
    constexpr unsigned seed = 1;
    RecordProperty("seed", static_cast<int>(seed));
    const TracedImage image = trace_pixels(words, RayKind::full, Parts::colour, seed);
    const Difference difference = compare_with_stock(image, words, folder);
    EXPECT_EQ(difference.failed, 0U);
    EXPECT_EQ(difference.differing, 0U)
        << "worst " << difference.worst << ", rmse " << difference.root_mean_square;
    EXPECT_LE(difference.worst, 1);
}

INSTANTIATE_TEST_SUITE_P(Still, ExactnessTest, testing::ValuesIn(scenes::still),
                         [](const auto& scene) { return scene.param.name; });

}  // namespace
}  // namespace povpreview
