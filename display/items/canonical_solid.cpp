// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/items/canonical_solid.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

namespace povpreview::items {

namespace {

/// An axis of a quadric that is less curved than this, relative to its largest coefficient at the
/// size of its object, is taken for straight: its centre would be so far away that more were lost
/// in 32 bits.
constexpr double hardly_curved = 1e-4;

glm::dmat3 linear_part_of(const glm::dmat4x3& m) { return {m[0], m[1], m[2]}; }

/// Eigenvectors, as columns, of a symmetric matrix, which is left with its eigenvalues on the
/// diagonal (Jacobi's rotations).
glm::dmat3 diagonalise(glm::dmat3& m) {
    glm::dmat3 vectors(1);
    for (int sweep = 0; sweep < 30; ++sweep) {
        const double off = std::fabs(m[0][1]) + std::fabs(m[0][2]) + std::fabs(m[1][2]);
        if (!(off > 0)) break;
        for (int p = 0; p < 2; ++p) {
            for (int q = p + 1; q < 3; ++q) {
                if (m[p][q] == 0) continue;
                const double theta = (m[q][q] - m[p][p]) / (2 * m[p][q]);
                const double t = (theta < 0 ? -1 : 1) / (std::fabs(theta) + std::hypot(theta, 1));
                const double c = 1 / std::hypot(t, 1), s = t * c;
                glm::dmat3 rotation(1);
                rotation[p][p] = rotation[q][q] = c;
                rotation[q][p] = s, rotation[p][q] = -s;
                m = glm::transpose(rotation) * m * rotation;
                m[p][q] = m[q][p] = 0;
                vectors = vectors * rotation;
            }
        }
    }
    return vectors;
}

}  // namespace

CanonicalSolid::CanonicalSolid(const Solid& solid, const glm::dvec3& centre, double size) {
    linear_part = size * linear_part_of(solid.to_frame);
    offset = linear_part_of(solid.to_frame) * centre + solid.to_frame[3];
    switch (solid.kind) {
        case Solid::Kind::half_space:
            slope = 1;
            break;
        case Solid::Kind::sphere:
            signs = {1, 1, 1}, constant = -1;
            break;
        case Solid::Kind::cylinder:
            signs = {1, 1, 0}, constant = -1;
            break;
        case Solid::Kind::cone:
            signs = {1, 1, -1};
            break;
        case Solid::Kind::quadric:
            set_quadric(solid);
            break;
        case Solid::Kind::torus:
            torus = true, constant = solid.coefficients[0];
            break;
    }
}

bool CanonicalSolid::valid() const {
    double sum = constant + slope;
    for (int i = 0; i < 3; ++i) sum += glm::dot(linear_part[i], glm::dvec3(1)) + offset[i];
    return std::isfinite(sum);
}

/// With f = q' S q + l . q + k and S = V diag(e) V', y = V' q:
///
///     f = sum of e_i (y_i + (V' l)_i / 2 e_i)^2 where e_i != 0, + the rest of l . q + k'
void CanonicalSolid::set_quadric(const Solid& solid) {
    const auto& c = solid.coefficients;
    const glm::dmat3 s(c[0], c[3] / 2, c[4] / 2, c[3] / 2, c[1], c[5] / 2, c[4] / 2, c[5] / 2,
                       c[2]);
    const glm::dvec3 l(c[6], c[7], c[8]);
    // In units of the object, around its centre.
    glm::dmat3 square = glm::transpose(linear_part) * s * linear_part;
    glm::dvec3 straight = glm::transpose(linear_part) * (2. * s * offset + l);
    double rest = glm::dot(offset, s * offset) + glm::dot(l, offset) + c[9];
    double largest = std::fabs(rest);
    for (int i = 0; i < 3; ++i) {
        largest = std::max(largest, std::fabs(straight[i]));
        for (int j = 0; j < 3; ++j) largest = std::max(largest, std::fabs(square[i][j]));
    }
    square /= largest, straight /= largest, rest /= largest;

    const glm::dmat3 axes = diagonalise(square);
    glm::dvec3 rows[3] = {}, shifts{0}, left_over{0};
    int curved = 0;
    for (int i = 0; i < 3; ++i) {
        const double curvature = square[i][i], along = glm::dot(axes[i], straight);
        if (!(std::fabs(curvature) > hardly_curved)) {
            left_over += along * axes[i];
            continue;
        }
        const double scale = std::sqrt(std::fabs(curvature));
        rows[curved] = scale * axes[i];
        shifts[curved] = scale * along / (2 * curvature);
        signs[curved] = curvature < 0 ? -1 : 1;
        rest -= along * along / (4 * curvature);
        ++curved;
    }
    if (curved < 3) rows[2] = left_over, slope = 1;
    linear_part = glm::transpose(glm::dmat3(rows[0], rows[1], rows[2]));
    offset = shifts;
    constant = rest;
}

}  // namespace povpreview::items
