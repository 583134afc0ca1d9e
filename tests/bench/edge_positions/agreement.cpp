// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/bench/edge_positions/agreement.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/edge_weight.h"

namespace povpreview {
namespace {

bool strong(const glm::vec3& a, const glm::vec3& b) {
    return colour_distance(a, b) >= float(strong_jump * strong_jump);
}

/// The fine pixel at a point of the picture.
glm::ivec2 fine_pixel(glm::dvec2 p, const Image& fine, int scale) {
    return glm::clamp(glm::ivec2(glm::floor(p * double(scale))), glm::ivec2(0),
                      glm::ivec2(fine.width - 1, fine.height - 1));
}

enum class Across { even, beside, off };

/// What lies across a constraint at p, from a pixel on one side to a pixel on the other:
///
///       p - normal |-------|---p---|--x----| p + normal      x: the jump
///
Across look_across(glm::dvec2 p, glm::dvec2 normal, const NearSegments& all, const Image& fine,
                   int scale) {
    const auto colour = [&](glm::dvec2 at) {
        const glm::ivec2 pixel = fine_pixel(at, fine, scale);
        return fine.at(pixel.x, pixel.y);
    };
    if (!strong(colour(p - normal), colour(p + normal))) return Across::even;
    Across result = Across::even;
    const int steps = 4 * scale;  // two to a fine pixel
    for (int k = 0; k < steps; ++k) {
        const glm::dvec2 a = p + normal * (2. * k / steps - 1);
        const glm::dvec2 b = p + normal * (2. * (k + 1) / steps - 1);
        if (!strong(colour(a), colour(b))) continue;
        if (!all.within((a + b) / 2., tolerance)) return Across::off;
        result = Across::beside;
    }
    return result;
}

}  // namespace

std::vector<glm::dvec2> strong_jumps(const Image& fine, int scale) {
    std::vector<glm::dvec2> jumps;
    for (int y = 0; y < fine.height; ++y)
        for (int x = 0; x < fine.width; ++x) {
            if (x + 1 < fine.width && strong(fine.at(x, y), fine.at(x + 1, y)))
                jumps.push_back(glm::dvec2(x + 1, y + .5) / double(scale));
            if (y + 1 < fine.height && strong(fine.at(x, y), fine.at(x, y + 1)))
                jumps.push_back(glm::dvec2(x + .5, y + 1) / double(scale));
        }
    return jumps;
}

JumpsFound find_jumps(const std::vector<glm::dvec2>& jumps, const NearSegments& constraints,
                      const std::function<bool(glm::dvec2)>& counts) {
    JumpsFound result;
    for (const glm::dvec2& jump : jumps) {
        if (counts && !counts(jump)) continue;
        ++result.jumps;
        if (constraints.within(jump, tolerance))
            ++result.found;
        else
            result.missed.push_back(jump);
    }
    return result;
}

ConstraintsPlaced place_constraints(const std::vector<EdgeChain>& chains, const NearSegments& all,
                                    const std::vector<glm::dvec2>& jumps, const Image& fine,
                                    int scale) {
    const NearPoints strong_ones(jumps, {fine.width / scale, fine.height / scale});
    ConstraintsPlaced result;
    for (const EdgeChain& chain : chains)
        walk(chain, .25, [&](glm::dvec2 p, glm::dvec2 along, double length) {
            if (strong_ones.within(p, tolerance)) {
                result.on += length;
                return;
            }
            switch (look_across(p, {-along.y, along.x}, all, fine, scale)) {
                case Across::even:
                    result.even += length;
                    break;
                case Across::beside:
                    result.beside += length;
                    break;
                case Across::off:
                    result.off += length;
                    result.misplaced.push_back(p);
                    break;
            }
        });
    return result;
}

}  // namespace povpreview
