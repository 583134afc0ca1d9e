// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/core/detail/ray_caster.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/packing.hpp>
#include <limits>

#include "core/detail/intricate_solid.h"
#include "tests/core/detail/plain_solids.h"

namespace povpreview::test {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double pi = 3.14159265358979323846;

double value(const DrawableScene& scene, const Solid& solid, const glm::dvec3& world) {
    const glm::dvec3 p = solid.to_frame * glm::dvec4(world, 1);
    const auto& c = solid.coefficients;
    switch (solid.kind) {
        case Solid::Kind::half_space:
            return p.z;
        case Solid::Kind::sphere:
            return glm::dot(p, p) - 1;
        case Solid::Kind::cylinder:
            return p.x * p.x + p.y * p.y - 1;
        case Solid::Kind::cone:
            return p.x * p.x + p.y * p.y - p.z * p.z;
        case Solid::Kind::quadric:
            return c[0] * p.x * p.x + c[1] * p.y * p.y + c[2] * p.z * p.z + c[3] * p.x * p.y +
                   c[4] * p.x * p.z + c[5] * p.y * p.z + c[6] * p.x + c[7] * p.y + c[8] * p.z +
                   c[9];
        case Solid::Kind::torus: {
            const double aside = std::hypot(p.x, p.z) - 1;
            return aside * aside + p.y * p.y - c[0] * c[0];
        }
        default:
            return plain_value(scene, solid, p);
    }
}

/// Where a ray meets a quadratic solid: the value along it is a parabola, known by three points.
template <class F>
std::vector<double> parabola_roots(const F& f, double around, double step) {
    const double low = f(around - step), middle = f(around), high = f(around + step);
    const double a = (low + high) / 2 - middle, b = (high - low) / 2;
    std::vector<double> roots;
    if (std::fabs(a) < 1e-12 * (std::fabs(b) + std::fabs(middle))) {
        if (b != 0) roots = {around - step * middle / b};
        return roots;
    }
    const double square = b * b - 4 * a * middle;
    if (square < 0) return roots;
    const double q = -(b + std::copysign(std::sqrt(square), b)) / 2;
    roots = {around + step * q / a};
    if (q != 0) roots.push_back(around + step * middle / q);
    std::sort(roots.begin(), roots.end());
    return roots;
}

/// Between a and b, where the signs of f differ.
template <class F>
double root_between(const F& f, double a, double b) {
    const bool negative = f(a) < 0;
    for (int halving = 0; halving < 60; ++halving)
        ((f((a + b) / 2) < 0) == negative ? a : b) = (a + b) / 2;
    return a;
}

/// Between a and b, where |f| is least, if there is but one such place.
template <class F>
double least_between(const F& f, double a, double b) {
    for (int cut = 0; cut < 80; ++cut) {
        const double low = a + (b - a) * .38, high = a + (b - a) * .62;
        (std::fabs(f(low)) < std::fabs(f(high)) ? b : a) =
            std::fabs(f(low)) < std::fabs(f(high)) ? high : low;
    }
    return (a + b) / 2;
}

/// Where a ray meets a torus: by many small steps, and where it may just graze it, a closer look.
template <class F>
std::vector<double> stepped_roots(const F& f, double from, double to) {
    constexpr int steps = 400;
    const auto at = [&](int i) { return from + (to - from) * i / steps; };
    std::vector<double> values, roots;
    for (int i = 0; i <= steps; ++i) values.push_back(f(at(i)));
    for (int i = 1; i <= steps; ++i) {
        const double before = values[i - 1], now = values[i];
        if ((before < 0) != (now < 0)) {
            roots.push_back(root_between(f, at(i - 1), at(i)));
            continue;
        }
        // The middle of three that is nearest to 0.
        if (i == steps || (values[i + 1] < 0) != (now < 0) || std::fabs(before) < std::fabs(now) ||
            std::fabs(values[i + 1]) < std::fabs(now))
            continue;
        const double least = least_between(f, at(i - 1), at(i + 1));
        if ((f(least) < 0) == (now < 0)) continue;
        roots.push_back(root_between(f, at(i - 1), least));
        roots.push_back(root_between(f, least, at(i + 1)));
    }
    return roots;
}

}  // namespace

CameraPose look_at(const glm::dvec3& from, const glm::dvec3& at, double width_by_distance) {
    const glm::dvec3 ahead = glm::normalize(at - from);
    const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0, 1, .001), ahead));
    const glm::dvec3 up = glm::cross(ahead, right);
    return {from, ahead, width_by_distance * right, width_by_distance * .75 * up, false};
}

