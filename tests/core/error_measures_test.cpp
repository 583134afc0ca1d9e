// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/error_measures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "core/colour.h"

namespace povpreview {
namespace {

using Image = std::vector<glm::vec3>;

TEST(ErrorMeasures, EqualImagesHaveNone) {
    const Image linear{{.1f, .2f, .3f}, {0, 1, .5f}, {2, -1, .04f}};
    Image encoded;
    for (const glm::vec3& c : linear) encoded.push_back(display_encoded(c));
    const ErrorMeasures error = measure_error(linear, encoded);
    EXPECT_EQ(error.l1, 0);
    EXPECT_EQ(error.rmse, 0);
    EXPECT_EQ(measure_error({}, {}).l1, 0);
}

TEST(ErrorMeasures, BlackAgainstWhiteIsOne) {
    const ErrorMeasures error = measure_error(Image(5, glm::vec3(0)), Image(5, glm::vec3(1)));
    EXPECT_EQ(error.l1, 1);
    EXPECT_EQ(error.rmse, 1);
}

TEST(ErrorMeasures, AveragesPixelsAndChannelsOfEncodedColour) {
    // Encoded, linear .2140411 is .5 (IEC 61966-2-1): one channel of six is off by .5.
    const Image linear{{.2140411f, 0, 0}, {0, 0, 0}};
    const ErrorMeasures error = measure_error(linear, Image(2, glm::vec3(0)));
    EXPECT_NEAR(error.l1, .5 / 6, 1e-6);
    EXPECT_NEAR(error.rmse, std::sqrt(.25 / 6), 1e-6);
}

TEST(ErrorMeasures, ClampsAsADisplayWould) {
    const Image linear{{7, -3, 1}};
    EXPECT_EQ(measure_error(linear, Image{{1, 0, 1}}).l1, 0);
}

TEST(ErrorMeasures, WhatIsNotFiniteIsTheWorstErrorOnEitherSide) {
    const float nan = std::nanf(""), inf = std::numeric_limits<float>::infinity();
    // Shown, infinity is white and not-a-number black; neither counts as right.
    EXPECT_EQ(measure_error(Image{{nan, inf, -inf}}, Image{{0, 1, 0}}).l1, 1);
    EXPECT_EQ(measure_error(Image{{0, 0, 0}}, Image{{nan, inf, -inf}}).rmse, 1);
    EXPECT_NEAR(measure_error(Image{{nan, 0, 0}}, Image{{0, 0, 0}}).l1, 1. / 3, 1e-12);
}

TEST(ErrorMeasures, IsAMetricOfEncodedColour) {
    // Decoding is undone by encoding within the precision of floats, over the whole range.
    for (int i = 0; i <= 1000; ++i) {
        const float e = float(i) / 1000;
        EXPECT_NEAR(encode_srgb(decode_srgb(e)), e, 2e-6);
    }
}

}  // namespace
}  // namespace povpreview
