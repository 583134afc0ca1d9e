// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cassert>

/// Squares cut into right triangles that are halved again and again, each in the middle of its
/// hypotenuse. Two triangles on one hypotenuse make a diamond, which is halved as a whole, so that
/// no corner ever lies on another triangle's side:
///
///     o-------h       h-------o       o---h---o       o---o---o
///     |     / |       | \   / |       | \ | / |       | \ | / |
///     |   c   |  -->  c   a   c  -->  a---o---a  -->  o---o---o      c  centre of the next diamond
///     | /     |       | /   \ |       | c | c |       | / | \ |      h  ends of its hypotenuse
///     h-------o       h-------o       o---h---o       o---o---o      a  its apexes
///
/// All points have whole coordinates, not below 0. Each one but the corners of the first squares
/// is the centre of one diamond, which its coordinates alone tell: nothing is stored here.
namespace povpreview {

struct LatticePoint {
    int x, y;
    bool operator==(const LatticePoint&) const = default;
};

struct Diamond {
    /// Of the diamond around a point that is no corner of the first squares.
    explicit Diamond(LatticePoint at)
        : centre(at), reach((at.x | at.y) & -(at.x | at.y)), square((at.x & at.y & reach) != 0) {}

    LatticePoint centre;
    int reach;    ///< from the centre to its left, right, upper and lower end
    bool square;  ///< else it stands on a corner

    /// Where the triangles' right angles are. The diamond is there when they are: its triangles
    /// come of halving the diamonds around them.
    std::array<LatticePoint, 2> apexes() const {
        const auto [x, y] = centre;
        if (square) return {LatticePoint{inner(x), outer(y)}, {outer(x), inner(y)}};
        if (is_level()) return {LatticePoint{x, y - reach}, {x, y + reach}};
        return {LatticePoint{x - reach, y}, {x + reach, y}};
    }
    std::array<LatticePoint, 2> hypotenuse() const {
        const auto [x, y] = centre;
        if (square) return {LatticePoint{inner(x), inner(y)}, {outer(x), outer(y)}};
        if (is_level()) return {LatticePoint{x - reach, y}, {x + reach, y}};
        return {LatticePoint{x, y - reach}, {x, y + reach}};
    }
    /// Diamonds that halving this one makes half of. REQUIRES: has_parts().
    std::array<LatticePoint, 4> parts() const {
        const auto [x, y] = centre;
        if (square)
            return {LatticePoint{x - reach, y}, {x + reach, y}, {x, y - reach}, {x, y + reach}};
        const int half = reach / 2;
        return {LatticePoint{x - half, y - half},
                {x + half, y - half},
                {x - half, y + half},
                {x + half, y + half}};
    }
    bool has_parts() const { return square || reach > 1; }

   private:
    /// The coordinate of the square's corner that lies in the midst of the square that it is a
    /// quarter of, and of the other one.
    int inner(int at) const { return ((at - reach) & (2 * reach)) != 0 ? at - reach : at + reach; }
    int outer(int at) const { return 2 * at - inner(at); }
    /// Standing on a corner: whether its hypotenuse is level.
    bool is_level() const { return (centre.x & reach) != 0; }
};

/// A triangle, half of a diamond.
struct HalvedTriangle {
    LatticePoint apex, first, second;

    /// Whether its hypotenuse has a middle.
    bool has_centre() const { return ((first.x + second.x) | (first.y + second.y)) % 2 == 0; }
    LatticePoint centre() const { return {(first.x + second.x) / 2, (first.y + second.y) / 2}; }
    std::array<HalvedTriangle, 2> halves() const {
        return {HalvedTriangle{centre(), first, apex}, HalvedTriangle{centre(), apex, second}};
    }
};

/// The halves of a diamond.
inline std::array<HalvedTriangle, 2> triangles(const Diamond& diamond) {
    const auto [first, second] = diamond.hypotenuse();
    const auto [one, other] = diamond.apexes();
    return {HalvedTriangle{one, first, second}, HalvedTriangle{other, first, second}};
}

}  // namespace povpreview
