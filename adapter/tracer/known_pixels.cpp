// SPDX-License-Identifier: AGPL-3.0-or-later
#include "backend/oracle/known_pixels.h"

#include <cmath>
#include <limits>

namespace povpreview::tracer {

/// POV-Ray walks over sub-pixels by adding up steps, so its centre is off by rounding: in pixels.
constexpr double rounding = 1e-9;

void KnownPixels::set_size(unsigned width, unsigned height) {
    width_ = width;
    height_ = height;
}

bool KnownPixels::add(const FinishPart& part) {
    const std::size_t pixels = std::size_t{width_} * height_;
    if (part.first > pixels || part.light.size() > pixels - part.first) return false;
    const float unknown = std::numeric_limits<float>::quiet_NaN();
    if (light_.empty()) light_.resize(pixels, {{unknown, unknown, unknown}, unknown});
    for (std::size_t i = 0; i < part.light.size(); ++i) light_[part.first + i] = part.light[i];
    return true;
}

const FinishPart::Light* KnownPixels::find(double x, double y) const {
    const double column = std::round(x), row = std::round(y);
    if (light_.empty() || std::fabs(x - column) > rounding || std::fabs(y - row) > rounding ||
        column < 0 || row < 0 || column >= width_ || row >= height_)
        return nullptr;
    const auto& light =
        light_[static_cast<std::size_t>(row) * width_ + static_cast<std::size_t>(column)];
    return std::isfinite(light.colour.r) ? &light : nullptr;
}

}  // namespace povpreview::tracer
