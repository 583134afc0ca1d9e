// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdint>

namespace povpreview::tracer {

/// The half float (IEEE 754 binary16) nearest to a value, ties to even; beyond the largest, the
/// largest; 0 for what is no number.
inline std::uint16_t half_float(float value) {
    constexpr int digits = 10, lowest_exponent = -14;
    constexpr double largest = 65504;
    if (std::isnan(value)) return 0;
    const std::uint16_t sign = std::signbit(value) ? 0x8000 : 0;
    const double size = std::fmin(std::fabs(static_cast<double>(value)), largest);
    int exponent = 0;
    std::frexp(size, &exponent);  // size in [2^(exponent - 1), 2^exponent)
    exponent = exponent - 1 < lowest_exponent || size == 0 ? lowest_exponent : exponent - 1;
    // In units of the last digit; a carry runs over into the exponent, as it should.
    const auto units =
        static_cast<std::uint32_t>(std::nearbyint(std::ldexp(size, digits - exponent)));
    const std::uint32_t hidden = std::uint32_t{1} << digits;
    const std::uint32_t biased = units < hidden ? 0 : static_cast<std::uint32_t>(exponent + 15);
    return static_cast<std::uint16_t>(
        sign | (units < hidden ? units : (biased << digits) + (units - hidden)));
}

}  // namespace povpreview::tracer
