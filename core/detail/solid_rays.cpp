// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/detail/solid_rays.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/glm.hpp>
#include <limits>

#include "core/detail/bernstein_roots.h"

namespace povpreview {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// Quadratic forms x^2 m.x + y^2 m.y + z^2 m.z + constant, of the canonical solids.
struct Diagonal {
    glm::dvec3 m;
    double constant;
};
Diagonal diagonal(Solid::Kind kind) {
    switch (kind) {
        case Solid::Kind::cylinder:
            return {{1, 1, 0}, -1};
        case Solid::Kind::cone:
            return {{1, 1, -1}, 0};
        default:
            return {{1, 1, 1}, -1};
    }
}

/// Parabolas a t^2 + 2 b t + c along rays.
struct Parabolas {
    RayLanes a, b, c;
};

/// Their roots, without cancellation, and where a vanishes.
POVPREVIEW_WIDE_VECTORS
void parabola_roots(const Parabolas& __restrict p, RayLanes& __restrict first,
                    RayLanes& __restrict second) {
    for (int i = 0; i < ray_lanes; ++i) {
        const double square = p.b[i] * p.b[i] - p.a[i] * p.c[i];
        const double root = std::sqrt(square);  // not-a-number where there are none, and so on
        const double q = -(p.b[i] + std::copysign(root, p.b[i]));
        first[i] = q / p.a[i];
        second[i] = p.c[i] / q;
    }
}

POVPREVIEW_WIDE_VECTORS
void half_space_roots(const RowRays& __restrict r, const RayLanes& __restrict x,
                      RayLanes& __restrict first, RayLanes& __restrict second) {
    for (int i = 0; i < ray_lanes; ++i) {
        first[i] = -(r.from.z + x[i] * r.from_step.z) / (r.along.z + x[i] * r.along_step.z);
        second[i] = none;
    }
}

POVPREVIEW_WIDE_VECTORS
void find_diagonal(const Diagonal& __restrict f, const RowRays& __restrict r,
                   const RayLanes& __restrict x, Parabolas& __restrict p) {
    for (int i = 0; i < ray_lanes; ++i) {
        const double ox = r.from.x + x[i] * r.from_step.x, oy = r.from.y + x[i] * r.from_step.y,
                     oz = r.from.z + x[i] * r.from_step.z;
        const double dx = r.along.x + x[i] * r.along_step.x, dy = r.along.y + x[i] * r.along_step.y,
                     dz = r.along.z + x[i] * r.along_step.z;
        p.a[i] = f.m.x * dx * dx + f.m.y * dy * dy + f.m.z * dz * dz;
        p.b[i] = f.m.x * ox * dx + f.m.y * oy * dy + f.m.z * oz * dz;
        p.c[i] = f.m.x * ox * ox + f.m.y * oy * oy + f.m.z * oz * oz + f.constant;
    }
}

using Coefficients = std::array<double, 10>;

/// c . (xx, yy, zz, xy, xz, yz, x, y, z, 1), its linear part and its quadratic part.
double quadric_value(const Coefficients& c, const glm::dvec3& p) {
    return c[0] * p.x * p.x + c[1] * p.y * p.y + c[2] * p.z * p.z + c[3] * p.x * p.y +
           c[4] * p.x * p.z + c[5] * p.y * p.z + c[6] * p.x + c[7] * p.y + c[8] * p.z + c[9];
}
glm::dvec3 quadric_gradient(const Coefficients& c, const glm::dvec3& p) {
    return {2 * c[0] * p.x + c[3] * p.y + c[4] * p.z + c[6],
            2 * c[1] * p.y + c[3] * p.x + c[5] * p.z + c[7],
            2 * c[2] * p.z + c[4] * p.x + c[5] * p.y + c[8]};
}

POVPREVIEW_WIDE_VECTORS
void find_quadric(const Coefficients& __restrict c, const RowRays& __restrict r,
                  const RayLanes& __restrict x, Parabolas& __restrict p) {
    Coefficients quadratic = c;
    std::fill(quadratic.begin() + 6, quadratic.end(), 0.);
    for (int i = 0; i < ray_lanes; ++i) {
        const glm::dvec3 o = r.from + x[i] * r.from_step, d = r.along + x[i] * r.along_step;
        p.a[i] = quadric_value(quadratic, d);
        p.b[i] = glm::dot(quadric_gradient(c, o), d) / 2;
        p.c[i] = quadric_value(c, o);
    }
}

// ---- the torus

/// Around the y axis, major radius 1. With s the length along the ray from the point nearest to the
/// centre, |p|^2 = m + s^2, and the surface is (m + s^2 + 1 - r^2)^2 = 4 (x^2 + z^2).
int torus_roots(double r, const glm::dvec3& from, const glm::dvec3& along, double* roots) {
    const double length = glm::length(along);
    const glm::dvec3 d = along / length;
    const double nearest = -glm::dot(from, d);
    const glm::dvec3 p = from + nearest * d;
    const double m = glm::dot(p, p), reach = (1 + r) * (1 + r) - m;
    if (!(reach > 0)) return 0;
    const double k = m + 1 - r * r, half = std::sqrt(reach) * (1 + 1e-9);
    // By powers of s / half, which lies between -1 and 1.
    const double constant = k * k - 4 * (p.x * p.x + p.z * p.z),
                 first = -8 * (p.x * d.x + p.z * d.z) * half,
                 second = (2 * k - 4 * (d.x * d.x + d.z * d.z)) * half * half,
                 fourth = half * half * half * half;
    const Bernstein<4> f{constant - first + second + fourth, constant - first / 2 - fourth,
                         constant - second / 3 + fourth, constant + first / 2 - fourth,
                         constant + first + second + fourth};
    int found = 0;
    for (const double u : BernsteinRoots<4>(f))
        roots[found++] = (nearest + half * (2 * u - 1)) / length;
    return found;
}

/// To what is within a box or not farther from it than rounding; false where nothing is.
bool clip(RayStretch& ray, const Bounds& box) {
    for (int k = 0; k < 3; ++k) {
        const double slack =
            1e-9 * (std::abs(ray.from[k]) + std::abs(box.low[k]) + std::abs(box.high[k]));
        if (!std::isfinite(slack)) continue;
        const double low = box.low[k] - slack - ray.from[k],
                     high = box.high[k] + slack - ray.from[k];
        if (ray.along[k] == 0) {
            if (low > 0 || high < 0) return false;
            continue;
        }
        const double a = low / ray.along[k], b = high / ray.along[k];
        ray.first = std::max(ray.first, std::min(a, b));
        ray.last = std::min(ray.last, std::max(a, b));
    }
    return ray.first <= ray.last;
}

}  // namespace

