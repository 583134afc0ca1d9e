// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Solids that an outline makes: swept along a line, scaled as it goes, or turned around an axis.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/detail/intricate_solid.h"
#include "core/detail/outline.h"

namespace povpreview {

namespace {

/// Rays that stay as flat as this, of their length, are taken for level.
constexpr double level = 1e-7;

/// Whether the stretch of a line in the plane may pass through a box.
bool may_pass(const glm::dvec2& from, const glm::dvec2& along, double first, double last,
              const glm::dvec2& low, const glm::dvec2& high) {
    const glm::dvec2 middle = .5 * (low + high), half = .5 * (high - low);
    const double offset = along.y * (from.x - middle.x) - along.x * (from.y - middle.y);
    if (std::abs(offset) > (std::abs(along.y) * half.x + std::abs(along.x) * half.y) * (1 + 1e-9))
        return false;
    if (!std::isfinite(last)) return true;
    for (int k = 0; k < 2; ++k) {
        const double a = from[k] + first * along[k], b = from[k] + last * along[k];
        const double slack = 1e-9 * (half[k] + std::abs(middle[k]) + std::abs(a - b));
        if (std::max(a, b) < low[k] - slack || std::min(a, b) > high[k] + slack) return false;
    }
    return true;
}

/// Endless along z: (x, y), of a conic one (x / z, y / z), lies within the outline.
///
/// A ray and the direction of the sweep, or a ray and the apex, span a plane, which meets the
/// plane of the outline in a line a u + b v + c = 0: there the ray meets the walls.
class Prism final : public IntricateSolid {
   public:
    Prism(std::span<const double> outline, bool conic) : outline_(outline), conic_(conic) {}

    void find_roots(const RayStretch& ray, std::vector<double>& roots) const override {
        const glm::dvec3 &o = ray.from, &d = ray.along;
        if (!conic_ && !may_pass(glm::dvec2(o), glm::dvec2(d), ray.first, ray.last, outline_.low(),
                                 outline_.high()))
            return;
        const glm::dvec3 line =
            conic_ ? glm::cross(o, d) : glm::dvec3(d.y, -d.x, d.x * o.y - d.y * o.x);
        for (const Outline::Segment& segment : outline_.segments()) {
            Bernstein<3> f;
            for (std::size_t k = 0; k < 4; ++k)
                f[k] = line.x * segment.u[k] + line.y * segment.v[k] + line.z;
            for (const double s : BernsteinRoots<3>(f)) {
                const glm::dvec2 p = segment.at(s);
                // The depth where the ray comes nearest to (p, 0) + any z, or to any z (p, 1).
                const glm::dvec2 across = conic_ ? glm::dvec2(d) - p * d.z : glm::dvec2(d),
                                 away = conic_ ? p * o.z - glm::dvec2(o) : p - glm::dvec2(o);
                roots.push_back(glm::dot(across, away) / glm::dot(across, across));
            }
        }
    }

    double value(const glm::dvec3& p) const override {
        return outline_.side(conic_ ? glm::dvec2(p) / p.z : glm::dvec2(p));
    }
    std::size_t cost() const override { return 8 + 4 * outline_.segments().size(); }

   private:
    Outline outline_;
    bool conic_;
};

Bernstein<6> raised(const Bernstein<3>& f) { return bernstein_product<3, 3>(f, {1, 1, 1, 1}); }

/// (distance from the z axis, z) lies within the outline (u, v), or its square does.
///
/// The ray o + t d is at the height v at t = (v - oz) / dz, and there on the surface if
/// |dz o.xy + (v - oz) d.xy|^2 = dz^2 u^2 (or u): of a cubic outline a polynomial of degree 6.
class Lathe final : public IntricateSolid {
   public:
    Lathe(std::span<const double> outline, bool squared) : outline_(outline), squared_(squared) {
        for (const Outline::Segment& s : outline_.segments()) {
            parts_.push_back({raised(s.v),
                              squared ? raised(s.u) : bernstein_product<3, 3>(s.u, s.u),
                              bernstein_product<3, 3>(s.v, s.v)});
            const double reach = std::max(std::abs(s.low.x), std::abs(s.high.x));
            radius_ = std::max(radius_, squared ? std::sqrt(reach) : reach);
        }
    }

    void find_roots(const RayStretch& ray, std::vector<double>& roots) const override {
        const glm::dvec2 o(ray.from), d(ray.along);
        const double dd = glm::dot(d, d), cross = o.x * d.y - o.y * d.x;
        if (cross * cross > radius_ * radius_ * dd * (1 + 1e-9)) return;
        if (std::abs(ray.along.z) <= level * glm::length(ray.along))
            return find_level_roots(ray, roots);
        const double oz = ray.from.z, dz = ray.along.z;
        const glm::dvec2 base = dz * o - oz * d;
        const double weight = glm::dot(base, base), of_v = 2 * glm::dot(base, d);
        for (std::size_t i = 0; i < parts_.size(); ++i) {
            const Part& part = parts_[i];
            Bernstein<6> f;
            for (std::size_t k = 0; k <= 6; ++k)
                f[k] = weight + of_v * part.v[k] + dd * part.vv[k] - dz * dz * part.uu[k];
            for (const double s : BernsteinRoots<6>(f))
                roots.push_back((outline_.segments()[i].at(s).y - oz) / dz);
        }
    }

    double value(const glm::dvec3& p) const override {
        return outline_.side({squared_ ? p.x * p.x + p.y * p.y : std::hypot(p.x, p.y), p.z});
    }
    std::size_t cost() const override { return 8 + 16 * parts_.size(); }

   private:
    /// Of a segment: v, the square of the distance, and v^2.
    struct Part {
        Bernstein<6> v, uu, vv;
    };

    void find_level_roots(const RayStretch& ray, std::vector<double>& roots) const {
        const glm::dvec2 o(ray.from), d(ray.along);
        const double a = glm::dot(d, d), b = glm::dot(o, d);
        for (const Outline::Segment& segment : outline_.segments()) {
            Bernstein<3> above = segment.v;
            for (double& v : above) v -= ray.from.z;
            for (const double s : BernsteinRoots<3>(above)) {
                const double u = segment.at(s).x, uu = squared_ ? u : u * u;
                const double square = b * b - a * (glm::dot(o, o) - uu);
                if (square < 0) continue;
                roots.push_back((-b - std::sqrt(square)) / a);
                roots.push_back((-b + std::sqrt(square)) / a);
            }
        }
    }

    Outline outline_;
    std::vector<Part> parts_;
    bool squared_;
    double radius_ = 0;
};

}  // namespace

std::unique_ptr<IntricateSolid> prepared_prism(std::span<const double> outline, bool conic) {
    return std::make_unique<Prism>(outline, conic);
}

std::unique_ptr<IntricateSolid> prepared_lathe(std::span<const double> outline, bool squared) {
    return std::make_unique<Lathe>(outline, squared);
}

}  // namespace povpreview
