// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/error_measures.h"

#include <cassert>
#include <cmath>
#include <cstddef>

#include "core/colour.h"

namespace povpreview {

ErrorMeasures measure_error(std::span<const glm::vec3> linear,
                            std::span<const glm::vec3> encoded_reference) {
    assert(linear.size() == encoded_reference.size());
    if (linear.empty()) return {};
    double sum = 0, sum_of_squares = 0;
    for (std::size_t i = 0; i < linear.size(); ++i) {
        for (int channel = 0; channel < 3; ++channel) {
            const float ours = linear[i][channel], truth = encoded_reference[i][channel];
            const bool measurable = std::isfinite(ours) && std::isfinite(truth);
            const double d = measurable ? double{display_encoded(ours)} - double{truth} : 1.;
            sum += std::abs(d);
            sum_of_squares += d * d;
        }
    }
    const double n = 3 * static_cast<double>(linear.size());
    return {sum / n, std::sqrt(sum_of_squares / n)};
}

}  // namespace povpreview
