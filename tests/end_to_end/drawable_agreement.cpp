// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/end_to_end/drawable_agreement.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "core/detail/intricate_solid.h"
#include "tests/core/detail/plain_solids.h"

namespace povpreview {
namespace {

/// Coefficients from the constant on.
using Polynomial = std::vector<double>;

Polynomial operator+(Polynomial a, const Polynomial& b) {
    a.resize(std::max(a.size(), b.size()));
    for (std::size_t i = 0; i < b.size(); ++i) a[i] += b[i];
    return a;
}
Polynomial operator*(const Polynomial& a, const Polynomial& b) {
    Polynomial product(a.size() + b.size() - 1);
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0; j < b.size(); ++j) product[i + j] += a[i] * b[j];
    return product;
}
Polynomial operator*(double s, Polynomial p) {
    for (double& c : p) c *= s;
    return p;
}
double at(const Polynomial& p, double t) {
    double value = 0;
    for (std::size_t i = p.size(); i-- > 0;) value = value * t + p[i];
    return value;
}

/// Roots between low and high where the sign changes: between the derivative's there is at most
/// one.
std::vector<double> roots(Polynomial p, double low, double high) {
    while (p.size() > 1 && p.back() == 0) p.pop_back();
    if (p.size() < 2) return {};
    Polynomial derivative;
    for (std::size_t i = 1; i < p.size(); ++i) derivative.push_back(static_cast<double>(i) * p[i]);
    std::vector<double> ends = roots(derivative, low, high), result;
    ends.insert(ends.begin(), low);
    ends.push_back(high);
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        double a = ends[i], b = ends[i + 1];
        const bool rising = at(p, a) < 0;
        if (rising == (at(p, b) < 0)) continue;
        for (int step = 0; step < 200 && a < b; ++step) {
            const double middle = a + (b - a) / 2;
            if (middle == a || middle == b) break;
            ((at(p, middle) < 0) == rising ? a : b) = middle;
        }
        result.push_back(b);
    }
    return result;
}

/// A polynomial with the sign of f along the ray p + t d in the solid's frame.
Polynomial along(const Solid& solid, const glm::dvec3& p, const glm::dvec3& d) {
    const Polynomial x{p.x, d.x}, y{p.y, d.y}, z{p.z, d.z};
    const auto& c = solid.coefficients;
    switch (solid.kind) {
        case Solid::Kind::half_space:
            return z;
        case Solid::Kind::sphere:
            return x * x + y * y + z * z + Polynomial{-1};
        case Solid::Kind::cylinder:
            return x * x + y * y + Polynomial{-1};
        case Solid::Kind::cone:
            return x * x + y * y + -1. * (z * z);
        case Solid::Kind::quadric:
            return c[0] * (x * x) + c[1] * (y * y) + c[2] * (z * z) + c[3] * (x * y) +
                   c[4] * (x * z) + c[5] * (y * z) + c[6] * x + c[7] * y + c[8] * z +
                   Polynomial{c[9]};
        case Solid::Kind::torus: {
            const Polynomial ring = x * x + z * z, sum = ring + y * y + Polynomial{1 - c[0] * c[0]};
            return sum * sum + -4. * ring;
        }
        default:
            return {};
    }
}

/// Where the ray is inside of a box.
Stretch inside_box(const Bounds& box, const Ray& ray) {
    Stretch stretch;
    for (int i = 0; i < 3; ++i) {
        double a = (box.low[i] - ray.origin[i]) / ray.direction[i],
               b = (box.high[i] - ray.origin[i]) / ray.direction[i];
        if (ray.direction[i] == 0) {
            if (ray.origin[i] >= box.low[i] && ray.origin[i] <= box.high[i]) continue;
            return {1, 0};
        }
        if (a > b) std::swap(a, b);
        stretch.low = std::max(stretch.low, a);
        stretch.high = std::min(stretch.high, b);
    }
    return stretch;
}