StraightCamera CameraPose::straight(int width, int height) const {
    const glm::dmat3 inverse = glm::inverse(glm::dmat3(direction, right, up));
    const auto row = [&](int i) {
        const glm::dvec3 linear(inverse[0][i], inverse[1][i], inverse[2][i]);
        return glm::dvec4(linear, -glm::dot(linear, location));
    };
    const glm::dvec4 along = row(0), w = orthographic ? glm::dvec4(0, 0, 0, 1) : along;
    const glm::dvec4 x = double(width) * (row(1) + .5 * w), y = double(height) * (.5 * w - row(2));
    StraightCamera camera;
    camera.eye = orthographic ? glm::dvec4(-direction, 0) : glm::dvec4(location, 1);
    for (int i = 0; i < 4; ++i) camera.to_pixels[i] = {x[i], y[i], w[i]};
    camera.depth = glm::length(direction) * along;
    return camera;
}

struct RayCaster::Found {
    Hit hit{infinity};
    glm::dvec3 point{};
    glm::dvec2 uv{};
    glm::dvec3 normal{};  ///< where it is flat
    std::uint32_t material = 0xffffffff;

    bool nearer(double t) const { return t > 0 && t < hit.depth; }
    void set(double t, std::uint32_t surface, std::uint32_t of, const glm::dvec3& p) {
        hit.depth = t;
        hit.surface = surface;
        material = of;
        point = p;
    }
};

void RayCaster::cast_faces(const Ray& ray, Found& found) const {
    const PolygonScene& polygons = scene_.polygons;
    for (const Face& face : polygons.faces) {
        if (!(ray.reflected ? face.reflected : face.visible)) continue;
        for (std::size_t i = 2; i < face.count; ++i) {
            // Moeller and Trumbore's test, per triangle of the fan.
            const glm::dvec3 a = polygons.corner(face, 0);
            const glm::dvec3 ab = polygons.corner(face, i - 1) - a,
                             ac = polygons.corner(face, i) - a;
            const glm::dvec3 across = glm::cross(ray.along, ac);
            const double volume = glm::dot(ab, across);
            if (volume == 0) continue;
            const glm::dvec3 from = ray.from - a, other = glm::cross(from, ab);
            const double u = glm::dot(from, across) / volume,
                         v = glm::dot(ray.along, other) / volume, t = glm::dot(ac, other) / volume;
            if (u < 0 || v < 0 || u + v > 1 || !found.nearer(t)) continue;
            found.set(t, face.surface, face.material, ray.at(t));
            found.normal = glm::normalize(glm::cross(ab, ac));
            if (scene_.corner_uvs.empty()) continue;
            const auto uv = [&](std::size_t corner) {
                return glm::dvec2(scene_.corner_uvs[face.first + corner]);
            };
            found.uv = (1 - u - v) * uv(0) + u * uv(i - 1) + v * uv(i);
        }
    }
}

bool RayCaster::holds(const CurvedPiece& piece, const glm::dvec3& p) const {
    std::vector<bool> stack;
    for (std::uint32_t i = 0; i < piece.conditions; ++i) {
        const ConditionStep step = scene_.conditions[piece.first_condition + i];
        if (step >= 0) {
            stack.push_back(value(scene_, scene_.solids[static_cast<std::size_t>(step)], p) <= 0);
            continue;
        }
        const bool top = stack.back();
        if (step == condition_not) {
            stack.back() = !top;
            continue;
        }
        stack.pop_back();
        const bool below = stack.back();
        stack.back() = step == condition_and ? below && top : below || top;
    }
    return stack.empty() || stack.back();
}

std::vector<double> RayCaster::roots_within(const Bounds& bounds, const Ray& ray,
                                            const Solid& solid, const glm::dvec3& from,
                                            const glm::dvec3& along) const {
    double first = 0, last = 1e9;
    for (int k = 0; k < 3; ++k) {
        const double a = (bounds.low[k] - ray.from[k]) / ray.along[k],
                     b = (bounds.high[k] - ray.from[k]) / ray.along[k];
        first = std::max(first, std::min(a, b));
        last = std::min(last, std::max(a, b));
    }
    if (first > last) return {};
    return plain_roots(scene_, solid, from, along, first, last);
}

