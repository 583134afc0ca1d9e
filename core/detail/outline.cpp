// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/detail/outline.h"

#include <algorithm>
#include <glm/common.hpp>
#include <limits>

namespace povpreview {

Outline::Outline(std::span<const double> control_points)
    : low_(std::numeric_limits<double>::infinity()), high_(-low_) {
    for (std::size_t first = 0; first + outline_numbers_a_segment <= control_points.size();
         first += outline_numbers_a_segment) {
        Segment segment;
        for (std::size_t k = 0; k < 4; ++k) {
            segment.u[k] = control_points[first + 2 * k];
            segment.v[k] = control_points[first + 2 * k + 1];
        }
        const auto [u_low, u_high] = std::minmax_element(segment.u.begin(), segment.u.end());
        const auto [v_low, v_high] = std::minmax_element(segment.v.begin(), segment.v.end());
        segment.low = {*u_low, *v_low};
        segment.high = {*u_high, *v_high};
        low_ = glm::min(low_, segment.low);
        high_ = glm::max(high_, segment.high);
        segments_.push_back(segment);
    }
    const glm::dvec2 size = high_ - low_;
    slack_ = 1e-9 * std::max(size.x, size.y);
}

/// Counts the segments that cross the line from the point to the right.
///
///        __        of segments that end at its height, the end is taken for above: so of two that
///       /  \       meet there, one crosses or both or none, as the curve does
///    p-/----\--->
bool Outline::surrounds(const glm::dvec2& p) const {
    bool odd = false;
    for (const Segment& segment : segments_) {
        if (p.y < segment.low.y || p.y > segment.high.y || p.x > segment.high.x) continue;
        if (p.x < segment.low.x) {
            odd ^= (segment.v[0] < p.y) != (segment.v[3] < p.y);
            continue;
        }
        Bernstein<3> above = segment.v;
        for (double& v : above) v -= p.y;
        for (const double s : BernsteinRoots<3>(above)) odd ^= segment.at(s).x > p.x;
    }
    return odd;
}

double Outline::side(const glm::dvec2& p) const {
    const bool inside = surrounds(p);
    const double sure = inside ? -1 : 1;
    for (const Segment& segment : segments_) {
        if (p.x < segment.low.x - slack_ || p.x > segment.high.x + slack_ ||
            p.y < segment.low.y - slack_ || p.y > segment.high.y + slack_)
            continue;
        for (const glm::dvec2& step : {glm::dvec2(slack_, 0), glm::dvec2(-slack_, 0),
                                       glm::dvec2(0, slack_), glm::dvec2(0, -slack_)})
            if (surrounds(p + step) != inside) return 0;
        break;
    }
    return sure;
}

}  // namespace povpreview
