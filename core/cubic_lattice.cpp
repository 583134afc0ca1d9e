// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/cubic_lattice.h"

#include <algorithm>
#include <cassert>

namespace povpreview {

std::vector<CubicWeights> cubic_weights(std::span<const int> lattice, std::span<const int> places) {
    assert(!lattice.empty());
    const std::size_t last = lattice.size() - 1;
    std::vector<CubicWeights> result;
    result.reserve(places.size());
    std::size_t p = 0;  // the lattice point at the place or before it
    for (const int place : places) {
        while (p < last && lattice[p + 1] <= place) ++p;
        if (lattice[p] == place) {
            result.push_back({{p, p, p, p}, {0, 1, 0, 0}});
            continue;
        }
        assert(p < last && lattice[p] < place);
        const auto h = float(lattice[p + 1] - lattice[p]);
        const float t = float(place - lattice[p]) / h, t2 = t * t, t3 = t2 * t;
        // Hermite's basis: the values at both ends, and the slopes there times the piece's length.
        float first = 2 * t3 - 3 * t2 + 1, second = 3 * t2 - 2 * t3;
        const float first_slope = t3 - 2 * t2 + t, second_slope = t3 - t2;
        const std::size_t before = p > 0 ? p - 1 : p, after = p + 2 <= last ? p + 2 : p + 1;
        const float u = first_slope * h / float(lattice[p + 1] - lattice[before]);
        const float v = second_slope * h / float(lattice[after] - lattice[p]);
        result.push_back({{before, p, p + 1, after}, {-u, first - v, second + u, v}});
    }
    return result;
}

namespace {

/// to[i] = the weighted sum of four rows of floats: plain arrays, for the compiler to vectorise.
void blend_rows(const float* a, const float* b, const float* c, const float* d,
                const std::array<float, 4>& w, float* to, std::size_t n) {
    for (std::size_t i = 0; i < n; ++i) {
        to[i] = w[0] * a[i] + w[1] * b[i] + w[2] * c[i] + w[3] * d[i];
    }
}

}  // namespace

std::vector<glm::vec3> interpolate(const Lattice& lattice, std::span<const int> columns,
                                   std::span<const int> rows) {
    static_assert(sizeof(glm::vec3) == 3 * sizeof(float));
    const std::size_t across = lattice.columns.size(), wide = columns.size();
    std::vector<glm::vec3> stretched(lattice.rows.size() * wide);
    const std::vector<CubicWeights> along_x = cubic_weights(lattice.columns, columns);
    for (std::size_t j = 0; j < lattice.rows.size(); ++j) {
        const glm::vec3* from = &lattice.values[j * across];
        for (std::size_t i = 0; i < wide; ++i) {
            const auto& [k, w] = along_x[i];
            stretched[j * wide + i] = k[0] == k[3] ? from[k[1]]
                                                   : w[0] * from[k[0]] + w[1] * from[k[1]] +
                                                         w[2] * from[k[2]] + w[3] * from[k[3]];
        }
    }
    std::vector<glm::vec3> result(rows.size() * wide);
    const std::vector<CubicWeights> along_y = cubic_weights(lattice.rows, rows);
    for (std::size_t j = 0; j < rows.size(); ++j) {
        const auto& [k, w] = along_y[j];
        const auto row = [&, &k = k](std::size_t r) { return &stretched[k[r] * wide].x; };
        float* to = &result[j * wide].x;
        if (k[0] == k[3]) {
            std::copy_n(row(1), 3 * wide, to);
        } else {
            blend_rows(row(0), row(1), row(2), row(3), w, to, 3 * wide);
        }
    }
    return result;
}

}  // namespace povpreview