void RayCaster::cast_objects(const Ray& ray, Found& found) const {
    for (const CurvedObject& object : scene_.objects) {
        for (std::uint32_t i = 0; i < object.pieces; ++i) {
            const CurvedPiece& piece = scene_.pieces[object.first_piece + i];
            const Solid& solid = scene_.solids[piece.solid];
            const auto f = [&](double t) { return value(scene_, solid, ray.at(t)); };
            // The ray in the solid's frame, and where it is nearest to the origin there.
            const glm::dvec3 e = solid.to_frame * glm::dvec4(ray.from, 1),
                             d = solid.to_frame * glm::dvec4(ray.along, 0);
            const double middle = -glm::dot(e, d) / glm::dot(d, d), step = 1 / glm::length(d);
            const double wide = step * (1 + glm::length(e + middle * d));
            const double reach = (1.1 + solid.coefficients[0]) * step;
            const bool is_torus = solid.kind == Solid::Kind::torus;
            if (is_torus && glm::length(e + middle * d) > 1 + solid.coefficients[0]) continue;
            const std::vector<double> roots =
                is_intricate(solid.kind) ? roots_within(object.bounds, ray, solid, e, d)
                : is_torus               ? stepped_roots(f, middle - reach, middle + reach)
                                         : parabola_roots(f, middle, wide);
            for (const double t : roots)
                if (found.nearer(t) && holds(piece, ray.at(t))) {
                    found.set(t, piece.surface, piece.material, ray.at(t));
                    const glm::dmat4x3& m = solid.to_frame;
                    found.normal = glm::normalize(glm::dvec3(m[0].z, m[1].z, m[2].z));
                }
        }
    }
}

void RayCaster::cast_unknown(const Ray& ray, const std::vector<Bounds>& boxes, Found& found) const {
    for (const Bounds& box : boxes) {
        double first = 1e-300, last = infinity;
        for (int i = 0; i < 3; ++i) {
            const double a = (box.low[i] - ray.from[i]) / ray.along[i],
                         b = (box.high[i] - ray.from[i]) / ray.along[i];
            first = std::max(first, std::min(a, b));
            last = std::min(last, std::max(a, b));
        }
        if (first <= last && found.nearer(first))
            found.set(first, ItemBuffer::unknown, 0xffffffff, {});
    }
}

RayCaster::Ray RayCaster::ray_through(double px, double py) const {
    const glm::dvec3 aside = (px / scene_.polygons.width - .5) * pose_.right +
                             (.5 - py / scene_.polygons.height) * pose_.up;
    return pose_.orthographic ? Ray{pose_.location + aside, pose_.direction}
                              : Ray{pose_.location, pose_.direction + aside};
}

RayCaster::Found RayCaster::trace(const Ray& ray) const {
    Found found;
    cast_faces(ray, found);
    cast_objects(ray, found);
    cast_unknown(ray, scene_.unknown, found);
    if (ray.reflected) cast_unknown(ray, scene_.unknown_in_mirrors, found);
    return found;
}

RayCaster::Hit RayCaster::cast_reflected(double px, double py) const {
    const Ray ray = ray_through(px, py);
    const Found mirror = trace(ray);
    const glm::dvec3 along = glm::normalize(glm::reflect(ray.along, mirror.normal));
    constexpr double off = 1e-9;  // lest it meet the mirror itself
    return look_of(trace({mirror.point + off * along, along, true}));
}

RayCaster::Hit RayCaster::cast(double px, double py) const {
    return look_of(trace(ray_through(px, py)));
}

/// What was hit, with its look.
RayCaster::Hit RayCaster::look_of(Found found) const {
    if (found.hit.surface == ItemBuffer::background) found.hit.kind = Look::Kind::plain;
    if (found.material >= scene_.looks.size()) return found.hit;
    const Look& look = scene_.looks[found.material];
    found.hit.kind = look.kind;
    if (look.kind != Look::Kind::image) return found.hit;
    const glm::dvec3 p = look.image.mapping == ImageLook::Mapping::uv
                             ? look.image.to_map * glm::dvec4(found.uv, 0, 1)
                             : look.image.to_map * glm::dvec4(found.point, 1);
    const auto colour =
        image_colour(scene_.images[look.image.image], look.image, p, scene_.working_gamma);
    if (colour)
        found.hit.albedo = *colour;
    else
        found.hit.kind = Look::Kind::traced;
    return found.hit;
}

