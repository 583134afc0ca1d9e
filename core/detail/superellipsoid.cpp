// SPDX-License-Identifier: AGPL-3.0-or-later
#include <cmath>
#include <glm/glm.hpp>

#include "core/detail/intricate_solid.h"

namespace povpreview {

namespace {

/// The norm (a^p + b^p)^(1/p) of two numbers that are not negative, and its derivatives.
struct Norm {
    double value = 0, by_a = 0, by_b = 0;
};
Norm norm(double a, double b, double p) {
    const bool swapped = a < b;
    const double high = swapped ? b : a, low = swapped ? a : b;
    if (high == 0) return {};
    const double share = std::pow(low / high, p), sum = 1 + share, size = std::pow(sum, 1 / p);
    const double by_high = size / sum, by_low = low > 0 ? by_high * share * (high / low) : 0;
    return {high * size, swapped ? by_low : by_high, swapped ? by_high : by_low};
}

/// f = |p| - 1 of a norm: ((|x|^a + |y|^a)^(c/a) + |z|^c)^(1/c) with a, c >= 1, which makes f
/// convex along every ray.
class Superellipsoid final : public IntricateSolid {
   public:
    Superellipsoid(double around, double along) : around_(around), along_(along) {}

    /// Newton's steps, from outside on a convex function, never leave the outside, and find a slope
    /// that does not fall any more if there is no root: from both ends of the ray in the cube.
    ///
    ///     f  \              _/
    ///         \'.         _/          cube: largest coordinate 1, where f >= 0
    ///     -----\--'.----_/------ t
    ///           '._ '._-
    void find_roots(const RayStretch& ray, std::vector<double>& roots) const override {
        double first = -std::numeric_limits<double>::infinity(), last = -first;
        for (int k = 0; k < 3; ++k) {
            if (ray.along[k] == 0) {
                if (std::abs(ray.from[k]) > 1) return;
                continue;
            }
            const double middle = -ray.from[k] / ray.along[k], half = std::abs(1 / ray.along[k]);
            first = std::max(first, middle - half);
            last = std::min(last, middle + half);
        }
        if (!(first <= last) || last < ray.first || first > ray.last) return;
        if (!add_root_from(ray, first, 1, roots)) return;
        if (!ray.nearest_only || roots.back() < ray.first) add_root_from(ray, last, -1, roots);
    }

    double value(const glm::dvec3& p) const override {
        const glm::dvec3 q = glm::abs(p);
        return norm(norm(q.x, q.y, around_).value, q.z, along_).value - 1;
    }
    std::size_t cost() const override { return 1500; }

   private:
    /// `forward`: 1, or -1 from the far end. False where there is no root.
    bool add_root_from(const RayStretch& ray, double t, double forward,
                       std::vector<double>& roots) const {
        for (int step = 0; step < 100; ++step) {
            const glm::dvec3 p = ray.at(t), q = glm::abs(p);
            const Norm across = norm(q.x, q.y, around_), whole = norm(across.value, q.z, along_);
            const double f = whole.value - 1;
            const double slope =
                forward * (std::copysign(whole.by_a * across.by_a, p.x) * ray.along.x +
                           std::copysign(whole.by_a * across.by_b, p.y) * ray.along.y +
                           std::copysign(whole.by_b, p.z) * ray.along.z);
            if (f <= 1e-14) break;
            if (!(slope < 0)) return false;
            const double next = t - forward * f / slope;
            if (std::abs(next - t) <= 1e-15 * std::abs(t)) break;
            t = next;
        }
        roots.push_back(t);
        return true;
    }

    double around_, along_;
};

}  // namespace

std::unique_ptr<IntricateSolid> prepared_superellipsoid(double around, double along) {
    return std::make_unique<Superellipsoid>(around, along);
}

}  // namespace povpreview
