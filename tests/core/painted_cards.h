// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <random>
#include <vector>

#include "core/image_edge.h"
#include "tests/core/function_oracle.h"

namespace povpreview {

/// Cards thrown on a table, each with a colour of its own that changes smoothly over it: an image
/// whose every discontinuity is known exactly.
class PaintedCards {
   public:
    PaintedCards(glm::dvec2 size, int count, unsigned seed, double largest = .3)
        : size_(size), random_(seed) {
        std::uniform_real_distribution<double> unit(0, 1);
        for (int i = 0; i < count; ++i) {
            Card card;
            const double most = largest * std::max(size.x, size.y);
            // Few are large; the last ones, on top, are small.
            const double share = std::pow(1 - double(i) / count, 2) + .04;
            const double a = 2 * std::numbers::pi * unit(random_);
            const glm::dvec2 u = glm::dvec2(std::cos(a), std::sin(a)), v(-u.y, u.x);
            const double w = most * share * (.3 + .7 * unit(random_)), h = w * (.2 + unit(random_));
            const glm::dvec2 centre = size * glm::dvec2(unit(random_), unit(random_));
            card.corners = {centre - w * u - h * v, centre + w * u - h * v, centre + w * u + h * v,
                            centre - w * u + h * v};
            for (int k = 0; k < 3; ++k) {
                card.colour[k] = static_cast<float>(.05 + .6 * unit(random_));
                card.slope[k] = glm::dvec2(unit(random_) - .5, unit(random_) - .5) * (.6 / size.x);
            }
            cards_.push_back(card);
        }
    }

    FunctionImage image() const {
        return {[*this](glm::dvec2 p) {
                    const std::uint32_t top = surface(p);
                    if (top == 1) return glm::vec3(.3f, float(.2 + .2 * p.x / size_.x), .2f);
                    const Card& card = cards_[top - 2];
                    glm::vec3 colour = card.colour;
                    for (int k = 0; k < 3; ++k)
                        colour[k] += float(glm::dot(card.slope[k], p - card.corners[0]));
                    return glm::max(colour, glm::vec3(.01f));
                },
                [*this](glm::dvec2 p) { return surface(p); }};
    }

    /// The visible part of every card's border.
    std::vector<ImageEdge> edges() const {
        std::vector<ImageEdge> found;
        for (std::size_t c = 0; c < cards_.size(); ++c)
            for (std::size_t i = 0; i < 4; ++i) {
                const glm::dvec2 a = cards_[c].corners[i], b = cards_[c].corners[(i + 1) % 4];
                for (const auto& [s, t] : visible(a, b, c))
                    found.push_back({a + s * (b - a), a + t * (b - a), EdgeKind::geometric, 0, .5});
            }
        return found;
    }

    /// The same, as finders give them: cut into fragments at random, some of them twice, in no
    /// order, some turned round.
    std::vector<ImageEdge> fragments(unsigned seed) const {
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> unit(0, 1);
        std::vector<ImageEdge> pieces;
        for (const ImageEdge& edge : edges()) {
            std::vector<double> cuts{0, 1};
            while (unit(random) < .7) cuts.push_back(unit(random));
            std::sort(cuts.begin(), cuts.end());
            for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
                ImageEdge piece = edge;
                piece.from = edge.from + cuts[i] * (edge.to - edge.from);
                piece.to = edge.from + cuts[i + 1] * (edge.to - edge.from);
                if (unit(random) < .5) std::swap(piece.from, piece.to);
                pieces.push_back(piece);
                if (unit(random) < .1) {
                    piece.to = piece.from + unit(random) * (piece.to - piece.from);
                    pieces.push_back(piece);
                }
            }
        }
        std::shuffle(pieces.begin(), pieces.end(), random);
        return pieces;
    }

   private:
    struct Card {
        std::array<glm::dvec2, 4> corners;  // counter-clockwise
        glm::vec3 colour;
        std::array<glm::dvec2, 3> slope;  // of each channel
    };
    using Spans = std::vector<std::pair<double, double>>;

    static double side(glm::dvec2 a, glm::dvec2 b, glm::dvec2 p) {
        return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
    }
    std::uint32_t surface(glm::dvec2 p) const {
        for (std::size_t c = cards_.size(); c-- > 0;) {
            const auto& k = cards_[c].corners;
            bool inside = true;
            for (std::size_t i = 0; i < 4; ++i)
                inside = inside && side(k[i], k[(i + 1) % 4], p) >= 0;
            if (inside) return static_cast<std::uint32_t>(c + 2);
        }
        return 1;
    }
    /// The parts of a-b, as shares of its length, that no card above `c` hides.
    Spans visible(glm::dvec2 a, glm::dvec2 b, std::size_t c) const {
        Spans open{{0, 1}};
        for (std::size_t above = c + 1; above < cards_.size(); ++above) {
            const auto& k = cards_[above].corners;
            double enter = 0, leave = 1;
            for (std::size_t i = 0; i < 4; ++i) {
                const double s = side(k[i], k[(i + 1) % 4], a), t = side(k[i], k[(i + 1) % 4], b);
                if (s < 0 && t < 0) leave = -1;
                if (s < 0 && t >= 0) enter = std::max(enter, s / (s - t));
                if (s >= 0 && t < 0) leave = std::min(leave, s / (s - t));
            }
            if (enter >= leave) continue;
            Spans rest;
            for (const auto& [s, t] : open) {
                if (s < enter) rest.emplace_back(s, std::min(t, enter));
                if (t > leave) rest.emplace_back(std::max(s, leave), t);
            }
            open = rest;
        }
        return open;
    }

    glm::dvec2 size_;
    std::mt19937 random_;
    std::vector<Card> cards_;
};

}  // namespace povpreview
