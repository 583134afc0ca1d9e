// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/colour.h"
#include "core/picture.h"

namespace povpreview {

/// The picture's linear colour at every pixel centre, in plain software: what the display shows at
/// one sample per pixel, without GL.
inline std::vector<glm::vec3> rasterise(const Picture& picture) {
    const int w = picture.width, h = picture.height;
    std::vector<glm::vec3> image(static_cast<std::size_t>(w) * static_cast<std::size_t>(h),
                                 glm::vec3(-1));
    for (std::size_t i = 0; i + 2 < picture.corners.size(); i += 3) {
        const auto &a = picture.corners[i], &b = picture.corners[i + 1],
                   &c = picture.corners[i + 2];
        const auto cross = [](glm::dvec2 p, glm::dvec2 q, glm::dvec2 r) {
            return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
        };
        const glm::dvec2 p(a.position), q(b.position), r(c.position);
        const double area = cross(p, q, r);
        if (area == 0) continue;  // as GL does
        const int x0 = std::max(0, int(std::floor(std::min({p.x, q.x, r.x}))));
        const int x1 = std::min(w - 1, int(std::ceil(std::max({p.x, q.x, r.x}))));
        const int y0 = std::max(0, int(std::floor(std::min({p.y, q.y, r.y}))));
        const int y1 = std::min(h - 1, int(std::ceil(std::max({p.y, q.y, r.y}))));
        for (int y = y0; y <= y1; ++y)
            for (int x = x0; x <= x1; ++x) {
                const glm::dvec2 s(x + .5, y + .5);
                const double u = cross(q, r, s) / area, v = cross(r, p, s) / area, t = 1 - u - v;
                if (u < -1e-9 || v < -1e-9 || t < -1e-9) continue;
                image[static_cast<std::size_t>(y * w + x)] =
                    float(u) * a.colour + float(v) * b.colour + float(t) * c.colour;
            }
    }
    for (std::size_t i = 0; i < picture.known.size(); ++i)
        if (picture.known[i]) image[i] = picture.pixels[i];
    return image;
}

}  // namespace povpreview
