// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/filling_order.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numeric>

#include "core/bf_squares.h"
#include "core/edge_weight.h"
#include "core/mesh.h"

namespace povpreview {
namespace {

/// The contrast across each face, over its area. A face that spans several squares counts for each
/// of those in its box.
void add_face_errors(const Mesh& mesh, const BfSquares& squares, std::vector<double>& errors) {
    const Triangulation& t = mesh.triangulation();
    t.for_each_face([&](VertexId a, VertexId b, VertexId c) {
        const auto step = [&](VertexId p, VertexId q) {
            return std::sqrt(mesh.contrast(p, q).value_or(0));
        };
        const double contrast = std::max({step(a, b), step(b, c), step(c, a)});
        const glm::dvec2 p = t.position(a), q = t.position(b), r = t.position(c);
        const double area = ((q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x)) / 2;
        const glm::dvec2 low = glm::min(glm::min(p, q), r), high = glm::max(glm::max(p, q), r);
        const std::size_t first = squares.square_of(squares.pixel_at(low));
        const std::size_t last = squares.square_of(squares.pixel_at(high));
        const auto columns = static_cast<std::size_t>(squares.columns());
        const std::size_t across = last % columns - first % columns + 1;
        const std::size_t down = last / columns - first / columns + 1;
        const double share = contrast * area / static_cast<double>(across * down);
        for (std::size_t j = 0; j < down; ++j)
            for (std::size_t i = 0; i < across; ++i) errors[first + j * columns + i] += share;
    });
}

/// Beside a constraint the pixels are uncertain by its position error: a strip that is wrong by the
/// jump across it.
void add_outline_errors(const Mesh& mesh, const BfSquares& squares, std::vector<double>& errors) {
    constexpr double strip = .2;  // width in pixels: the mean error of a traced outline, both sides
    const Triangulation& t = mesh.triangulation();
    t.for_each_edge([&](VertexId a, VertexId b, bool constrained) {
        if (!constrained) return;
        const SampleId p = mesh.corner(a, b, true), q = mesh.corner(a, b, false);
        if (!p.valid() || !q.valid()) return;
        const double jump =
            std::sqrt(colour_distance(mesh.sample(p).encoded, mesh.sample(q).encoded));
        const glm::dvec2 from = t.position(a), step = t.position(b) - from;
        const int pieces = static_cast<int>(std::ceil(glm::length(step)));
        for (int i = 0; i < pieces; ++i) {
            const Pixel pixel = squares.pixel_at(from + step * ((i + .5) / pieces));
            errors[squares.square_of(pixel)] += strip * jump * glm::length(step) / pieces;
        }
    });
}

/// For each square, what is wrong there against the pixels that are still to be traced.
std::vector<double> expected_errors(const Mesh& mesh, const BfSquares& squares) {
    std::vector<double> errors(squares.squares());
    add_face_errors(mesh, squares, errors);
    add_outline_errors(mesh, squares, errors);
    for (std::size_t square = 0; square < errors.size(); ++square)
        errors[square] /= std::max(1, squares.area(square) - squares.count(square));
    return errors;
}

}  // namespace

std::vector<std::size_t> filling_order(const Mesh& mesh, const BfSquares& squares) {
    const std::vector<double> errors = expected_errors(mesh, squares);
    std::vector<std::size_t> order(squares.squares());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t p, std::size_t q) { return errors[p] < errors[q]; });
    return order;
}

}  // namespace povpreview
