// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cmath>
#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/vec3.hpp>

/// Display encoding by the sRGB curve (IEC 61966-2-1), with the constants and in the precision that
/// POV-Ray 3.7 uses for its files. Done once, at display, in error measures and in weights;
/// everywhere else colours are linear light.
namespace povpreview {

/// Linear light to the sRGB curve; unclamped, and straight on below 0.
inline float encode_srgb(float linear) {
    return linear <= 0.0031308f ? linear * 12.92f : 1.055f * std::pow(linear, 1 / 2.4f) - 0.055f;
}

inline glm::vec3 encode_srgb(const glm::vec3& linear) {
    return {encode_srgb(linear.x), encode_srgb(linear.y), encode_srgb(linear.z)};
}

/// The inverse of encode_srgb.
inline float decode_srgb(float encoded) {
    return encoded < 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}

/// What a display can show of a channel of linear light: encoded, in [0, 1]; 0 for not-a-number.
inline float display_encoded(float linear) {
    if (!(linear > 0)) return 0;
    return linear >= 1 ? 1 : encode_srgb(linear);
}

inline glm::vec3 display_encoded(const glm::vec3& linear) {
    return {display_encoded(linear.x), display_encoded(linear.y), display_encoded(linear.z)};
}

/// As display_encoded(), within .05; weights need no more.
inline glm::vec3 roughly_encoded(const glm::vec3& linear) {
    return glm::sqrt(glm::clamp(linear, 0.f, 1.f));
}

/// Whether a colour, or any three numbers, can be reckoned with.
inline bool finite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

}  // namespace povpreview