Seen see(const DrawableScene& scene, const Ray& ray, const NearestFace& face) {
    Seen said;
    said.surface = face.surface;
    said.material = face.face != nullptr ? face.face->material : 0;
    said.depth = face.depth;
    said.face = face.face;
    said.hits = {{face.depth, face.surface}};
    for (const std::uint32_t other : face.others) said.hits.push_back({face.depth, other});
    for (const Bounds& box : scene.unknown) {
        const Stretch stretch = inside_box(box, ray);
        if (stretch.low <= stretch.high)
            said.unknown_from = std::min(said.unknown_from, stretch.low);
    }
    for (const CurvedObject& object : scene.objects) {
        const Stretch stretch = inside_box(object.bounds, ray);
        if (stretch.low > stretch.high || stretch.low > said.depth) continue;
        const double slack = 1e-9 * (1 + stretch.high);
        for (std::uint32_t i = 0; i < object.pieces; ++i) {
            const CurvedPiece& piece = scene.pieces[object.first_piece + i];
            for (const double depth : crossings(scene, scene.solids[piece.solid], ray, stretch)) {
                if (depth < std::max(too_near, stretch.low - slack)) continue;
                if (depth > stretch.high + slack) break;
                const Holds shows = holds(scene, piece, ray.origin + depth * ray.direction);
                if (shows == Holds::no) continue;
                said.hits.push_back({depth, piece.surface});
                if (shows == Holds::undecided) {
                    said.undecided_from = std::min(said.undecided_from, depth);
                    continue;
                }
                if (depth < said.depth) {
                    said.surface = piece.surface;
                    said.material = piece.material;
                    said.depth = depth;
                    said.face = nullptr;
                }
                break;
            }
        }
    }
    said.point = ray.origin + said.depth * ray.direction;
    return said;
}

/// Probes have depths in single precision; a position this near to an outline is judged apart.
bool same(const Sample& probe, std::uint32_t surface, double depth) {
    if (probe.surface != surface) return false;
    return surface == 0 || std::fabs(depth - probe.depth) <= 1e-4 * (1 + depth);
}

bool is_tied(const Sample& probe, const Seen& said) {
    const double nearest =
        probe.surface == 0 ? said.depth : std::min(said.depth, double(probe.depth));
    if (said.undecided_from <= nearest + 1e-4 * (1 + nearest)) return true;
    return std::any_of(said.hits.begin(), said.hits.end(), [&](const auto& hit) {
        return hit.second == probe.surface && hit.first <= said.depth + 1e-6 * (1 + said.depth);
    });
}

}  // namespace

std::vector<double> crossings(const DrawableScene& scene, const Solid& solid, const Ray& ray,
                              const Stretch& within) {
    if (is_intricate(solid.kind))
        return test::plain_roots(scene, solid, solid.to_frame * glm::dvec4(ray.origin, 1),
                                 solid.to_frame * glm::dvec4(ray.direction, 0), within.low,
                                 within.high);
    // From the point of the ray that is nearest to the frame's origin: far away, rounding eats the
    // roots.
    glm::dvec3 p = solid.to_frame * glm::dvec4(ray.origin, 1);
    const glm::dvec3 d = solid.to_frame * glm::dvec4(ray.direction, 0);
    const double shift = -glm::dot(p, d) / glm::dot(d, d);
    if (!std::isfinite(shift)) return {};
    p += shift * d;
    std::vector<double> result = roots(along(solid, p, d), too_near - shift, too_far - shift);
    for (double& depth : result) depth += shift;
    return result;
}

