// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "core/detail/bernstein_roots.h"
#include "core/detail/intricate_solid.h"

namespace povpreview {

namespace {

/// A field of strength (1 - r^2)^2 within r = 1: around a point, of that the half z >= 0, or around
/// a line for z in [0, 1].
struct Component {
    enum class Shape : std::uint8_t { ball, half_ball, cylinder };
    glm::dmat4x3 to_frame{1};
    double strength = 0;
    Shape shape = Shape::ball;

    double z_weight() const { return shape == Shape::cylinder ? 0 : 1; }
    double low() const {
        return shape == Shape::ball ? -std::numeric_limits<double>::infinity() : 0;
    }
    double high() const {
        return shape == Shape::cylinder ? 1 : std::numeric_limits<double>::infinity();
    }
};

/// Its r^2 = a t^2 + 2 b t + c along a ray, within [first, last] where it has an effect.
struct Influence {
    double a, b, c, first, last, strength;

    /// The polar form, which is r^2 where both are the same.
    double square(double s, double t) const { return (a * s + b) * t + b * s + c; }
};

/// Inside is where the sum of the components' fields is at least the threshold.
class Blob final : public IntricateSolid {
   public:
    explicit Blob(std::span<const double> numbers) : threshold_(numbers.front()) {
        for (std::size_t first = 1; first < numbers.size(); first += blob_numbers_a_component) {
            const double* n = &numbers[first];
            Component component;
            for (int column = 0; column < 4; ++column, n += 3)
                component.to_frame[column] = {n[0], n[1], n[2]};
            component.strength = n[0];
            component.shape = n[1] == 0   ? Component::Shape::ball
                              : n[1] == 1 ? Component::Shape::half_ball
                                          : Component::Shape::cylinder;
            components_.push_back(component);
        }
    }

    /// Between places where components begin or end to have an effect the sum is of degree 4.
    void find_roots(const RayStretch& ray, std::vector<double>& roots) const override {
        thread_local std::vector<Influence> influences;
        thread_local std::vector<double> bounds;
        influences.clear();
        bounds.clear();
        for (const Component& component : components_) add_influence(component, ray, influences);
        for (const Influence& influence : influences)
            bounds.insert(bounds.end(), {influence.first, influence.last});
        std::sort(bounds.begin(), bounds.end());
        for (std::size_t i = 0; i + 1 < bounds.size(); ++i) {
            const double s = bounds[i], t = bounds[i + 1];
            if (!(s < t) || t < ray.first) continue;
            if (s > ray.last || (ray.nearest_only && !roots.empty())) break;
            Bernstein<4> f;
            f.fill(-threshold_);
            for (const Influence& influence : influences)
                if (influence.first <= s && influence.last >= t) add_field(influence, s, t, f);
            for (const double root : BernsteinRoots<4>(f))
                if (s + (t - s) * root >= ray.first) roots.push_back(s + (t - s) * root);
        }
    }

    double value(const glm::dvec3& p) const override {
        double field = 0;
        for (const Component& component : components_) {
            const glm::dvec3 q = component.to_frame * glm::dvec4(p, 1);
            const double square = q.x * q.x + q.y * q.y + component.z_weight() * q.z * q.z;
            if (square >= 1 || q.z < component.low() || q.z > component.high()) continue;
            field += component.strength * (1 - square) * (1 - square);
        }
        // POV-Ray takes for inside what is within 1e-6 of the threshold.
        constexpr double tolerance = 2e-6;
        return 1e-9 / tolerance * (threshold_ - field);
    }
    std::size_t cost() const override { return 100 + 10 * components_.size(); }

   private:
    static void add_influence(const Component& component, const RayStretch& ray,
                              std::vector<Influence>& influences) {
        const glm::dvec3 o = component.to_frame * glm::dvec4(ray.from, 1);
        const glm::dvec3 d = glm::dmat3(component.to_frame) * ray.along;
        const double w = component.z_weight();
        Influence result{d.x * d.x + d.y * d.y + w * d.z * d.z,
                         d.x * o.x + d.y * o.y + w * d.z * o.z,
                         o.x * o.x + o.y * o.y + w * o.z * o.z,
                         0,
                         0,
                         component.strength};
        // Of r^2 = 1; a ray along a cylinder is in it everywhere or nowhere.
        const double square = result.b * result.b - result.a * (result.c - 1);
        if (result.a == 0 ? result.c >= 1 : square <= 0) return;
        const double half = std::sqrt(square);
        result.first = result.a == 0 ? ray.first : (-result.b - half) / result.a;
        result.last = result.a == 0 ? ray.last : (-result.b + half) / result.a;
        if (component.shape != Component::Shape::ball && !cut(component, o.z, d.z, result)) return;
        if (result.first < result.last && result.last > ray.first && result.first < ray.last &&
            std::isfinite(result.last - result.first))
            influences.push_back(result);
    }

    /// To where z is between its ends.
    static bool cut(const Component& component, double o, double d, Influence& influence) {
        if (d == 0) return o >= component.low() && o <= component.high();
        const double low = (component.low() - o) / d, high = (component.high() - o) / d;
        influence.first = std::max(influence.first, std::min(low, high));
        influence.last = std::min(influence.last, std::max(low, high));
        return true;
    }

    /// Over [s, t].
    static void add_field(const Influence& influence, double s, double t, Bernstein<4>& f) {
        const Bernstein<2> g{1 - influence.square(s, s), 1 - influence.square(s, t),
                             1 - influence.square(t, t)};
        f[0] += influence.strength * g[0] * g[0];
        f[1] += influence.strength * g[0] * g[1];
        f[2] += influence.strength * (g[0] * g[2] + 2 * g[1] * g[1]) / 3;
        f[3] += influence.strength * g[1] * g[2];
        f[4] += influence.strength * g[2] * g[2];
    }

    double threshold_;
    std::vector<Component> components_;
};

}  // namespace

std::unique_ptr<IntricateSolid> prepared_blob(std::span<const double> numbers) {
    return std::make_unique<Blob>(numbers);
}

}  // namespace povpreview
