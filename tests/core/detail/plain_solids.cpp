// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/core/detail/plain_solids.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <glm/glm.hpp>

namespace povpreview::test {

namespace {

struct Chord {
    glm::dvec2 a, b;
};

/// `wanted`: whether a segment matters, by its control points.
template <class Wanted>
std::vector<Chord> chords_of(const DrawableScene& scene, const Solid& solid, const Wanted& wanted) {
    constexpr int chords_a_segment = 100;
    std::vector<Chord> chords;
    for (std::uint32_t first = 0; first < solid.numbers; first += outline_numbers_a_segment) {
        const double* n = &scene.numbers[solid.first_number + first];
        if (!wanted(std::array{glm::dvec2(n[0], n[1]), glm::dvec2(n[2], n[3]),
                               glm::dvec2(n[4], n[5]), glm::dvec2(n[6], n[7])}))
            continue;
        const auto at = [n](int i) {
            const double t = double(i) / chords_a_segment, s = 1 - t;
            const double w[4] = {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
            glm::dvec2 p(0);
            for (int k = 0; k < 4; ++k) p += w[k] * glm::dvec2(n[2 * k], n[2 * k + 1]);
            return p;
        };
        for (int i = 0; i < chords_a_segment; ++i) chords.push_back({at(i), at(i + 1)});
    }
    return chords;
}

using ControlPoints = std::array<glm::dvec2, 4>;

double side_of(const DrawableScene& scene, const Solid& solid, const glm::dvec2& p) {
    const auto may_cross = [&p](const ControlPoints& points) {
        bool above = false, below = false, right = false;
        for (const glm::dvec2& q : points) {
            above = above || q.y >= p.y;
            below = below || q.y <= p.y;
            right = right || q.x >= p.x;
        }
        return above && below && right;
    };
    bool inside = false;
    for (const auto& [a, b] : chords_of(scene, solid, may_cross))
        if ((a.y < p.y) != (b.y < p.y))
            inside ^= a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x) > p.x;
    return inside ? -1 : 1;
}

/// The wall above a chord: points whose projection by z (or by the apex) lies on it.
void add_wall_roots(const Chord& chord, bool conic, const glm::dvec3& o, const glm::dvec3& d,
                    std::vector<double>& roots) {
    const glm::dvec3 a(chord.a, 1), b(chord.b, 1), normal = glm::cross(a, b);
    // Through a, b and the direction of z, or through a, b and the apex.
    const glm::dvec2 across(chord.b.y - chord.a.y, chord.a.x - chord.b.x);
    const double t =
        conic ? -glm::dot(normal, o) / glm::dot(normal, d)
              : glm::dot(across, chord.a - glm::dvec2(o)) / glm::dot(across, glm::dvec2(d));
    const glm::dvec3 p = o + t * d;
    const glm::dvec2 q = conic ? glm::dvec2(p) / p.z : glm::dvec2(p), ab = chord.b - chord.a;
    const double share = glm::dot(q - chord.a, ab) / glm::dot(ab, ab);
    if (share >= 0 && share < 1) roots.push_back(t);
}

/// The ring that a chord makes around z: a part of a cone, x^2 + y^2 = (u + slope (z - v))^2.
void add_ring_roots(const Chord& chord, const glm::dvec3& o, const glm::dvec3& d,
                    std::vector<double>& roots) {
    const double height = chord.b.y - chord.a.y;
    const auto add = [&](double t) {
        const glm::dvec3 p = o + t * d;
        const glm::dvec2 q(std::hypot(p.x, p.y), p.z), ab = chord.b - chord.a;
        const double share = glm::dot(q - chord.a, ab) / glm::dot(ab, ab);
        // Not where the cone goes on beyond its apex.
        const bool on_chord = glm::distance(q, chord.a + share * ab) < 1e-6;
        if (share >= 0 && share < 1 && on_chord) roots.push_back(t);
    };
    if (std::fabs(height) < 1e-12) return add((chord.a.y - o.z) / d.z);
    const double slope = (chord.b.x - chord.a.x) / height,
                 u = chord.a.x + slope * (o.z - chord.a.y), du = slope * d.z;
    const double a = d.x * d.x + d.y * d.y - du * du, b = o.x * d.x + o.y * d.y - u * du,
                 c = o.x * o.x + o.y * o.y - u * u, square = b * b - a * c;
    if (square < 0) return;
    const double q = -(b + std::copysign(std::sqrt(square), b));
    add(q / a);
    add(c / q);
}

double field(const DrawableScene& scene, const Solid& solid, const glm::dvec3& p) {
    double sum = 0;
    for (std::uint32_t first = 1; first < solid.numbers; first += blob_numbers_a_component) {
        const double* n = &scene.numbers[solid.first_number + first];
        glm::dvec3 q(n[9], n[10], n[11]);
        for (int k = 0; k < 3; ++k) q += p[k] * glm::dvec3(n[3 * k], n[3 * k + 1], n[3 * k + 2]);
        const int shape = static_cast<int>(n[13]);
        if (shape > 0 && q.z < 0) continue;
        if (shape == 2 && q.z > 1) continue;
        const double r = shape == 2 ? std::hypot(q.x, q.y) : glm::length(q);
        if (r < 1) sum += n[12] * std::pow(1 - r * r, 2);
    }
    return sum;
}

}  // namespace

double plain_value(const DrawableScene& scene, const Solid& solid, const glm::dvec3& p) {
    const auto& c = solid.coefficients;
    switch (solid.kind) {
        case Solid::Kind::prism:
            return side_of(scene, solid, glm::dvec2(p));
        case Solid::Kind::conic_prism:
            return side_of(scene, solid, glm::dvec2(p) / p.z);
        case Solid::Kind::lathe:
            return side_of(scene, solid, {std::hypot(p.x, p.y), p.z});
        case Solid::Kind::surface_of_revolution:
            return side_of(scene, solid, {p.x * p.x + p.y * p.y, p.z});
        case Solid::Kind::blob:
            return scene.numbers[solid.first_number] - field(scene, solid, p);
        default:
            return std::pow(
                       std::pow(std::pow(std::fabs(p.x), c[0]) + std::pow(std::fabs(p.y), c[0]),
                                c[1] / c[0]) +
                           std::pow(std::fabs(p.z), c[1]),
                       1 / c[1]) -
                   1;
    }
}

std::vector<double> plain_roots(const DrawableScene& scene, const Solid& solid,
                                const glm::dvec3& from, const glm::dvec3& along, double first,
                                double last) {
    std::vector<double> roots;
    const auto at = [&](double t) { return plain_value(scene, solid, from + t * along); };
    const auto add_root_between = [&](double a, double b) {
        const bool negative = at(a) < 0;
        if (negative == (at(b) < 0)) return;
        for (int halving = 0; halving < 60; ++halving)
            ((at((a + b) / 2) < 0) == negative ? a : b) = (a + b) / 2;
        roots.push_back(a);
    };
    // On both sides of the ray, as seen along the sweep or from the apex.
    const glm::dvec3 sweep(0, 0, 1);
    const auto may_be_met = [&](const ControlPoints& points) {
        bool left = false, right = false;
        for (const glm::dvec2& q : points) {
            const double side = solid.kind == Solid::Kind::prism
                                    ? glm::dot(glm::cross(sweep, along), glm::dvec3(q, 0) - from)
                                    : glm::dot(glm::cross(from, along), glm::dvec3(q, 1));
            (side < 0 ? left : right) = true;
        }
        return left && right;
    };
    switch (solid.kind) {
        case Solid::Kind::prism:
        case Solid::Kind::conic_prism:
            for (const Chord& chord : chords_of(scene, solid, may_be_met))
                add_wall_roots(chord, solid.kind == Solid::Kind::conic_prism, from, along, roots);
            break;
        case Solid::Kind::lathe:
        case Solid::Kind::surface_of_revolution:
            for (Chord chord : chords_of(scene, solid, [](const ControlPoints&) { return true; })) {
                if (solid.kind == Solid::Kind::surface_of_revolution)
                    for (glm::dvec2* p : {&chord.a, &chord.b}) p->x = std::sqrt(p->x);
                add_ring_roots(chord, from, along, roots);
            }
            break;
        case Solid::Kind::superellipsoid: {
            // Convex along the ray: its roots are on both sides of where it is least.
            double a = first, b = last;
            for (int cut = 0; cut < 60; ++cut) {
                const double low = a + (b - a) * .38, high = a + (b - a) * .62;
                (at(low) < at(high) ? b : a) = at(low) < at(high) ? high : low;
            }
            add_root_between(first, a);
            add_root_between(a, last);
            break;
        }
        default: {
            constexpr int steps = 250;
            for (int i = 0; i < steps; ++i)
                add_root_between(first + (last - first) * i / steps,
                                 first + (last - first) * (i + 1) / steps);
        }
    }
    roots.erase(std::remove_if(roots.begin(), roots.end(),
                               [&](double t) { return !(t >= first && t <= last); }),
                roots.end());
    std::sort(roots.begin(), roots.end());
    return roots;
}

}  // namespace povpreview::test