RowRays row_rays(const PixelRays& rays, const glm::dmat4x3& to_frame, double y) {
    const glm::dmat3 linear(to_frame);
    const glm::dvec3 origin = to_frame * glm::dvec4(rays.origin, 1);
    const glm::dvec3 along = linear * rays.along, across = linear * rays.across,
                     down = linear * rays.down;
    if (rays.orthographic) return {origin + y * down, across, along, glm::dvec3(0)};
    return {origin, glm::dvec3(0), along + y * down, across};
}

void find_roots(const Solid& solid, const RowRays& rays, const RayLanes& x,
                std::vector<RayLanes>& roots) {
    constexpr std::size_t most = 4;
    roots.resize(solid.kind == Solid::Kind::torus ? most : 2);
    Parabolas parabolas;
    switch (solid.kind) {
        case Solid::Kind::half_space:
            return half_space_roots(rays, x, roots[0], roots[1]);
        case Solid::Kind::quadric:
            find_quadric(solid.coefficients, rays, x, parabolas);
            return parabola_roots(parabolas, roots[0], roots[1]);
        case Solid::Kind::torus:
            for (int i = 0; i < ray_lanes; ++i) {
                double found[most];
                const int count =
                    torus_roots(solid.coefficients[0], rays.from + x[i] * rays.from_step,
                                rays.along + x[i] * rays.along_step, found);
                for (int j = 0; j < int(most); ++j) roots[j][i] = j < count ? found[j] : none;
            }
            return;
        default:
            find_diagonal(diagonal(solid.kind), rays, x, parabolas);
            return parabola_roots(parabolas, roots[0], roots[1]);
    }
}