Holds is_inside(const DrawableScene& scene, const Solid& solid, const glm::dvec3& point) {
    constexpr double rounding = 1e-7;
    const glm::dvec3 p = solid.to_frame * glm::dvec4(point, 1);
    if (is_intricate(solid.kind)) {
        // Of the points around it, as far as chords are from their curves.
        const double aside = 1e-4;
        const bool inside = test::plain_value(scene, solid, p) <= 0;
        for (const glm::dvec3& step :
             {glm::dvec3(aside, 0, 0), glm::dvec3(0, aside, 0), glm::dvec3(0, 0, aside)})
            for (const glm::dvec3& q : {p + step, p - step})
                if ((test::plain_value(scene, solid, q) <= 0) != inside) return Holds::undecided;
        return inside ? Holds::yes : Holds::no;
    }
    const double f = along(solid, p, glm::dvec3(0))[0];
    double scale = 1;
    if (solid.kind == Solid::Kind::half_space) {
        scale += glm::length(point);
    } else if (solid.kind == Solid::Kind::quadric) {
        Solid terms = solid;
        for (double& c : terms.coefficients) c = std::fabs(c);
        scale = along(terms, glm::abs(p), glm::dvec3(0))[0];
    }
    if (std::fabs(f) <= rounding * scale) return Holds::undecided;
    return f < 0 ? Holds::yes : Holds::no;
}

Holds holds(const DrawableScene& scene, const CurvedPiece& piece, const glm::dvec3& point) {
    // In this order, not is what mirrors it, and is the lesser, or the greater.
    std::vector<Holds> stack;
    for (std::uint32_t i = 0; i < piece.conditions; ++i) {
        const ConditionStep step = scene.conditions[piece.first_condition + i];
        if (step >= 0) {
            stack.push_back(is_inside(scene, scene.solids[static_cast<std::size_t>(step)], point));
        } else if (step == condition_not) {
            if (stack.back() != Holds::undecided)
                stack.back() = stack.back() == Holds::yes ? Holds::no : Holds::yes;
        } else {
            const Holds top = stack.back();
            stack.pop_back();
            stack.back() =
                step == condition_and ? std::min(stack.back(), top) : std::max(stack.back(), top);
        }
    }
    return stack.empty() ? Holds::yes : stack.back();
}

std::vector<Seen> seen_at(const DrawableScene& scene, std::span<const glm::dvec2> positions) {
    const std::vector<NearestFace> faces = nearest_faces(scene.polygons, positions);
    std::vector<Seen> seen;
    for (std::size_t i = 0; i < positions.size(); ++i)
        seen.push_back(see(scene, ray_through(scene.polygons.camera, positions[i]), faces[i]));
    return seen;
}

DrawableAgreement compare_drawable(const DrawableScene& scene, std::span<const Sample> probes) {
    std::vector<glm::dvec2> positions;
    for (const Sample& probe : probes) positions.push_back(probe.position);
    const std::vector<Seen> all = seen_at(scene, positions);
    DrawableAgreement result;
    std::vector<std::size_t> doubtful;
    for (std::size_t i = 0; i < probes.size(); ++i) {
        const Seen& said = all[i];
        // What is as near as that POV-Ray itself sees or not, by kind of object.
        const bool too_near_to_say = probes[i].surface != 0 && probes[i].depth < 2 * too_near;
        if (probes[i].failed || too_near_to_say) continue;
        ++result.probes;
        if (!said.known()) {
            ++result.unknown;
            continue;
        }
        result.curved += said.curved();
        if (same(probes[i], said.surface, said.depth))
            ++result.agreeing;
        else if (is_tied(probes[i], said))
            ++result.tied;
        else
            doubtful.push_back(i);
    }
    // Around those that do not agree.
    std::vector<glm::dvec2> around;
    for (const std::size_t i : doubtful)
        for (int k = 0; k < 8; ++k) {
            const double angle = k * .785398;
            around.push_back(positions[i] + hair * glm::dvec2(std::cos(angle), std::sin(angle)));
        }
    const std::vector<Seen> seen_around = seen_at(scene, around);
    for (std::size_t d = 0; d < doubtful.size(); ++d) {
        const std::size_t i = doubtful[d];
        bool near = false;
        for (std::size_t k = 8 * d; k < 8 * d + 8; ++k) {
            near = near || seen_around[k].surface == probes[i].surface || !seen_around[k].known();
        }
        (near ? result.at_edges : result.wrong) += 1;
        if (!near && result.examples.size() < 20)
            result.examples.push_back(
                {positions[i], probes[i].surface, all[i].surface, probes[i].depth, all[i].depth});
    }
    return result;
}

}  // namespace povpreview
