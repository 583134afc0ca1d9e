// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "core/image_edge.h"

namespace povpreview {

/// Cells of one pixel, each with what lies in it: answers what is near a point without looking at
/// everything.
class Cells {
   public:
    explicit Cells(glm::ivec2 size);

    void add(glm::dvec2 p, std::uint32_t what);
    /// Calls f(what) for all that was added at points up to a pixel away, and for some farther
    /// ones.
    template <class F>
    void for_each_near(glm::dvec2 p, const F& f) const {
        const glm::ivec2 c = cell(p);
        for (int y = c.y - 1; y <= c.y + 1; ++y)
            for (int x = c.x - 1; x <= c.x + 1; ++x)
                if (x >= 0 && y >= 0 && x < size_.x && y < size_.y)
                    for (const std::uint32_t what : cells_[std::size_t(y) * size_.x + x]) f(what);
    }

   private:
    glm::ivec2 cell(glm::dvec2 p) const;
    glm::ivec2 size_;
    std::vector<std::vector<std::uint32_t>> cells_;
};

/// Points, in pixels of the picture.
class NearPoints {
   public:
    NearPoints(std::span<const glm::dvec2> points, glm::ivec2 size);
    /// Whether there is a point within `radius`, at most 1, of p.
    bool within(glm::dvec2 p, double radius) const;

   private:
    std::vector<glm::dvec2> points_;
    Cells cells_;
};

/// The segments of chains, in pixels of the picture.
class NearSegments {
   public:
    explicit NearSegments(glm::ivec2 size) : cells_(size) {}
    void add(const EdgeChain& chain);
    /// Whether a segment passes within `radius`, at most .7, of p.
    bool within(glm::dvec2 p, double radius) const;

   private:
    struct Segment {
        glm::dvec2 from, to;
    };
    std::vector<Segment> segments_;
    Cells cells_;
};

/// Calls f(p, along) every `step` pixels on a chain, in the middle of each step; `along` is the
/// unit vector of its direction, and `length` what the step stands for.
template <class F>
void walk(const EdgeChain& chain, double step, const F& f) {
    for (std::size_t i = 1; i < chain.vertices.size(); ++i) {
        const glm::dvec2 a = chain.vertices[i - 1], d = chain.vertices[i] - a;
        const double length = std::sqrt(d.x * d.x + d.y * d.y);
        if (!(length > 0)) continue;
        const int steps = std::max(1, static_cast<int>(std::ceil(length / step)));
        for (int k = 0; k < steps; ++k) f(a + d * ((k + .5) / steps), d / length, length / steps);
    }
}

}  // namespace povpreview