ItemBuffer RayCaster::cast_all() const {
    ItemBuffer buffer;
    buffer.width = scene_.polygons.width;
    buffer.height = scene_.polygons.height;
    for (int y = 0; y < buffer.height; ++y) {
        for (int x = 0; x < buffer.width; ++x) {
            const Hit hit = cast(x + .5, y + .5);
            buffer.surfaces.push_back(hit.surface);
            buffer.kinds.push_back(hit.kind);
            buffer.albedos.push_back(hit.albedo);
        }
    }
    return buffer;
}

namespace {

/// Angle around the y axis, from x towards z, as a share of a whole turn.
double turn(double x, double z) {
    const double angle = std::atan2(z, x) / (2 * pi);
    return angle < 0 ? angle + 1 : angle;
}

glm::dvec2 on_unit_square(ImageLook::Mapping mapping, const glm::dvec3& p) {
    switch (mapping) {
        case ImageLook::Mapping::spherical:
            return {turn(p.x, p.z), .5 + std::asin(p.y / glm::length(p)) / pi};
        case ImageLook::Mapping::cylindrical:
            return {turn(p.x, p.z), p.y};
        case ImageLook::Mapping::toroidal: {
            const double aside = std::hypot(p.x, p.z) - 1;
            double around = std::acos(-aside / std::hypot(aside, p.y)) / (2 * pi);
            if (p.y > 0) around = 1 - around;
            return {turn(p.x, p.z), around};
        }
        case ImageLook::Mapping::planar:
        case ImageLook::Mapping::uv:
            break;
    }
    return {p.x, p.y};
}

double cubic_weight(double distance) {
    const double d = std::fabs(distance);
    if (d >= 2) return 0;
    return d < 1 ? 1 + d * d * (1.5 * d - 2.5) : 2 + d * (-4 + d * (2.5 - .5 * d));
}

}  // namespace

std::optional<glm::dvec3> image_colour(const ImageTexels& image, const ImageLook& look,
                                       const glm::dvec3& p, double gamma) {
    const double width = image.width, height = image.height;
    const glm::dvec2 square = on_unit_square(look.mapping, p);
    const bool unrolled = look.mapping == ImageLook::Mapping::spherical ||
                          look.mapping == ImageLook::Mapping::toroidal;
    if (look.once && !unrolled &&
        (square.y < 0 || square.y > 1 ||
         (look.mapping != ImageLook::Mapping::cylindrical && (square.x < 0 || square.x > 1))))
        return std::nullopt;
    // Rows go down, v goes up.
    const double x = (square.x - std::floor(square.x)) * width;
    double y = (-square.y - std::floor(-square.y)) * height;
    if (y >= height) y = 0;

    const auto texel = [&](double i, double j) {
        const auto place = [&](double k, double size) {
            k = look.once ? std::clamp(k, 0., size - 1) : k - std::floor(k / size) * size;
            return static_cast<std::size_t>(k);
        };
        const auto& t = image.texels[place(j, height) * image.width + place(i, width)];
        return glm::dvec3(glm::unpackHalf1x16(t[0]), glm::unpackHalf1x16(t[1]),
                          glm::unpackHalf1x16(t[2]));
    };
    glm::dvec3 colour{0};
    const double i0 = std::floor(x - .5), j0 = std::floor(y - .5);
    const double u = x - .5 - i0, v = y - .5 - j0;
    double sum = 0;
    const auto add = [&](double i, double j, double weight) {
        colour += weight * texel(i, j);
        sum += weight;
    };
    switch (look.interpolation) {
        case ImageLook::Interpolation::none:
            add(std::floor(x), std::floor(y), 1);
            break;
        case ImageLook::Interpolation::bilinear:
            for (const int i : {0, 1})
                for (const int j : {0, 1}) add(i0 + i, j0 + j, (i ? u : 1 - u) * (j ? v : 1 - v));
            break;
        case ImageLook::Interpolation::bicubic:
            for (int i = -1; i <= 2; ++i)
                for (int j = -1; j <= 2; ++j)
                    add(i0 + i, j0 + j, cubic_weight(i - u) * cubic_weight(j - v));
            break;
        case ImageLook::Interpolation::normalised_distance:
            for (const int i : {0, 1})
                for (const int j : {0, 1})
                    add(i0 + i, j0 + j, 1 / std::max((i - u) * (i - u) + (j - v) * (j - v), 1e-12));
            break;
    }
    for (int c = 0; c < 3; ++c)
        colour[c] = colour[c] > 0 ? std::pow(colour[c] / sum, gamma) : colour[c] / sum;
    return colour;
}

}  // namespace povpreview::test
