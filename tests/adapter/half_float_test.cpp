// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Half floats by their definition: all of them are found again, and what lies between goes to the
// nearer.
#include "backend/oracle/half_float.h"

#include <gtest/gtest.h>

#include <limits>

namespace povpreview::tracer {
namespace {

double value_of(std::uint16_t bits) {
    const int exponent = bits >> 10 & 31, digits = bits & 1023;
    const double size =
        exponent == 0 ? std::ldexp(digits, -24) : std::ldexp(digits + 1024, exponent - 25);
    return bits & 0x8000 ? -size : size;
}

TEST(HalfFloat, EveryOneIsFoundAgain) {
    for (std::uint32_t bits = 0; bits < 0x7c00; ++bits) {
        ASSERT_EQ(half_float(static_cast<float>(value_of(static_cast<std::uint16_t>(bits)))), bits);
        const auto negative = static_cast<std::uint16_t>(bits | 0x8000);
        ASSERT_EQ(half_float(static_cast<float>(value_of(negative))), negative);
    }
}

TEST(HalfFloat, BetweenTwoTheNearerIsTakenAndInTheMiddleTheEvenOne) {
    for (std::uint16_t bits = 0; bits + 1 < 0x7c00; ++bits) {
        const double low = value_of(bits), high = value_of(static_cast<std::uint16_t>(bits + 1));
        const auto at = [&](double t) {
            return half_float(static_cast<float>(low + t * (high - low)));
        };
        ASSERT_EQ(at(.49), bits);
        ASSERT_EQ(at(.51), bits + 1);
        ASSERT_EQ(at(.5), bits + (bits & 1));
    }
}

TEST(HalfFloat, WhatIsTooLargeOrNoNumberStaysFinite) {
    using Limits = std::numeric_limits<float>;
    EXPECT_EQ(half_float(1e9f), 0x7bff);
    EXPECT_EQ(half_float(-Limits::infinity()), 0xfbff);
    EXPECT_EQ(half_float(Limits::quiet_NaN()), 0);
    EXPECT_EQ(half_float(Limits::denorm_min()), 0);
}

}  // namespace
}  // namespace povpreview::tracer