void find_roots(const IntricateSolid& solid, const RowRays& rays, const RayLanes& x,
                const RowRays& in_world, const Bounds& bounds, bool nearest_only,
                std::vector<RayLanes>& roots) {
    thread_local std::vector<double> found;
    roots.clear();
    for (int i = 0; i < ray_lanes; ++i) {
        RayStretch ray{in_world.from + x[i] * in_world.from_step,
                       in_world.along + x[i] * in_world.along_step};
        if (!clip(ray, bounds)) continue;
        ray.nearest_only = nearest_only;
        ray.from = rays.from + x[i] * rays.from_step;
        ray.along = rays.along + x[i] * rays.along_step;
        found.clear();
        solid.find_roots(ray, found);
        std::size_t used = 0;
        for (const double t : found) {
            if (!(t >= ray.first && t <= ray.last)) continue;
            if (used == roots.size()) {
                roots.emplace_back();
                roots.back().fill(none);
            }
            roots[used++][i] = t;
        }
    }
}

void find_values(const IntricateSolid& solid, const RowRays& rays, const RayLanes& x,
                 const RayLanes& t, std::uint32_t lanes, RayLanes& values) {
    for (int i = 0; i < ray_lanes; ++i)
        values[i] = lanes >> i & 1 ? solid.value(rays.from + x[i] * rays.from_step +
                                                 t[i] * (rays.along + x[i] * rays.along_step))
                                   : none;
}

POVPREVIEW_WIDE_VECTORS
void find_nearness(bool orthographic, const RayLanes& depths, RayLanes& nearness) {
    constexpr double never = -std::numeric_limits<double>::infinity();
    constexpr double farthest = 1e300;
    if (orthographic)
        for (int i = 0; i < ray_lanes; ++i)
            nearness[i] = depths[i] > 0 && depths[i] < farthest ? -depths[i] : never;
    else
        for (int i = 0; i < ray_lanes; ++i)
            nearness[i] = depths[i] > 0 && depths[i] < farthest ? 1 / depths[i] : never;
}

POVPREVIEW_WIDE_VECTORS
void find_values(const Solid& solid, const RowRays& r, const RayLanes& x, const RayLanes& t,
                 RayLanes& values) {
    constexpr double smallest = std::numeric_limits<double>::min();
    RayLanes px, py, pz;
    for (int i = 0; i < ray_lanes; ++i) {
        px[i] = r.from.x + x[i] * r.from_step.x + t[i] * (r.along.x + x[i] * r.along_step.x);
        py[i] = r.from.y + x[i] * r.from_step.y + t[i] * (r.along.y + x[i] * r.along_step.y);
        pz[i] = r.from.z + x[i] * r.from_step.z + t[i] * (r.along.z + x[i] * r.along_step.z);
    }
    switch (solid.kind) {
        case Solid::Kind::half_space:
            values = pz;
            break;
        case Solid::Kind::sphere:
        case Solid::Kind::cylinder: {
            const Diagonal f = diagonal(solid.kind);
            for (int i = 0; i < ray_lanes; ++i)
                values[i] = f.m.x * px[i] * px[i] + f.m.y * py[i] * py[i] + f.m.z * pz[i] * pz[i] +
                            f.constant;
            break;
        }
        case Solid::Kind::cone:
            for (int i = 0; i < ray_lanes; ++i) {
                const double z2 = pz[i] * pz[i];
                values[i] = (px[i] * px[i] + py[i] * py[i] - z2) / (z2 + smallest);
            }
            break;
        case Solid::Kind::quadric: {
            Coefficients sizes = solid.coefficients;
            for (double& c : sizes) c = std::abs(c);
            for (int i = 0; i < ray_lanes; ++i) {
                const glm::dvec3 p(px[i], py[i], pz[i]);
                values[i] = quadric_value(solid.coefficients, p) /
                            (quadric_value(sizes, glm::abs(p)) + smallest);
            }
            break;
        }
        case Solid::Kind::torus: {
            const double r2 = solid.coefficients[0] * solid.coefficients[0];
            for (int i = 0; i < ray_lanes; ++i) {
                const double aside = std::sqrt(px[i] * px[i] + pz[i] * pz[i]) - 1;
                values[i] = aside * aside + py[i] * py[i] - r2;
            }
            break;
        }
        default:
            assert(!"an intricate solid");
    }
}

}  // namespace povpreview
